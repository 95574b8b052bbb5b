// Properties of every message of the standard, for any fields.
#include "schema/messages.hpp"
#include "schema/presence_bits.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/schema/jaus/catalog.hpp>

#include <algorithm>
#include <iostream>
#include <map>
#include <set>

namespace {

using jauscat::test::to_hex;
namespace jaus = jauscat::jaus;
namespace wire = jauscat::wire;
using wire::errc;

/// Messages that take whatever follows their fixed fields, and why. Where the text or the data begins cannot be told
/// from the bytes, so that a shorter body is another message, and one byte more is one byte of it.
const std::map<std::uint16_t, std::string_view> to_the_end{
    {0x01F4, "the error message has no count; senders end it in different ways"},
    {0x0D01, "the elements' sizes are known to who has seen the payload's interfaces"},
    {0x4807, "the image data have no count"},
    {0x4B00, "senders fill the identification with zeros, or end it with one, or do neither"},
    {0x4D01, "the elements' sizes are known to who has seen the payload's interfaces"},
};

/// Messages that take presence bits their layouts do not define, with all bytes behind, and why.
const std::map<std::uint16_t, std::string_view> tolerant{
    {0x4402, "recorded senders set bit 9 and append two bytes"},
    {0x4404, "recorded senders set bit 9 and append two bytes"},
};

/// Calls `check(message, body)` with random bodies of each message, `rounds` of each.
void for_random_bodies(unsigned seed, int rounds, const support::odds& odds, auto check) {
    support::generator g{seed};
    for (const auto& message : messages::all()) {
        INFO(message.name());
        for (int i = 0; i != rounds; ++i) {
            const auto sample = message.random(g, odds);
            INFO(to_hex(sample.bytes));
            REQUIRE(sample.error == errc::ok);
            check(message, sample);
        }
    }
}

bool has_tail(const messages::message& message, std::span<const std::byte> body) {
    if (!to_the_end.contains(message.code)) return false;
    // The error message is there when its presence bit says so.
    return message.code != 0x01F4 || body[0] != std::byte{};
}

} // namespace

TEST_CASE("the tested messages equal those of the catalogue") {
    std::set<std::uint16_t> tested, listed;
    for (const auto& message : messages::all()) REQUIRE(tested.insert(message.code).second);
    for (const auto& entry : jaus::catalog) listed.insert(entry.command_code);
    CHECK(tested.size() == 158);
    CHECK(tested == listed);
}

TEST_CASE("every random message decodes to itself after encoding") {
    for_random_bodies(1, 100, {.exact = true}, [](const messages::message& message, const messages::encoded& sample) {
        REQUIRE(sample.decodes_to_itself);
        REQUIRE(sample.bytes.size() >= message.min_size());
        REQUIRE(sample.bytes.size() <= message.max_size());
        REQUIRE(sample.why.error == errc::ok);
    });
}

TEST_CASE("every message of the standard is sent by its type") {
    for_random_bodies(4, 20, {}, [](const auto&, const messages::encoded& sample) { REQUIRE(sample.is_put); });
}

TEST_CASE("decoded messages encode to the same bytes, from real and from raw values") {
    for_random_bodies(2, 100, {}, [](const messages::message& message, const messages::encoded& sample) {
        const auto seen = message.read(sample.bytes);
        REQUIRE(seen.error == errc::ok);
        REQUIRE(seen.raw_error == errc::ok);
        REQUIRE(seen.why.error == errc::ok);
        REQUIRE(seen.again == sample.bytes);
        REQUIRE(seen.raw_again == sample.bytes);
    });
}

TEST_CASE("a view shows the same values as decode, in every field and element") {
    for_random_bodies(3, 100, {.present = 0.7}, [](const messages::message& message, const messages::encoded& sample) {
        const auto seen = message.read(sample.bytes);
        REQUIRE(seen.view_error == errc::ok);
        REQUIRE(seen.view_agrees);
    });
}

TEST_CASE("every body cut inside its structure is truncated, and the field is named") {
    for_random_bodies(4, 20, {.present = 0.7}, [](const messages::message& message, const messages::encoded& sample) {
        if (sample.bytes.size() > 600) return; // quadratic
        const std::size_t whole = has_tail(message, sample.bytes) ? message.min_size() : sample.bytes.size();
        for (std::size_t size = 0; size != whole; ++size) {
            CAPTURE(size);
            const auto seen = message.read(std::span{sample.bytes}.first(size));
            REQUIRE(seen.error == errc::truncated);
            REQUIRE(seen.raw_error == errc::truncated);
            REQUIRE(seen.view_error == errc::truncated);
            REQUIRE(seen.why.error == errc::truncated);
            REQUIRE(!seen.why.field.empty());
            REQUIRE(seen.why.offset <= size);
            REQUIRE(seen.why.available == size - seen.why.offset);
            REQUIRE(seen.why.needed > seen.why.available);
        }
    });
}

TEST_CASE("one extra byte is reported, unless the last field includes it") {
    for_random_bodies(5, 20, {.present = 0.7}, [](const messages::message& message, const messages::encoded& sample) {
        auto longer = sample.bytes;
        longer.push_back(std::byte{'x'});
        const auto seen = message.read(longer);
        if (has_tail(message, sample.bytes)) {
            REQUIRE(seen.error == errc::ok);
            REQUIRE(seen.view_error == errc::ok);
            REQUIRE(seen.raw_error == errc::ok);
        } else {
            REQUIRE(seen.error == errc::trailing_bytes);
            REQUIRE(seen.raw_error == errc::trailing_bytes);
            REQUIRE(seen.view_error == errc::trailing_bytes);
            REQUIRE(seen.why.error == errc::trailing_bytes);
            REQUIRE(seen.why.offset == sample.bytes.size());
            REQUIRE(seen.why.available == 1);
        }
    });
}

TEST_CASE("presence bits without a field are ignored, and bytes for them are accepted where peers append fields") {
    const bool all_fields = GENERATE(false, true);
    int exact = 0, refused = 0, taken = 0;
    const support::odds odds{.present = all_fields ? 1 : 0.5};
    for_random_bodies(10, 20, odds, [&](const messages::message& message, const messages::encoded& sample) {
        auto body = sample.bytes;
        const bool changed = support::set_bits_without_field(body, message.fields());
        const auto fits = message.read(body);
        REQUIRE(fits.error == errc::ok);
        REQUIRE(fits.raw_error == errc::ok);
        REQUIRE(fits.view_error == errc::ok);
        REQUIRE(fits.why.error == errc::ok);
        REQUIRE(fits.again == sample.bytes);
        REQUIRE(fits.raw_again == sample.bytes);
        REQUIRE(fits.view_agrees);
        exact += changed;

        if (!changed || has_tail(message, sample.bytes)) return;
        body.insert(body.end(), {std::byte{}, std::byte{}});
        const auto seen = message.read(body);
        const auto expected = tolerant.contains(message.code) ? errc::ok : errc::trailing_bytes;
        REQUIRE(seen.error == expected);
        REQUIRE(seen.raw_error == expected);
        REQUIRE(seen.view_error == expected);
        REQUIRE(seen.why.error == expected);
        if (expected == errc::ok) {
            REQUIRE(seen.again == sample.bytes);
            REQUIRE(seen.raw_again == sample.bytes);
            REQUIRE(seen.view_agrees);
            ++taken;
        } else {
            REQUIRE(seen.why.offset == sample.bytes.size());
            ++refused;
        }
    });
    CHECK(exact == 37 * 20);
    CHECK(taken == 2 * 20);
    CHECK(refused > 25 * 20);
}

TEST_CASE("all readers agree on whether random bytes decode") {
    support::generator g{6};
    for (const auto& message : messages::all()) {
        INFO(message.name());
        for (int i = 0; i != 200; ++i) {
            auto body = message.random(g, {.present = 0.7}).bytes;
            for (std::size_t n = 0; n != 3 && !body.empty(); ++n)
                body[support::below(g, body.size())] = static_cast<std::byte>(g());
            INFO(to_hex(body));
            const auto seen = message.read(body);
            REQUIRE(seen.why.error == seen.error);
            // A raw message takes the one raw value that stands for nothing.
            if (seen.error != errc::out_of_range) REQUIRE(seen.raw_error == seen.error);
            REQUIRE(seen.view_error == seen.raw_error);
        }
    }
}

TEST_CASE("a value that does not encode is diagnosed with its field") {
    support::generator g{7};
    std::set<errc> met;
    for (const auto& message : messages::all()) {
        INFO(message.name());
        for (int i = 0; i != 200; ++i) {
            const auto sample = message.random(g, {.present = 0.7, .illegal = 0.1});
            REQUIRE(sample.why.error == sample.error);
            if (sample.error != errc::ok) REQUIRE(!sample.why.field.empty());
            met.insert(sample.error);
        }
    }
    CHECK(met ==
          std::set{errc::ok, errc::out_of_range, errc::count_mismatch, errc::unknown_tag, errc::presence_mismatch});
}

TEST_CASE("lists do not decode without memory for them") {
    for_random_bodies(8, 20, {.present = 0.7}, [](const messages::message& message, const messages::encoded& sample) {
        const auto seen = message.read(sample.bytes);
        if (!message.has_lists)
            REQUIRE(seen.without_memory == errc::ok);
        else
            REQUIRE((seen.without_memory == errc::ok || seen.without_memory == errc::arena_full));
    });
}

TEST_CASE("no message is larger than 8 KiB") {
    auto all = messages::all();
    std::ranges::sort(all, std::ranges::greater{}, &messages::message::object_size);
    for (const auto& message : all) {
        std::cout << message.object_size << " bytes: " << message.name() << '\n';
        CHECK(message.object_size <= 8192);
    }
}

TEST_CASE("each message reaches the handler of its type, and an acknowledgement without a body the handler of "
          "acknowledgements") {
    support::generator g{9};
    for (const auto* group : messages::groups()) {
        for (const auto& message : group->all) {
            CAPTURE(message.code);
            std::vector<messages::handled> seen;
            const auto body = message.random(g, {}).bytes;
            jaus::header head{.command_code = message.code, .sequence_number = 34};
            REQUIRE(group->dispatch(head, body, seen) == jaus::dispatched::handled);
            REQUIRE(seen.size() == 1);
            REQUIRE(seen[0].code == message.code);
            REQUIRE(seen[0].header == head);
            REQUIRE(seen[0].body == body);

            for (const auto kind : {jaus::ack_nak::ack, jaus::ack_nak::nak}) {
                head.ack_nak = kind;
                REQUIRE(group->dispatch(head, {}, seen) == jaus::dispatched::acknowledgement);
                REQUIRE(seen.size() == 1);
            }
        }
    }
}
