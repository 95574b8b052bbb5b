// expect: the message has no command code: add it to its jauscat::wire::schema, as command_code
#include "small_message.hpp"
#include <jauscat/jaus/message/message.hpp>

template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type =
        layout<field<&T::number, u16le>, field<&T::level, scaled<u8, percent>>, presence<u8, field<&T::extra, u8>>>;
};

std::array<std::byte, 64> out{};
const auto size = jauscat::jaus::make_message(jauscat::jaus::header{}, small_message{}, out);
