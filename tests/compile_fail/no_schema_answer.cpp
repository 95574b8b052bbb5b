// expect: the type has no schema: specialise jauscat::wire::schema for it, with its layout as type
#include "small_message.hpp"
#include <jauscat/jaus/component/answer.hpp>

const auto sent = jauscat::jaus::answer(jauscat::jaus::header{}, jauscat::jaus::address{}, small_message{},
                                        [](std::span<const std::byte>) {});
