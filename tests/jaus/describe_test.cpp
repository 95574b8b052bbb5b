// The texts of results and errors, for logs.
#include "support/catch.hpp"
#include <jauscat/jaus/component/acknowledged_sender.hpp>
#include <jauscat/jaus/large_data/reassembler.hpp>
#include <jauscat/jaus/routing/routed.hpp>

#include <set>
#include <string_view>

namespace {

namespace jaus = jauscat::jaus;

/// Whether all values up to `last` have texts that differ from each other and from that of an unknown value.
template <class Enum> bool are_described(Enum last) {
    const auto count = static_cast<unsigned>(last) + 1;
    std::set<std::string_view> texts{"", describe(static_cast<Enum>(count))};
    for (unsigned i = 0; i != count; ++i) texts.insert(describe(static_cast<Enum>(i)));
    return texts.size() == count + 2;
}

} // namespace

TEST_CASE("every result and error of messages, large data sets and routing has a text of its own") {
    CHECK(are_described(jaus::message_outcome::deferred));
    CHECK(are_described(jaus::delivered::control_lost));
    CHECK(are_described(jaus::send_errc::not_encodable));
    CHECK(are_described(jaus::reassembled::too_large));
    CHECK(are_described(jaus::added::invalid_hop));
    CHECK(are_described(jaus::routed::source_is_elsewhere));
}
