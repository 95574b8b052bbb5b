// Every message of the standard behind functions that are the same for all, so that a test is a loop over them and is
// compiled once. What is compiled for each message stands in message_group.hpp.
#pragma once
#include "support/random_message.hpp"
#include <jauscat/catalogue/ra_3_3.hpp>
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/wire/diagnose.hpp>

#include <vector>

namespace messages {

namespace jaus = jauscat::jaus;
namespace wire = jauscat::wire;
using octets = std::vector<std::byte>;

/// A message that was encoded.
struct encoded {
    wire::errc error{};
    wire::diagnosis why{}; ///< what diagnose says of the value
    octets bytes{};
    bool decodes_to_itself{}; ///< what decode makes of the bytes equals the value
    bool is_put{};            ///< jaus::put sends these bytes, in packets where they are many
};

/// What is made of some bytes.
struct decoded {
    wire::errc error{};
    wire::errc raw_error{};      ///< of decoding into the raw message
    wire::errc view_error{};     ///< of the view's check
    wire::diagnosis why{};       ///< what diagnose says of the bytes
    octets again{};              ///< what the value encodes to; empty after an error
    octets raw_again{};          ///< the same for the raw message
    bool view_agrees{};          ///< the view shows all members as decode does
    wire::errc without_memory{}; ///< of decoding into lists without memory for one element
};

/// What decode and diagnose say of some bytes.
struct judged {
    wire::errc error{};
    wire::diagnosis why{};
};

/// What is compiled for the type of a message.
struct functions {
    std::uint16_t code{};
    std::size_t object_size{}; ///< sizeof
    bool has_lists{};          ///< decoding takes an arena
    encoded (*random)(support::generator&, const support::odds&){};
    decoded (*read)(std::span<const std::byte> body){}; ///< in each way
    judged (*judge)(std::span<const std::byte> body){};
};
/// One message of the standard.
struct message : jauscat::catalogue::entry, functions {};

/// What a typed handler was called with.
struct handled {
    std::uint16_t code{}; ///< of the handler's message
    jaus::header header{};
    octets body{}; ///< what the message encodes to
};

/// The messages whose codes have the same third hexadecimal digit: a subgroup of the standard.
struct group {
    std::span<const functions> all{};
    /// A dispatcher with a handler for each of them.
    jaus::dispatched (*dispatch)(const jaus::header&, std::span<const std::byte> body, std::vector<handled>&){};
};
template <unsigned Digit> const group& group_of();

/// All of them.
const std::array<const group*, 10>& groups();
std::vector<message> all();

} // namespace messages
