// Rules of real slaves that an emulated one can be given: entries for some states only, slow answers, objects that are
// refused, subindex 0 beside objects that describe themselves.
#include "ethercat/described_objects.hpp"
#include "ethercat/objects.hpp"
#include "ethercat/slave_bench.hpp"
#include <jauscat/bridge/listed_objects.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>

using namespace jauscat::ethercat;
using jauscat::test::from_hex;
using jauscat::test::to_hex;
namespace test = jauscat::test;

namespace {

template <class Objects> struct bench : test::slave_bench {
    Objects objects{};
    slave device;

    explicit bench(const coe_options& options, const slave_description& description = {})
        : device{description, objects, options} {
        start(device, description.mailbox_in_size);
    }
};

std::string aborted(std::string_view counter, std::string_view object, std::string_view code) {
    return to_hex(
        from_hex("0a00 0000 00" + std::string{counter} + "0020 80" + std::string{object} + std::string{code}));
}

constexpr std::string_view in_this_state = "22000008", read_only = "02000106", not_zero = "03000106";

} // namespace

TEST_CASE("an entry is written only in states that its description allows") {
    bench<test::described_objects> b{{.state_rule = true}};
    const std::string written = "0a 00 00 00 00 13 00 30 60 03 20 00 00 00 00 00";
    CHECK(b.ask("0a00 0000 00 13 0020 23 0320 00 44332211") == written);
    CHECK(b.state("0400") == "04 00 00 00 00 00");
    CHECK(b.ask("0a00 0000 00 23 0020 23 0320 00 55555555") == aborted("23", "032000", in_this_state));
    CHECK(b.ask("0a00 0000 00 33 0020 40 0320 00 00000000") == "0a 00 00 00 00 33 00 30 43 03 20 00 44 33 22 11");
    CHECK(b.ask("0a00 0000 00 43 0020 23 0020 00 55555555") == "0a 00 00 00 00 43 00 30 60 00 20 00 00 00 00 00");
    CHECK(b.state("0800") == "08 00 00 00 00 00");
    CHECK(b.ask("0a00 0000 00 53 0020 23 0320 00 55555555") == aborted("53", "032000", in_this_state));
    CHECK(b.state("0200") == "02 00 00 00 00 00");
    CHECK(b.ask("0a00 0000 00 13 0020 23 0320 00 44332211") == written);
    // What cannot be written at all is read only in every state, and what is not there is not there.
    CHECK(b.state("0400") == "04 00 00 00 00 00");
    CHECK(b.ask("0a00 0000 00 23 0020 2f 0030 00 01000000") == aborted("23", "003000", read_only));
    CHECK(b.ask("0a00 0000 00 33 0020 23 5555 00 55555555") == aborted("33", "555500", "00000206"));

    bench<test::described_objects> free{{}};
    CHECK(free.state("0400") == "04 00 00 00 00 00");
    CHECK(free.ask("0a00 0000 00 13 0020 23 0320 00 44332211") == written);
}

TEST_CASE("by the rule of states mapping objects are written in PRE-OP only") {
    bench<test::objects> b{{.state_rule = true}};
    b.objects.add(0x1AF5, 26, 4);
    b.objects.add(0x2000, 1, 4);
    CHECK(b.ask("0a00 0000 00 13 0020 23 f51a 1a 44332211") == "0a 00 00 00 00 13 00 30 60 f5 1a 1a 00 00 00 00");
    CHECK(b.state("0400") == "04 00 00 00 00 00");
    CHECK(b.ask("0a00 0000 00 23 0020 23 f51a 1a 44332211") == aborted("23", "f51a1a", in_this_state));
    CHECK(b.ask("0a00 0000 00 33 0020 40 f51a 1a 00000000") == "0a 00 00 00 00 33 00 30 43 f5 1a 1a 44 33 22 11");
    CHECK(b.ask("0a00 0000 00 43 0020 23 0020 01 44332211") == "0a 00 00 00 00 43 00 30 60 00 20 01 00 00 00 00");
    CHECK(b.objects.writes == 2);
}

TEST_CASE("a slow slave answers after the configured number of frames") {
    bench<test::objects> b{{.answer_delay = 3}};
    b.objects.add(0x2000, 1, 4);
    for (const char* counter : {"13", "23"}) {
        CHECK(b.put(std::string{"0a00 0000 00"} + counter + "0020 40 0020 01 00000000"));
        CHECK(b.take().empty());
        CHECK(b.read(0x0805, 1) == "09"); // the request is in its mailbox
        CHECK(b.take().empty());          // the third frame: after it has passed
        CHECK(b.take() == to_hex(from_hex(std::string{"0a00 0000 00"} + counter + "0030 43 0020 01 00000000")));
    }
    CHECK(b.put("0a00 0000 00 33 0020 40 0020 01 00000000"));
    CHECK(b.state("0100") == "01 00 00 00 00 00"); // and forgets what it was about to do in INIT
    CHECK(b.state("0200") == "02 00 00 00 00 00");
    for (int i = 0; i != 5; ++i) CHECK(b.take().empty());
}

TEST_CASE("selected objects are aborted with selected codes, in both directions") {
    constexpr std::array refused{refused_object{0x2000, 1, abort_code::hardware},
                                 refused_object{0x2001, {}, abort_code::local_control},
                                 refused_object{0x3000, 2, abort_code::resource}};
    bench<test::described_objects> b{{.refused = refused}};
    CHECK(b.ask("0a00 0000 00 13 0020 40 0020 01 00000000") == aborted("13", "002001", "00000606"));
    CHECK(b.ask("0a00 0000 00 23 0020 23 0020 01 00000000") == aborted("23", "002001", "00000606"));
    CHECK(b.ask("0a00 0000 00 33 0020 40 0020 00 00000000") == "0a 00 00 00 00 33 00 30 43 00 20 00 00 00 00 00");
    CHECK(b.ask("0a00 0000 00 43 0020 40 0120 00 00000000") == aborted("43", "012000", "21000008"));
    CHECK(b.ask("0a00 0000 00 53 0020 2f 0120 07 00000000") == aborted("53", "012007", "21000008"));
    CHECK(b.ask("0a00 0000 00 63 0020 50 0030 00 00000000") == aborted("63", "003000", "23000a06")); // with entry 2
    CHECK(b.ask("1000 0000 00 73 0020 31 0030 00 06000000 0400 52 3412 01") == aborted("73", "003000", "23000a06"));
}

TEST_CASE("the rule of subindex 0 leaves read-only mapping objects as they are") {
    constexpr std::array outputs{pdo_entry{0x7000, 1, 16, 6, "x"}, pdo_entry{0x7000, 2, 16, 6, "y"}};
    const slave_description description{.outputs = outputs};
    constexpr std::array entries{jauscat::bridging::sub_object{26, 0x0405, "set_wrench_effort", 28, false, true}};
    const std::array list{jauscat::bridging::object_description{0x1B15, 33, "component 33", true, entries}};
    test::objects behind;
    behind.add(0x1B15, 26, 28);
    jauscat::bridging::listed_objects listed{list, behind};
    standard_objects dictionary{description, listed};
    slave device{description, dictionary, {.subindex_0_rule = true}};
    test::slave_bench b;
    b.start(device, 256);
    CHECK(b.ask("0a00 0000 00 13 0020 40 0016 00 00000000") == "0a 00 00 00 00 13 00 30 4f 00 16 00 02 00 00 00");
    CHECK(b.ask("0a00 0000 00 23 0020 2f 0016 00 00000000") == aborted("23", "001600", read_only));
    CHECK(b.ask("0a00 0000 00 33 0020 23 0016 01 00000000") == aborted("33", "001601", read_only));
    // A component's object can be written, once its subindex 0 is 0; SDO information says so.
    const std::string write = "0020 21 151b 1a 1c000000 000102030405060708090a0b0c0d0e0f101112131415161718191a1b";
    CHECK(b.ask("2600 0000 00 43" + write) == aborted("43", "151b1a", not_zero));
    CHECK(b.ask("0a00 0000 00 53 0080 05 00 0000 151b 00 00") ==
          "20 00 00 00 00 53 00 80 06 00 00 00 15 1b 00 00 05 00 08 00 3f 00 48 69 67 68 65 73 74 20 73 75 62 69 6e 64 "
          "65 78");
    CHECK(b.ask("0a00 0000 00 63 0020 2f 151b 00 00000000") == "0a 00 00 00 00 63 00 30 60 15 1b 00 00 00 00 00");
    CHECK(b.ask("2600 0000 00 73" + write) == "0a 00 00 00 00 73 00 30 60 15 1b 1a 00 00 00 00");
    CHECK(behind.writes == 1);
}

TEST_CASE("complete access sets a mapping object in compliance with the rule of subindex 0") {
    // 1601h can be written: two entries of 4 bytes.
    struct mapping {
        std::array<std::byte, 8> entries{};
        object_read read(std::uint16_t, std::uint8_t subindex, std::span<std::byte> out) noexcept {
            if (subindex > 2) return {.error = abort_code::no_subindex};
            const auto value =
                subindex == 0 ? std::span<const std::byte>{two} : std::span{entries}.subspan((subindex - 1u) * 4, 4);
            std::ranges::copy(value, out.begin());
            return {.size = value.size()};
        }
        abort_code write(std::uint16_t, std::uint8_t subindex, std::span<const std::byte> data) noexcept {
            if (subindex == 0 || data.size() != 4) return abort_code::length_mismatch;
            std::ranges::copy(data, std::span{entries}.subspan((subindex - 1u) * 4).begin());
            return abort_code::none;
        }
        [[nodiscard]] std::uint16_t next_index(std::uint16_t after) const noexcept {
            return after < 0x1601 ? std::uint16_t{0x1601} : std::uint16_t{};
        }
        [[nodiscard]] std::optional<object_info> describe(std::uint16_t index) const noexcept {
            if (index != 0x1601) return {};
            return object_info{
                .highest_subindex = 2, .code = object_code::record, .name = "mapping", .complete_access = true};
        }
        [[nodiscard]] std::optional<entry_info> describe(std::uint16_t index, std::uint8_t subindex) const noexcept {
            if (index != 0x1601 || subindex > 2) return {};
            if (subindex == 0) return highest_subindex_info;
            return entry_info{.data_type = data_types::unsigned32, .bits = 32, .access = accessible_always};
        }
        std::array<std::byte, 1> two{std::byte{2}};
    };
    bench<mapping> b{{.subindex_0_rule = true}};
    const std::string from_1 = "1200 0000 00 13 0020 31 0116 01 08000000 10010070 10020070";
    CHECK(b.ask(from_1) == aborted("13", "011601", not_zero));
    CHECK(b.ask("1400 0000 00 23 0020 31 0116 00 0a000000 0200 10010070 10020070") ==
          "0a 00 00 00 00 23 00 30 70 01 16 00 00 00 00 00");
    CHECK(to_hex(b.objects.entries) == "10 01 00 70 10 02 00 70");
    CHECK(b.ask("0a00 0000 00 33 0020 50 0116 00 00000000") ==
          "14 00 00 00 00 33 00 30 51 01 16 00 0a 00 00 00 02 00 10 01 00 70 10 02 00 70");
    CHECK(b.ask(from_1) == aborted("13", "011601", not_zero)); // the count is set again
}
