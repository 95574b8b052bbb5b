// Message types, for code that is the same for each of them.
#pragma once

namespace jauscat::jaus {

/// A list of message types.
template <class... Messages> struct message_list {};

} // namespace jauscat::jaus
