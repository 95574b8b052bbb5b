// Large data sets on their way out, paced so that neither buffers nor a peer's rate limit overflow.
#pragma once

#include <jauscat/jaus/large_data_sender.hpp>

#include <array>
#include <chrono>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

namespace jauscat::net::detail {

/// Copies of bodies, sent one after the other, for packets carry nothing that names their data set: `pace` packets each
/// millisecond, and a pause between two.
class large_data_queue {
  public:
    using time = std::chrono::nanoseconds;

    large_data_queue(std::size_t most, unsigned pace) : most_{most}, pace_{pace == 0 ? 1 : pace} {}

    /// ok, no_space where `most` bytes wait, or what large_data_sender says.
    jaus::errc push(const jaus::header& head, std::span<const std::byte> body) {
        if (body.size() > most_ - waiting_) return jaus::errc::no_space;
        auto made = std::make_unique<entry>(head, body);
        if (made->sender.error() != jaus::errc::ok) return made->sender.error();
        waiting_ += body.size();
        sets_.push_back(std::move(made));
        return jaus::errc::ok;
    }
    void on_time(time now, jaus::message_sink out) {
        if (sets_.empty() || now < next_) return;
        auto& first = *sets_.front();
        for (unsigned i = 0; i != pace_ && first.sender.next(out); ++i) {}
        next_ = now + std::chrono::milliseconds{1};
        if (first.sender.sent() != first.sender.packets()) return;
        waiting_ -= first.body.size();
        sets_.pop_front();
        next_ = now + std::chrono::milliseconds{5};
    }
    [[nodiscard]] std::optional<time> next_event() const noexcept {
        return sets_.empty() ? std::nullopt : std::optional{next_};
    }
    /// How many data sets are not yet sent.
    [[nodiscard]] std::size_t size() const noexcept { return sets_.size(); }
    void clear() noexcept {
        sets_.clear();
        waiting_ = 0;
    }

  private:
    struct entry {
        entry(const jaus::header& head, std::span<const std::byte> bytes)
            : body(bytes.begin(), bytes.end()), sender{head, body, packet} {}
        std::vector<std::byte> body;
        std::array<std::byte, jaus::header_size + jaus::max_body_size> packet{};
        jaus::large_data_sender sender;
    };
    std::size_t most_;
    unsigned pace_;
    std::size_t waiting_{};
    time next_{};
    std::deque<std::unique_ptr<entry>> sets_{};
};

} // namespace jauscat::net::detail
