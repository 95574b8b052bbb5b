// What an emulated slave says about its objects, byte for byte: lists, objects and entries, in fragments where the
// mailbox is small; and whole objects by complete access.
#include "ethercat/described_objects.hpp"
#include "ethercat/objects.hpp"
#include "ethercat/slave_bench.hpp"
#include <jauscat/bridge/listed_objects.hpp>
#include <jauscat/ethercat/master/object_descriptions.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>

using namespace jauscat::ethercat;
using jauscat::test::to_hex;
namespace test = jauscat::test;

namespace {

constexpr std::array outputs{pdo_entry{0x7000, 1, 16, 6, "effort x"}};

// Standard objects and 2000h to 2003h of described_objects behind one slave.
struct bench : test::slave_bench {
    test::described_objects objects;
    standard_objects dictionary;
    slave device;

    explicit bench(std::uint16_t mailbox_size = 128, coe_options options = {},
                   slave_description description = {.outputs = outputs})
        : dictionary{description, objects}, device{sized(description, mailbox_size), dictionary, options} {
        start(device, mailbox_size);
    }
};

} // namespace

TEST_CASE("a slave lists its objects") {
    bench b;
    CHECK(b.ask("0800 0000 00 13 0080 01 00 0000 0100") ==
          "20 00 00 00 00 13 00 80 02 00 00 00 01 00 00 10 08 10 18 10 00 16 00 1c 12 1c 13 1c 00 20 01 20 02 20 03 20 "
          "00 30");
    // Counts of all lists; then those that can be mapped, are stored, or are settings.
    CHECK(b.ask("0800 0000 00 23 0080 01 00 0000 0000") ==
          "12 00 00 00 00 23 00 80 02 00 00 00 00 00 0c 00 01 00 01 00 01 00 01 00");
    CHECK(b.ask("0800 0000 00 33 0080 01 00 0000 0200") == "0a 00 00 00 00 33 00 80 02 00 00 00 02 00 00 20");
    CHECK(b.ask("0800 0000 00 43 0080 01 00 0000 0300") == "0a 00 00 00 00 43 00 80 02 00 00 00 03 00 01 20");
    CHECK(b.ask("0800 0000 00 53 0080 01 00 0000 0400") == "0a 00 00 00 00 53 00 80 02 00 00 00 04 00 02 20");
    CHECK(b.ask("0800 0000 00 63 0080 01 00 0000 0500") == "0a 00 00 00 00 63 00 80 02 00 00 00 05 00 03 20");
    CHECK(b.ask("0800 0000 00 73 0080 01 00 0000 0600") == "0a 00 00 00 00 73 00 80 07 00 00 00 00 00 01 06");
}

TEST_CASE("a slave describes objects and entries") {
    bench b;
    // 1018h: a record of type IDENTITY with 4 entries.
    CHECK(b.ask("0800 0000 00 13 0080 03 00 0000 1810") ==
          "14 00 00 00 00 13 00 80 04 00 00 00 18 10 23 00 04 09 49 64 65 6e 74 69 74 79");
    CHECK(b.ask("0a00 0000 00 23 0080 05 00 0000 1810 01 07") ==
          "19 00 00 00 00 23 00 80 06 00 00 00 18 10 01 07 07 00 20 00 07 00 56 65 6e 64 6f 72 20 49 44");
    // 1600h:1 is named like what it maps; 1C12h is an array of UNSIGNED16.
    CHECK(b.ask("0a00 0000 00 33 0080 05 00 0000 0016 01 00") ==
          "18 00 00 00 00 33 00 80 06 00 00 00 00 16 01 00 07 00 20 00 07 00 65 66 66 6f 72 74 20 78");
    CHECK(b.ask("0800 0000 00 43 0080 03 00 0000 121c") ==
          "1d 00 00 00 00 43 00 80 04 00 00 00 12 1c 06 00 01 08 4f 75 74 70 75 74 20 61 73 73 69 67 6e 6d 65 6e 74");
    // The application's own: written in PRE-OP, read everywhere, a setting.
    CHECK(b.ask("0a00 0000 00 53 0080 05 00 0000 0320 00 ff") ==
          "14 00 00 00 00 53 00 80 06 00 00 00 03 20 00 07 07 00 20 00 0f 02 67 61 69 6e");
    // No such object, no such entry, no such question, and one that is cut off.
    CHECK(b.ask("0800 0000 00 63 0080 03 00 0000 5555") == "0a 00 00 00 00 63 00 80 07 00 00 00 00 00 02 06");
    CHECK(b.ask("0a00 0000 00 73 0080 05 00 0000 1810 05 00") == "0a 00 00 00 00 73 00 80 07 00 00 00 11 00 09 06");
    CHECK(b.ask("0a00 0000 00 13 0080 05 00 0000 5555 00 00") == "0a 00 00 00 00 13 00 80 07 00 00 00 00 00 02 06");
    CHECK(b.ask("0800 0000 00 23 0080 09 00 0000 0100") == "0a 00 00 00 00 23 00 80 07 00 00 00 01 00 04 05");
    CHECK(b.ask("0700 0000 00 33 0080 01 00 0000 01") == "04 00 00 00 00 30 01 00 06 00");
}

TEST_CASE("a list is sent in fragments through a small mailbox") {
    bench b{24};
    REQUIRE(b.put("0800 0000 00 13 0080 01 00 0000 0100"));
    CHECK(b.take() == "12 00 00 00 00 13 00 80 82 00 02 00 01 00 00 10 08 10 18 10 00 16 00 1c");
    CHECK(b.take() == "12 00 00 00 00 23 00 80 82 00 01 00 12 1c 13 1c 00 20 01 20 02 20 03 20");
    CHECK(b.take() == "08 00 00 00 00 33 00 80 02 00 00 00 00 30");
    CHECK(b.take().empty());
    // The counts take the mailbox just as it is; a name takes several messages.
    CHECK(b.ask("0800 0000 00 23 0080 01 00 0000 0000") ==
          "12 00 00 00 00 23 00 80 02 00 00 00 00 00 0c 00 01 00 01 00 01 00 01 00");
    CHECK(b.ask("0800 0000 00 33 0080 03 00 0000 0810") ==
          "12 00 00 00 00 33 00 80 84 00 01 00 08 10 09 00 00 07 44 65 76 69 63 65");
    CHECK(b.take() == "0b 00 00 00 00 43 00 80 04 00 00 00 20 6e 61 6d 65");
    CHECK(b.take().empty());
    // An answer never has the counter of the message before it.
    CHECK(b.ask("0a00 0000 00 43 0020 40 0010 00 00000000") == "0a 00 00 00 00 53 00 30 43 00 10 00 00 00 00 00");
}

TEST_CASE("a new request ends a fragmented answer") {
    bench b{24};
    REQUIRE(b.put("0800 0000 00 13 0080 01 00 0000 0100"));
    REQUIRE(b.put("0a00 0000 00 23 0020 40 0010 00 00000000"));
    CHECK(b.take() == "12 00 00 00 00 13 00 80 82 00 02 00 01 00 00 10 08 10 18 10 00 16 00 1c");
    CHECK(b.take() == "0a 00 00 00 00 23 00 30 43 00 10 00 00 00 00 00");
    CHECK(b.take().empty());
}

TEST_CASE("a lost fragment is sent again, then the next one") {
    bench b{24};
    const std::string first = "12 00 00 00 00 13 00 80 82 00 02 00 01 00 00 10 08 10 18 10 00 16 00 1c",
                      second = "12 00 00 00 00 23 00 80 82 00 01 00 12 1c 13 1c 00 20 01 20 02 20 03 20",
                      third = "08 00 00 00 00 33 00 80 02 00 00 00 00 30";
    REQUIRE(b.put("0800 0000 00 13 0080 01 00 0000 0100"));
    CHECK(b.take() == first);
    b.toggle_repeat();
    CHECK(b.take() == first);
    b.toggle_repeat();
    CHECK(b.take() == first); // lost once more
    CHECK(b.take() == second);
    CHECK(b.take() == third);
    CHECK(b.take().empty());
    b.toggle_repeat();
    CHECK(b.take() == third);
    CHECK(b.take().empty());
    CHECK(b.ask("0a00 0000 00 23 0020 40 0010 00 00000000") == "0a 00 00 00 00 23 00 30 43 00 10 00 00 00 00 00");
    b.toggle_repeat();
    CHECK(b.take() == "0a 00 00 00 00 23 00 30 43 00 10 00 00 00 00 00");
}

TEST_CASE("a slave that does not describe all of its objects has no SDO information") {
    test::objects undescribed;
    standard_objects dictionary{{}, undescribed};
    slave device{{}, dictionary};
    test::slave_bench b;
    b.start(device, 256);
    CHECK(b.ask("0800 0000 00 13 0080 01 00 0000 0100") == "04 00 00 00 00 10 01 00 04 00");
}

TEST_CASE("the SII states which object services the slave has") {
    // Category general, after its header 1e 00 10 00: the sixth byte has SDO, SDO information and complete access.
    const auto general = [](const sii_image& image) {
        const auto bytes = to_hex(image);
        return bytes.substr(bytes.find("1e 00 10 00 ") + 12, 17);
    };
    CHECK(general(make_sii_image({})) == "00 00 01 01 00 01");
    CHECK(general(make_sii_image({}, {.sdo_information = true, .complete_access = true})) == "00 00 01 01 00 23");
    bench b; // the slave's own
    std::string words;
    for (unsigned word = 0x40; word != 0x60; word += 2) words += b.sii(word) + ' ';
    CHECK(words.find("1e 00 10 00 00 00 01 01 00 23") != std::string::npos);
}

TEST_CASE("complete access reads all entries of an object") {
    bench b;
    // 3000h: 4 entries of 3, 5, 16 and 1 bits. From subindex 0 with the count in 16 bits, from 1 without.
    CHECK(b.ask("0a00 0000 00 13 0020 50 0030 00 00000000") ==
          "10 00 00 00 00 13 00 30 51 00 30 00 06 00 00 00 04 00 2d 34 12 01");
    CHECK(b.ask("0a00 0000 00 23 0020 50 0030 01 00000000") == "0a 00 00 00 00 23 00 30 53 00 30 01 2d 34 12 01");
    CHECK(b.ask("0a00 0000 00 33 0020 50 1810 01 00000000") ==
          "1a 00 00 00 00 33 00 30 51 18 10 01 10 00 00 00 00 00 00 00 00 00 00 00 01 00 00 00 00 00 00 00");
    CHECK(b.ask("0a00 0000 00 43 0020 50 121c 00 00000000") == "0a 00 00 00 00 43 00 30 53 12 1c 00 01 00 00 16");
    // Not from another subindex, not of a variable, not where there is no object.
    CHECK(b.ask("0a00 0000 00 53 0020 50 0030 02 00000000") == "0a 00 00 00 00 53 00 20 80 00 30 02 04 00 01 06");
    CHECK(b.ask("0a00 0000 00 63 0020 50 0010 00 00000000") == "0a 00 00 00 00 63 00 20 80 00 10 00 04 00 01 06");
    CHECK(b.ask("0a00 0000 00 73 0020 50 5555 00 00000000") == "0a 00 00 00 00 73 00 20 80 55 55 00 00 00 02 06");
}

TEST_CASE("complete access writes all entries of an object") {
    bench b;
    const auto value = [&](std::uint8_t subindex) { return to_hex(b.objects.values.at({0x3000, subindex})); };
    CHECK(b.ask("1000 0000 00 13 0020 31 0030 00 06000000 0400 52 3412 01") ==
          "0a 00 00 00 00 13 00 30 70 00 30 00 00 00 00 00");
    CHECK(value(1) == "02");
    CHECK(value(2) == "0a");
    CHECK(value(3) == "34 12");
    CHECK(value(4) == "01");
    CHECK(b.ask("0a00 0000 00 23 0020 33 0030 01 ff 7856 00") == "0a 00 00 00 00 23 00 30 70 00 30 01 00 00 00 00");
    CHECK(value(1) == "07");
    CHECK(value(2) == "1f");
    CHECK(value(3) == "78 56");
    CHECK(value(4) == "00");
    // Another size, another count, an object that is read only.
    CHECK(b.ask("0a00 0000 00 33 0020 37 0030 01 ff 7856 00") == "0a 00 00 00 00 33 00 20 80 00 30 01 10 00 07 06");
    CHECK(b.ask("1000 0000 00 43 0020 31 0030 00 06000000 0300 52 3412 01") ==
          "0a 00 00 00 00 43 00 20 80 00 30 00 02 00 01 06");
    CHECK(b.ask("0a00 0000 00 53 0020 33 121c 00 01000016") == "0a 00 00 00 00 53 00 20 80 12 1c 00 02 00 01 06");
    CHECK(value(1) == "07");
}

TEST_CASE("a variable has no complete access, whatever its description states") {
    // 2000h:0 is a text of 32 bytes, more than a small mailbox has room for.
    struct variable {
        object_read read(std::uint16_t, std::uint8_t, std::span<std::byte> out) noexcept {
            CHECK(out.size() < 32);
            return {.error = abort_code::exceeds_mailbox};
        }
        abort_code write(std::uint16_t, std::uint8_t, std::span<const std::byte>) noexcept { return abort_code::none; }
        [[nodiscard]] std::uint16_t next_index(std::uint16_t after) const noexcept {
            return after < 0x2000 ? std::uint16_t{0x2000} : std::uint16_t{};
        }
        [[nodiscard]] std::optional<object_info> describe(std::uint16_t) const noexcept {
            return object_info{.data_type = data_types::visible_string, .code = code, .complete_access = true};
        }
        [[nodiscard]] std::optional<entry_info> describe(std::uint16_t, std::uint8_t subindex) const noexcept {
            if (subindex != 0) return {};
            return entry_info{.data_type = data_types::visible_string, .bits = 32 * 8, .access = accessible_always};
        }
        object_code code{};
    };
    for (const auto code : {object_code::variable, object_code::record}) { // nor a record whose count is no number
        variable text{.code = code};
        slave device{test::slave_bench::sized({}, 24), text};
        test::slave_bench b;
        b.start(device, 24);
        const std::string refused = "20 80 00 20 00 04 00 01 06";
        CHECK(b.ask("0a00 0000 00 13 0020 50 0020 00 00000000") == "0a 00 00 00 00 13 00 " + refused);
        CHECK(b.ask("0a00 0000 00 23 0020 33 0020 00 01020304") == "0a 00 00 00 00 23 00 " + refused);
    }
}

TEST_CASE("complete access uses segments through a small mailbox") {
    std::vector<std::byte> memory(64);
    bench b{24, {.transfer_memory = memory}};
    CHECK(b.ask("0a00 0000 00 13 0020 50 1810 00 00000000") ==
          "12 00 00 00 00 13 00 30 51 18 10 00 12 00 00 00 04 00 00 00 00 00 00 00");
    CHECK(b.ask("0a00 0000 00 23 0020 60 0000 00 00000000") ==
          "0d 00 00 00 00 23 00 30 01 00 00 01 00 00 00 00 00 00 00");
    CHECK(b.ask("1200 0000 00 33 0020 31 0030 00 06000000 0400 52 3412 01 0000") ==
          "0a 00 00 00 00 33 00 20 80 00 30 00 10 00 07 06"); // more than it says
    CHECK(b.ask("0a00 0000 00 43 0020 31 0030 00 06000000") == "0a 00 00 00 00 43 00 30 70 00 30 00 00 00 00 00");
    CHECK(b.ask("0a00 0000 00 53 0020 03 0400 52 3412 01 00") == "0a 00 00 00 00 53 00 30 20 00 00 00 00 00 00 00");
    CHECK(to_hex(b.objects.values.at({0x3000, 3})) == "34 12");
}

TEST_CASE("objects of JAUS messages are described as a record of octet strings") {
    using jauscat::bridging::sub_object;
    constexpr std::array entries{sub_object{26, 0x0405, "set_wrench_effort", 28, false, true},
                                 sub_object{121, 0x4405, "report_wrench_effort", 28, true, true}};
    const std::array list{jauscat::bridging::object_description{0x1B15, 33, "component 33", true, entries}};
    test::objects behind;
    const jauscat::bridging::listed_objects objects{list, behind};
    CHECK(objects.next_index(0) == 0x1B15);
    CHECK(objects.next_index(0x1B15) == 0);
    const auto object = objects.describe(0x1B15);
    REQUIRE(object);
    CHECK(object->code == object_code::record);
    CHECK(object->highest_subindex == 121);
    CHECK(object->name == "component 33");
    CHECK_FALSE(object->complete_access); // subindices are missing
    CHECK_FALSE(objects.describe(0x1B16));
    const auto set = objects.describe(0x1B15, 26);
    REQUIRE(set);
    CHECK(set->data_type == 0x000A);
    CHECK(set->bits == 224);
    CHECK(is_writable(set->access));
    CHECK_FALSE(is_readable(set->access));
    CHECK(set->name == "set_wrench_effort");
    CHECK(is_readable(objects.describe(0x1B15, 121)->access));
    CHECK(objects.describe(0x1B15, 0)->bits == 8);
    CHECK_FALSE(objects.describe(0x1B15, 27));
}

TEST_CASE("the description of an entry has the values that the slave has sent, and the name behind them") {
    enum : unsigned { unit = 0x08, minimum = 0x20 };
    std::array<std::byte, 64> space{};
    auto answer = *jauscat::wire::encode(
        entry_answer{.index = 0x6064, .subindex = 0, .value_info = unit | minimum, .bits = 16}, space);
    const auto expected = std::to_array<std::uint8_t>({0x44, 0x33, 0x22, 0x11, 0x34, 0x12, 'p', 'o', 's'});
    std::ranges::copy(std::as_bytes(std::span{expected}), space.begin() + static_cast<std::ptrdiff_t>(answer.size()));
    const auto found = decode_entry_description(std::span{space}.first(answer.size() + expected.size()));
    REQUIRE(found);
    CHECK(found->entry.index == 0x6064);
    CHECK(found->unit == 0x11223344);
    CHECK(to_hex(found->minimum) == "34 12");
    CHECK(found->default_value.empty());
    CHECK(found->maximum.empty());
    CHECK(found->name == "pos");
}
