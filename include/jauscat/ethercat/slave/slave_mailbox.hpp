// The mailbox of an emulated slave: requests, responses, repetition of lost messages.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/slave/coe_options.hpp>
#include <jauscat/ethercat/slave/coe_server.hpp>
#include <jauscat/ethercat/slave/esc_memory.hpp>
#include <jauscat/ethercat/slave/slave_description.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/coe.hpp>
#include <jauscat/schema/ethercat/mailbox.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// SyncManagers 0 and 1, and the CoE server behind them. Of a slave without a mailbox: nothing is expected of them.
class slave_mailbox {
  public:
    /// Of the slave's mailbox areas, with a server of these objects behind them.
    JAUSCAT_FUNCTION slave_mailbox(const slave_description& description, object_dictionary objects,
                                   const coe_options& options) noexcept;

    /// As after power-on.
    JAUSCAT_FUNCTION void power_on(esc_memory& memory) noexcept;
    /// The slave enters or leaves INIT: messages and transfers are gone.
    JAUSCAT_FUNCTION void forget(esc_memory& memory) noexcept;
    void set_state(al_state state) noexcept { coe_.set_state(state); }

    /// The SyncManagers equal the description.
    [[nodiscard]] JAUSCAT_FUNCTION bool is_configured(esc_memory& memory) const noexcept;

    /// The next message that a master reads. False without a mailbox, and while `max_emergencies` wait.
    [[nodiscard]] JAUSCAT_FUNCTION bool send_emergency(const coe_emergency& what) noexcept;
    static constexpr std::size_t max_emergencies = 4;

    /// A frame has passed, and the slave is not in INIT.
    JAUSCAT_FUNCTION void work(esc_memory& memory) noexcept;

  private:
    [[nodiscard]] bool has_mailbox() const noexcept { return out_size_ != 0 || in_size_ != 0; }

    // The last read message is still in the memory, unless the answer has continued since: then it was stored, and the
    // memory's message, which was not read, follows it.
    JAUSCAT_FUNCTION void repeat(esc_memory& memory, const sync_manager& in) noexcept;
    JAUSCAT_FUNCTION void exchange(esc_memory& memory, const sync_manager& in) noexcept;

    JAUSCAT_FUNCTION void answer(esc_memory& memory, std::span<const std::byte> request,
                                 std::span<std::byte> reply) noexcept;

    JAUSCAT_FUNCTION void go_on(esc_memory& memory, std::span<std::byte> reply) noexcept;
    JAUSCAT_FUNCTION void put_emergency(esc_memory& memory, std::span<std::byte> reply) noexcept;
    // A message without a request: `put_content(room)` returns its size. The one before it may have to be repeated.
    void put_next(esc_memory& memory, std::span<std::byte> reply, auto&& put_content) noexcept;

    JAUSCAT_FUNCTION void put(esc_memory& memory, mailbox_header header, std::size_t size,
                              std::span<std::byte> reply) noexcept;

    // 1 to 7; 0 remains 0: a master that does not count gets no counter.
    static constexpr std::uint8_t after(std::uint8_t counter) noexcept {
        return static_cast<std::uint8_t>(counter == 0 ? 0 : counter % 7 + 1);
    }

    std::uint16_t out_start_, out_size_, in_start_, in_size_;
    std::uint32_t delay_;
    coe_server coe_;
    std::uint8_t last_counter_{}; // of requests
    std::uint8_t sent_counter_{};
    bool replied_{}; // the memory of the reply mailbox holds a message of ours
    bool waiting_{}; // with a request, for frames to pass
    std::uint32_t waited_{};
    bool continued_{};  // `before_` is the part of the answer before the one in the memory
    bool going_back_{}; // ... and they have changed places
    std::array<std::byte, max_mailbox_size> before_{};
    std::array<coe_emergency, max_emergencies> emergencies_{};
    std::size_t waiting_emergencies_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/slave/impl/slave_mailbox.ipp>
#endif
