#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/schema/jaus/core.hpp>

namespace jaus = jauscat::jaus;

#ifdef GOOD
// expect: no error
jaus::dispatcher own{
    jaus::on<jaus::standby>([](const jaus::header&, const jaus::standby&) {}),
    jaus::on_unknown([](const jaus::header&, std::span<const std::byte>) {}),
    jaus::on_malformed([](const jaus::header&, std::span<const std::byte>, jauscat::wire::errc) {}),
    jaus::on_acknowledgement([](const jaus::header&) {}),
};
#endif

#ifdef DISPATCHER_TWO_HANDLERS_OF_ONE_MESSAGE
// expect: code_index: a code is listed twice
void dispatch(const jaus::header& head, std::span<const std::byte> body) {
    jaus::dispatcher both{jaus::on<jaus::set_emergency>([](const auto&, const auto&) {}),
                          jaus::on<jaus::set_emergency>([](const auto&, const auto&) {})};
    both(head, body);
}
#endif

#ifdef OF_ACKNOWLEDGEMENT_PARAMETERS
// expect: on_acknowledgement: the handler cannot be called with (const header&)
jaus::dispatcher own{jaus::on_acknowledgement([](std::uint16_t) {})};
#endif

#ifdef OF_ANOTHER_MESSAGE
// expect: on: the handler of a message cannot be called with (const header&, const T&)
jaus::dispatcher own{jaus::on<jaus::standby>([](const jaus::header&, const jaus::resume&) {})};
#endif

#ifdef OF_MALFORMED_PARAMETERS
// expect: on_malformed: the handler cannot be called with (const header&, std::span<const std::byte>, wire::errc)
jaus::dispatcher own{jaus::on_malformed([](const jaus::header&, std::span<const std::byte>) {})};
#endif

#ifdef OF_NO_KIND
// expect: dispatcher: a handler is made by none of on, on_unknown, on_malformed and on_acknowledgement
jaus::dispatcher own{[](const jaus::header&, std::span<const std::byte>) {}};
#endif

#ifdef OF_UNKNOWN_PARAMETERS
// expect: on_unknown: the handler cannot be called with (const header&, std::span<const std::byte>)
jaus::dispatcher own{jaus::on_unknown([](const jaus::header&) {})};
#endif

#ifdef PARAMETERS
// expect: on: the handler of a message cannot be called with (const header&, const T&)
jaus::dispatcher own{jaus::on<jaus::standby>([](const jaus::standby&) {})};
#endif

#ifdef RESULT
// expect: on: the handler of a message returns something, which would be ignored
jaus::dispatcher own{jaus::on<jaus::standby>([](const auto&, const auto&) { return jaus::message_outcome::refused; })};
#endif
