// What happened, kept as numbers; lines of text are made only of what somebody reads.
#pragma once

#include "simulation/faults.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace simulation {

/// Kinds of happenings. The comment says what `code`, `number` and `value` are where they are used.
enum class deed : std::uint8_t {
    starts,             ///< number: which life of the process it is
    goes_mute,          ///< its component, while its node goes on
    dies,               //
    freezes,            ///< value: milliseconds
    goes_on,            //
    clock_leaps,        ///< value: milliseconds
    sends,              ///< code, sequence number, message
    gets,               ///< code, sequence number, message, value: the motion command in it
    loses,              ///< the network; code, sequence number, message
    doubles,            ///< the network
    delays,             ///< the network; value: milliseconds
    parts,              ///< the network, `whom` from `value`
    joins,              //
    acknowledges,       ///< code, sequence number, message
    refuses,            ///< with NAK
    queues,             ///< keeps it, to execute it later; code, sequence number, message
    merges,             ///< with the one before, which its slave has not executed; the same, value: the motion command
    drops,              ///< does not execute it; code, sequence number, message, value: the motion command in it, why
    hears_acknowledged, ///< code, sequence number
    hears_refused,      //
    hears_nothing,      ///< gave up
    executes,           ///< code, sequence number, message, value: the command
    rests,              ///< efforts go to zero
    enters_state,       ///< number: from, value: to
    controlled_by,      ///< whom, 0: nobody
    control,            ///< of the asking side; value: the control_state
    delivers_large,     ///< value: its identity, number: kilobytes
    sends_large,        //
    owes_stop,          ///< a component requires a stop of its slaves; number: stop_order, why
    stop_refused,       ///< by its slave; number: stop_order, value: attempts
    settled,            ///< its slaves have confirmed all stop orders
    uses_slave,         ///< the bridge, `whom`
    loses_slave,        ///< the bridge, `whom`, why
    gives_up,           ///< the node no longer hears somebody; value: the address
    hears_of,           ///< the node hears somebody new; value: the address
    connects,           ///< a consumer, to the reports of `whom`; value: consumed_state
    ignores_report,     ///< a consumer, of `whom`; number: its sequence number
    begins_transfer,    ///< its own, to `whom`; number: subindex, value: which one, why: reads or writes
    ends_transfer,      ///< value: which one, why: how
    is_ended,           ///< is told to end (SIGTERM)
    person,             ///< ends the emergency at the machine
    ring,               ///< something of EtherCAT; number: which (ring_deed), value
};

/// 40 bytes for each.
struct happening {
    time at{};
    deed what{};
    std::uint8_t who{};
    std::uint8_t whom{};
    std::uint16_t code{};
    std::uint16_t number{};
    std::uint32_t message{}; ///< the world's number for it, the same for all its copies; 0: has none
    std::uint32_t value{};
    const char* why{}; ///< a literal, of the cause
};

/// One line without the time.
std::string text_of(const happening& one, const std::vector<std::string>& names);
/// The same for `deed::ring`.
std::string ring_text(const happening& one, const std::vector<std::string>& names);

/// The same with the time.
std::string line_of(const happening& one, const std::vector<std::string>& names);
std::string line_of(time at, const char* what, std::span<const std::byte> content);

/// The last happenings, and a digest of all, and of all that was sent.
class story {
  public:
    void tell(const happening& one) noexcept {
        last_[told_++ % last_.size()] = one;
        mix(static_cast<std::uint64_t>(one.at.count()));
        mix(std::uint64_t{static_cast<std::uint8_t>(one.what)} << 48U | std::uint64_t{one.who} << 40U |
            std::uint64_t{one.whom} << 32U | std::uint64_t{one.code} << 16U | one.number);
        mix(std::uint64_t{one.message} << 32U | one.value);
        if (one.why != nullptr) mix(std::as_bytes(std::span{std::string_view{one.why}}));
    }
    void mix(time at, std::string_view what, std::span<const std::byte> content) noexcept {
        mix(static_cast<std::uint64_t>(at.count()));
        mix(std::as_bytes(std::span{what}));
        mix(content);
    }
    [[nodiscard]] std::uint64_t digest() const noexcept { return digest_; }
    [[nodiscard]] std::vector<happening> last() const {
        std::vector<happening> all;
        const std::uint64_t first = told_ > last_.size() ? told_ - last_.size() : 0;
        for (auto i = first; i != told_; ++i) all.push_back(last_[i % last_.size()]);
        return all;
    }

  private:
    void mix(std::uint64_t value) noexcept {
        digest_ = (digest_ ^ value) * 0x9FB21C651E98DF25;
        digest_ ^= digest_ >> 32U;
    }
    void mix(std::span<const std::byte> content) noexcept {
        mix(content.size());
        for (; !content.empty(); content = content.subspan(std::min<std::size_t>(content.size(), 8))) {
            std::uint64_t word{};
            std::memcpy(&word, content.data(), std::min<std::size_t>(content.size(), 8));
            mix(word);
        }
    }
    std::vector<happening> last_ = std::vector<happening>(std::size_t{1} << 15U);
    std::uint64_t told_{};
    std::uint64_t digest_{};
};

} // namespace simulation
