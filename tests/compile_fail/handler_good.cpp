// expect: no error
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/schema/jaus/core.hpp>

namespace jaus = jauscat::jaus;

jaus::dispatcher own{
    jaus::on<jaus::standby>([](const jaus::header&, const jaus::standby&) {}),
    jaus::on_unknown([](const jaus::header&, std::span<const std::byte>) {}),
    jaus::on_malformed([](const jaus::header&, std::span<const std::byte>, jauscat::wire::errc) {}),
    jaus::on_acknowledgement([](const jaus::header&) {}),
};
