// Runs the state machines of many slaves at once: each frame has the datagrams of as many of them as fit.
#pragma once

#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/frame_traffic.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// Memory for the work on one slave of many. `Steps` is the state machine, which may repeat each of its frames and
/// states its largest request: `max_request_size` bytes and `max_request_datagrams`.
template <class Steps> class parallel_place {
  public:
    /// Why the work on this slave has failed; ok if it is done.
    master_error error{};

  private:
    template <class Place> friend class parallel_steps;
    enum class phase : std::uint8_t { runs, waits, ended };

    Steps steps_{};
    phase at_ = phase::ended;
    std::size_t datagrams_{}; // in the frame that is under way
};

/// State machine over places that are derived from parallel_place. An error ends the work on its slave only.
template <class Place> class parallel_steps {
  public:
    parallel_steps() noexcept = default;
    /// The places stay until it is done. None has begun.
    explicit parallel_steps(std::span<Place> places) noexcept : places_{places} {
        for (auto& each : places_) each.at_ = Place::phase::ended;
    }

    template <class Steps> void begin(Place& place, const Steps& steps) noexcept {
        place.error = {};
        place.steps_ = steps;
        place.at_ = Place::phase::runs;
        ++running_;
    }
    [[nodiscard]] bool is_done() const noexcept { return running_ == 0; }

    /// Starts with the slave whose turn it is, so that each frame continues where the last one has ended.
    void request(frame_builder& frame) noexcept {
        std::size_t datagrams = 0;
        taken_ = 0;
        for (; taken_ != places_.size(); ++taken_) {
            auto& each = nth(taken_);
            each.datagrams_ = 0;
            if (each.at_ != Place::phase::runs) continue;
            using steps = decltype(each.steps_);
            if (frame.room() < steps::max_request_size ||
                frame_traffic::max_datagrams - datagrams < steps::max_request_datagrams)
                return;
            each.steps_.request(frame);
            each.datagrams_ = frame.datagrams() - datagrams;
            datagrams = frame.datagrams();
        }
    }
    /// Calls `ended(place)` for each slave whose work has ended.
    template <class Ended>
    progress reply(replies datagrams, time_point now, const master_config& config, Ended&& ended) noexcept {
        for (std::size_t i = 0; i != taken_; ++i) {
            auto& each = nth(i);
            if (each.datagrams_ == 0) continue;
            const auto next = each.steps_.reply(datagrams.first(each.datagrams_), now, config);
            datagrams = datagrams.subspan(each.datagrams_);
            if (next == progress::wait) each.at_ = Place::phase::waits;
            if (next != progress::done) continue;
            each.at_ = Place::phase::ended;
            --running_;
            each.error = each.steps_.result().error();
            ended(each, each.steps_);
        }
        if (!places_.empty()) first_ = (first_ + taken_) % places_.size();
        if (is_done()) return progress::done;
        for (const auto& each : places_)
            if (each.at_ == Place::phase::runs) return progress::send;
        for (auto& each : places_)
            if (each.at_ == Place::phase::waits) each.at_ = Place::phase::runs;
        return progress::wait;
    }
    /// Ends the work on all slaves that are not done with `why`.
    void cancel(const master_error& why) noexcept {
        for (auto& each : places_) {
            if (each.at_ == Place::phase::ended) continue;
            each.at_ = Place::phase::ended;
            each.error = why;
        }
        running_ = 0;
    }

  private:
    [[nodiscard]] Place& nth(std::size_t i) noexcept { return places_[(first_ + i) % places_.size()]; }

    std::span<Place> places_{};
    std::size_t running_{};
    std::size_t first_{}; // whose turn it is
    std::size_t taken_{}; // from there on, the places that the frame under way has considered
};

} // namespace jauscat::ethercat
