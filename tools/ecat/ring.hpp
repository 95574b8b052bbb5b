// Access to the slaves of a ring: by position, so that station addresses stay as they are.
#pragma once
#include "ecat/failure.hpp"
#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/net/link/any_link.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/datagram.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ecat {

namespace ethercat = jauscat::ethercat;
using bytes = std::vector<std::byte>;

struct ring_options {
    std::string link{};                            ///< network interface, or udp:HOST[:PORT]
    std::chrono::milliseconds frame_timeout{20};   ///< after which a frame is lost
    unsigned retries{9};                           ///< of one frame
    std::chrono::milliseconds state_timeout{5000}; ///< of a change of state
    bool force{};                                  ///< also while another master seems to use the bus
};

/// A datagram to send; after the exchange what has returned.
struct datagram {
    ethercat::command cmd{};
    std::uint16_t adp{};
    std::uint16_t ado{};
    bytes data{};
    std::uint16_t working_counter{};
};

/// ADP of a position.
[[nodiscard]] constexpr std::uint16_t position_address(std::uint16_t position) noexcept {
    return static_cast<std::uint16_t>(-position);
}
[[nodiscard]] inline datagram read_of(std::uint16_t position, std::uint16_t address, std::size_t size) {
    return {ethercat::command::aprd, position_address(position), address, bytes(size)};
}
template <class T> [[nodiscard]] T decoded(std::span<const std::byte> data) {
    T made{};
    static_cast<void>(jauscat::wire::decode_prefix(made, data));
    return made;
}
template <class T> [[nodiscard]] bytes encoded(const T& message) {
    bytes made(jauscat::wire::max_size<T>);
    static_cast<void>(jauscat::wire::encode(message, made));
    return made;
}

/// What the guard reads of each slave.
struct slave_state {
    std::uint16_t station{};
    std::uint16_t alias{};
    ethercat::al_status al{};
};

/// `PRE-OP`; with `ERROR` behind it where the slave indicates one.
[[nodiscard]] std::string state_name(ethercat::al_state state);
[[nodiscard]] std::string state_text(const ethercat::al_status& al);
/// `0x001B: SyncManager watchdog`; empty without a code.
[[nodiscard]] std::string al_code_text(const ethercat::al_status& al);

class ring {
  public:
    /// Opens the link; throws `failure`.
    explicit ring(const ring_options& options);

    /// Ends with `bus_in_use` if another master seems to run, unless forced. Reads the slaves' states.
    void guard();
    [[nodiscard]] std::uint16_t slaves() const noexcept { return static_cast<std::uint16_t>(states_.size()); }
    /// As the guard has found them.
    [[nodiscard]] const std::vector<slave_state>& states() const noexcept { return states_; }

    /// Sends one frame and waits for its return, with retries. Throws `failure` without a return.
    void exchange(std::span<datagram> all);
    /// The same without retries. False if it has not returned within the limit.
    [[nodiscard]] bool try_exchange(std::span<datagram> all, std::chrono::nanoseconds limit);
    /// One frame that was built for a station address, sent to `position` instead; `frame` becomes its return.
    [[nodiscard]] bool try_exchange_at(std::uint16_t position, std::span<std::byte> frame, std::size_t& size,
                                       std::chrono::nanoseconds limit);

    /// Registers of a slave; throws `failure` if the slave does not answer.
    [[nodiscard]] bytes read(std::uint16_t position, std::uint16_t address, std::size_t size);
    void write(std::uint16_t position, std::uint16_t address, const bytes& data);
    template <class Register> [[nodiscard]] typename Register::value_type read(std::uint16_t position, Register at) {
        return decoded<typename Register::value_type>(
            read(position, at.address, jauscat::wire::max_size<typename Register::value_type>));
    }
    template <class Register> void write(std::uint16_t position, Register at, const typename Register::value_type& v) {
        write(position, at.address, encoded(v));
    }

    /// Whether outputs of the slave are set up, by its SyncManagers.
    [[nodiscard]] bool has_outputs(std::uint16_t position);

    /// Requests a state and waits for it; an error is acknowledged. Throws `failure` with the slave's reason.
    void change_state(std::uint16_t position, ethercat::al_state goal);

    [[nodiscard]] jauscat::net::any_link& link() noexcept { return *link_; }
    [[nodiscard]] const ring_options& options() const noexcept { return options_; }
    /// "slave 3 on eth0".
    [[nodiscard]] std::string name_of(std::uint16_t position) const;

    std::uint64_t sent{}, lost{}, foreign{}; ///< frames

  private:
    [[nodiscard]] bool send_and_wait(std::span<const std::byte> out, std::span<std::byte> in, std::size_t& size,
                                     std::chrono::nanoseconds limit);
    [[noreturn]] void no_return() const;
    /// The status when it `is_it`, or after the time for a change of state.
    ethercat::al_status wait_for_state(std::uint16_t position,
                                       const std::function<bool(const ethercat::al_status&)>& is_it);
    void listen();
    void read_states();
    /// Whether the mailboxes of the slaves are in use.
    [[nodiscard]] bool mailboxes_move();
    [[noreturn]] void refuse(const std::string& why) const;

    ring_options options_;
    std::unique_ptr<jauscat::net::any_link> link_;
    std::vector<slave_state> states_{};
    std::uint8_t index_{};
    std::string problem_{}; ///< of the link, when the last frame was lost
};

/// Ctrl-C ends the wait.
void sleep_until(jauscat::time_point due);
/// A line on standard error that is no error.
void note(std::string_view text);
/// Shows the progress of long work on a terminal; the line goes away at its end.
class progress_line {
  public:
    progress_line() = default;
    progress_line(const progress_line&) = delete;
    progress_line& operator=(const progress_line&) = delete;
    ~progress_line();
    void show(const std::string& text);

  private:
    std::chrono::steady_clock::time_point last_{};
    bool is_shown_{};
};

} // namespace ecat
