// expect: code_index: a code is listed twice
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/schema/jaus/core.hpp>

namespace jaus = jauscat::jaus;

void dispatch(const jaus::header& head, std::span<const std::byte> body) {
    jaus::dispatcher both{jaus::on<jaus::set_emergency>([](const auto&, const auto&) {}),
                          jaus::on<jaus::set_emergency>([](const auto&, const auto&) {})};
    both(head, body);
}
