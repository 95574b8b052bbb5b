// What the sources of the standard's messages have in common. Its classes of codes are a source each: all at once takes
// the compiler half a minute and a gigabyte.
#pragma once
#include <jauscat/catalogue/of.hpp>
#include <jauscat/schema/jaus/messages.hpp>

namespace jauscat::catalogue {

list commands();
list queries();
list informs();

/// The messages with codes from `First` to `Last`.
template <std::uint16_t First, std::uint16_t Last, class... Messages> list part(jaus::message_list<Messages...>) {
    std::vector<entry> made;
    const auto add = [&]<class Message>() {
        constexpr std::uint16_t code = jaus::command_code_of<Message>;
        if constexpr (code >= First && code <= Last) made.emplace_back(detail::data_of<Message>);
    };
    (add.template operator()<Messages>(), ...);
    return list{std::move(made)};
}

} // namespace jauscat::catalogue
