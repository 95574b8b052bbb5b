// expect: the type has no schema: give it a struct schema with its layout as type, or specialise jauscat::wire::schema
// for it
#include "small_message.hpp"
#include <jauscat/jaus/component/answer.hpp>

const auto sent = jauscat::jaus::answer(jauscat::jaus::header{}, jauscat::jaus::address{}, small_message{},
                                        [](std::span<const std::byte>) {});
