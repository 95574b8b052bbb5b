// Runs the state machines of many slaves at once: each frame has the datagrams of as many of them as fit.
#pragma once

#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/frame_traffic.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// Memory for the work on one slave of many. `Steps` is the state machine, which states how large its next request can
/// be: `request_size()` bytes and `request_datagrams()`. Frames of one without `lost` may be repeated.
template <class Steps> class parallel_place {
  public:
    /// Why the work on this slave has failed; ok if it is done.
    master_error error{};
    /// Whether the work on this slave is done, or has failed, or has not begun.
    [[nodiscard]] bool has_ended() const noexcept { return at_ == phase::ended; }

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
    /// The places stay until it is done. None has begun. `is_one_by_one`: each slave is done
    /// before the next one.
    explicit parallel_steps(std::span<Place> places, bool is_one_by_one = false) noexcept
        : places_{places}, is_one_by_one_{is_one_by_one} {
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
        for (auto& each : places_) each.datagrams_ = 0;
        for (; taken_ != places_.size(); ++taken_) {
            auto& each = nth(taken_);
            if (each.at_ != Place::phase::runs) continue;
            if (frame.room() < each.steps_.request_size() ||
                frame_traffic::max_datagrams - datagrams < each.steps_.request_datagrams() ||
                (is_one_by_one_ && datagrams != 0))
                return;
            each.steps_.request(frame);
            each.datagrams_ = frame.datagrams() - datagrams;
            datagrams = frame.datagrams();
        }
    }
    /// Calls `ended(place)` for each slave whose work has ended.
    template <class Ended>
    progress reply(replies datagrams, time_point now, const master_config& config, Ended&& ended) noexcept {
        auto last = progress::done;
        for (std::size_t i = 0; i != taken_; ++i) {
            auto& each = nth(i);
            if (each.datagrams_ == 0) continue;
            last = each.steps_.reply(datagrams.first(each.datagrams_), now, config);
            datagrams = datagrams.subspan(each.datagrams_);
            if (last == progress::wait && !is_one_by_one_) each.at_ = Place::phase::waits;
            if (last != progress::done) continue;
            each.at_ = Place::phase::ended;
            --running_;
            each.error = each.steps_.result().error();
            ended(each, each.steps_);
        }
        if (is_one_by_one_ && last != progress::done) return last; // another copy of the reply is for the same slave
        if (!places_.empty()) first_ = (first_ + taken_) % places_.size();
        if (is_done()) return progress::done;
        for (const auto& each : places_)
            if (each.at_ == Place::phase::runs) return progress::send;
        for (auto& each : places_)
            if (each.at_ == Place::phase::waits) each.at_ = Place::phase::runs;
        return progress::wait;
    }
    [[nodiscard]] bool was_refused() const noexcept {
        if constexpr (has_losses)
            return is_one_by_one_ && std::ranges::any_of(places_, [](const Place& each) {
                       return each.datagrams_ != 0 && each.steps_.was_refused();
                   });
        return false;
    }
    /// Whether the frame under way may be sent again at once.
    [[nodiscard]] bool is_repeatable() const noexcept {
        if constexpr (has_losses)
            return std::ranges::all_of(
                places_, [](const Place& each) { return each.datagrams_ == 0 || each.steps_.is_repeatable(); });
        return true;
    }
    void lost() noexcept {
        if constexpr (has_losses)
            for (auto& each : places_)
                if (each.datagrams_ != 0) each.steps_.lost();
    }
    /// Ends the work on all slaves that are not done with `why`.
    void cancel(const master_error& why) noexcept {
        for (auto& each : places_) {
            if (each.at_ == Place::phase::ended) continue;
            each.at_ = Place::phase::ended;
            each.error = why;
            if constexpr (has_losses) each.error = each.steps_.cancel(why);
        }
        running_ = 0;
    }

  private:
    static constexpr bool has_losses = requires(Place& each) { each.steps_.lost(); };

    [[nodiscard]] Place& nth(std::size_t i) noexcept { return places_[(first_ + i) % places_.size()]; }

    std::span<Place> places_{};
    bool is_one_by_one_{};
    std::size_t running_{};
    std::size_t first_{}; // whose turn it is
    std::size_t taken_{}; // from there on, the places that the frame under way has considered
};

} // namespace jauscat::ethercat
