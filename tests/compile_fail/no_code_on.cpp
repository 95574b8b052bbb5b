// expect: the message has no command code: add it to its jauscat::wire::schema, as command_code
#include "small_message.hpp"
#include <jauscat/jaus/component/dispatcher.hpp>

template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type =
        layout<field<&T::number, u16le>, field<&T::level, scaled<u8, percent>>, presence<u8, field<&T::extra, u8>>>;
};

auto handler = jauscat::jaus::on<small_message>([](const jauscat::jaus::header&, const small_message&) {});
