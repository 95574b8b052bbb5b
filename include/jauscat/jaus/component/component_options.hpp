// Options and memory of a component.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/acknowledged_receiver.hpp>
#include <jauscat/jaus/component/acknowledged_sender.hpp>
#include <jauscat/jaus/component/component_control.hpp>
#include <jauscat/jaus/component/component_state.hpp>

namespace jauscat::jaus {

struct component_options {
    after_emergency after{};                   ///< where an emergency ends
    control_options control{};                 ///< authority, harmless codes, timeout
    acknowledgement_options acknowledgement{}; ///< of messages that it sends
    /// How long acknowledged messages are remembered; see acknowledged_receiver.
    duration memory{std::chrono::seconds{2}};
    /// Refuses motion commands unless Ready; see command_rules.
    bool obeys_only_when_ready{true};
};

/// The memory of a component, which must outlive it: `Waiting` messages at a time that it sent and that are not yet
/// acknowledged, of `Size` bytes at most; `Remembered` ones that it acknowledged, half of them of one source: with the
/// default memory of two seconds, one source may send 128 a second with acknowledgement request.
///
/// For more, `Remembered` is twice that rate times component_options::memory: a thousand a second that are remembered
/// for two seconds are 4000 places of 24 bytes. All of them are looked at for each message that asks for an
/// acknowledgement (some microseconds), so where the rate is high a shorter memory helps: it only has to outlast what
/// the sender repeats, `retry.total()`. `Waiting` is the rate times `retry.interval`, more on a bad network.
template <std::size_t Waiting = 16, std::size_t Size = 256, std::size_t Remembered = 512> struct component_memory {
    std::array<awaited_message, Waiting> waiting{};            ///< messages that wait for an acknowledgement
    std::array<std::byte, Waiting * Size> copies{};            ///< these messages
    std::array<acknowledged_message, Remembered> remembered{}; ///< messages that were acknowledged
};

/// The same of any size, which must outlive the component.
struct component_places {
    std::span<awaited_message> waiting{};
    std::span<std::byte> copies{};
    std::span<acknowledged_message> remembered{};
};

} // namespace jauscat::jaus
