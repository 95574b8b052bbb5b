// expect: the message has no command code: add it to its jauscat::wire::schema, as command_code
#include "small_message.hpp"
#include <jauscat/jaus/component/component.hpp>

template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type =
        layout<field<&T::number, u16le>, field<&T::level, scaled<u8, percent>>, presence<u8, field<&T::extra, u8>>>;
};

jauscat::jaus::send_result send(jauscat::jaus::component<>& own, jauscat::jaus::message_sink out) {
    return own.send(jauscat::jaus::header{}, small_message{}, jauscat::time_point{}, out);
}
