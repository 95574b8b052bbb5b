// Large data sets on their way out, paced so that neither buffers nor a peer's rate limit overflow.
#pragma once

#include <jauscat/jaus/acknowledged_sender.hpp>
#include <jauscat/jaus/large_data_sender.hpp>
#include <jauscat/jaus/later.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace jauscat::net::detail {

/// Copies of bodies, sent one after the other, for packets carry nothing that names their data set: `pace` packets each
/// millisecond, and a pause between two data sets.
///
/// Of a data set that asks for acknowledgement each packet is repeated until its ACK is there. The first goes alone and
/// so does the last: then the receiver knows the data set before anything of it is repeated, and what may come twice
/// when it is whole is the last packet alone, which reassembler tells from the next data set.
class large_data_queue {
  public:
    using time = std::chrono::nanoseconds;
    /// Hears once of each data set that asked for acknowledgement.
    using done_handler = std::function<void(const jaus::header&, jaus::delivered)>;

    large_data_queue(std::size_t most, unsigned pace, const jaus::acknowledgement_options& acknowledgement)
        : most_{most}, pace_{pace == 0 ? 1 : pace}, acknowledgement_{acknowledgement} {}

    /// ok, no_space where `most` bytes wait, or what large_data_sender says.
    jaus::errc push(const jaus::header& head, std::span<const std::byte> body) {
        if (body.size() > most_ - waiting_) return jaus::errc::no_space;
        auto made = std::make_unique<entry>(head, body);
        if (made->sender.error() != jaus::errc::ok) return made->sender.error();
        if (head.ack_nak == jaus::ack_nak::request && jaus::names_one_component(head.destination))
            made->packets.resize(made->sender.packets());
        waiting_ += body.size();
        sets_.push_back(std::move(made));
        return jaus::errc::ok;
    }
    void on_time(time now, jaus::message_sink out, const done_handler& done) {
        if (sets_.empty() || now < next_) return;
        auto& first = *sets_.front();
        next_ = now + beat;
        if (first.packets.empty()) {
            for (unsigned i = 0; i != pace_ && first.sender.next(out); ++i) {}
            if (first.sender.sent() == first.sender.packets()) end(now);
            return;
        }
        if (!first.outcome && !send_acknowledged(first, now, out)) first.outcome = jaus::delivered::timed_out;
        if (!first.outcome) return;
        const auto [head, what] = std::pair{first.head, *first.outcome};
        end(now);
        if (done) done(head, what);
    }
    /// True: it was the ACK or NAK of a packet that was sent, or came late.
    bool on_acknowledgement(const jaus::header& head, time now) {
        if (sets_.empty() || sets_.front()->packets.empty()) return false;
        auto& first = *sets_.front();
        if (head.command_code != first.head.command_code || head.source != first.head.destination ||
            head.destination != first.head.source || head.sequence_number >= first.packets.size())
            return false;
        auto& packet = first.packets[head.sequence_number];
        if (packet.sent == 0) return false;
        if (first.outcome) return true;
        if (head.ack_nak == jaus::ack_nak::nak)
            first.outcome = jaus::delivered::refused;
        else if (!std::exchange(packet.acknowledged, true) && ++first.acknowledged == first.packets.size())
            first.outcome = jaus::delivered::acknowledged;
        next_ = std::min(next_, now + beat); // more may be sent, or it is at its end
        return true;
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
    static constexpr time beat = std::chrono::milliseconds{1};
    static constexpr time pause = std::chrono::milliseconds{5}; ///< longer than reassembly_limits::linger

    struct sent_packet {
        time due{};      ///< when it is sent again
        unsigned sent{}; ///< how often
        bool acknowledged{};
    };
    struct entry {
        entry(const jaus::header& h, std::span<const std::byte> bytes)
            : head{h}, body(bytes.begin(), bytes.end()), sender{head, body, packet} {}
        jaus::header head;
        std::vector<std::byte> body;
        std::array<std::byte, jaus::header_size + jaus::max_body_size> packet{};
        jaus::large_data_sender sender;
        std::vector<sent_packet> packets{}; ///< none where no acknowledgement is asked for
        std::size_t acknowledged{};         ///< of them
        std::size_t first_open{};           ///< those before it are acknowledged
        std::optional<jaus::delivered> outcome{};
    };

    /// False when a packet has been sent often enough.
    bool send_acknowledged(entry& set, time now, jaus::message_sink out) {
        const auto last = set.packets.size() - 1;
        while (set.first_open != last && set.packets[set.first_open].acknowledged) ++set.first_open;
        const auto behind = set.first_open == 0 ? std::size_t{1} : set.first_open == last ? last + 1 : last;
        unsigned left = pace_;
        next_ = jaus::later(now, acknowledgement_.timeout);
        for (auto i = set.first_open; i != behind; ++i) {
            auto& packet = set.packets[i];
            if (packet.acknowledged) continue;
            if (packet.sent == 0 || packet.due <= now) {
                if (left == 0) {
                    next_ = now + beat;
                    break;
                }
                if (packet.sent > acknowledgement_.retries) return false;
                --left;
                // The first is sent as the first each time: until it is acknowledged it may be all that there is.
                if (i == 0) set.sender.restart();
                if (packet.sent == 0 || i == 0)
                    set.sender.next(out);
                else
                    set.sender.repeat(i, out);
                ++packet.sent;
                packet.due = jaus::later(now, acknowledgement_.timeout);
            }
            next_ = std::min(next_, packet.due);
        }
        return true;
    }
    /// The first data set is through. Where packets were repeated, acknowledgements of both copies may still come: not
    /// while the next one waits for such.
    void end(time now) {
        const bool repeated = std::ranges::any_of(sets_.front()->packets, [](const auto& p) { return p.sent > 1; });
        waiting_ -= sets_.front()->body.size();
        sets_.pop_front();
        next_ = now + (repeated ? acknowledgement_.timeout : pause);
    }

    std::size_t most_;
    unsigned pace_;
    jaus::acknowledgement_options acknowledgement_;
    std::size_t waiting_{};
    time next_{};
    std::deque<std::unique_ptr<entry>> sets_{};
};

} // namespace jauscat::net::detail
