// expect: the message has no command code: add it to its jauscat::wire::schema, as command_code
#include "small_message.hpp"
#include <jauscat/jaus/component/answer.hpp>

template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type =
        layout<field<&T::number, u16le>, field<&T::level, scaled<u8, percent>>, presence<u8, field<&T::extra, u8>>>;
};

const auto sent = jauscat::jaus::answer(jauscat::jaus::header{}, jauscat::jaus::address{}, small_message{},
                                        [](std::span<const std::byte>) {});
