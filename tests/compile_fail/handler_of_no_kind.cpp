// expect: dispatcher: a handler is made by none of on, on_unknown, on_malformed and on_acknowledgement
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/schema/jaus/core.hpp>

namespace jaus = jauscat::jaus;

jaus::dispatcher own{[](const jaus::header&, std::span<const std::byte>) {}};
