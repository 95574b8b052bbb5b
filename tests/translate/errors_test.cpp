// Every reason for which a translation is refused, provoked.
#include "samples.hpp"
#include "support/catch.hpp"
#include <jauscat/bridge/delivery.hpp>
#include <jauscat/translate/diagnose.hpp>

#include <set>
#include <string>
#include <tuple>

using namespace jauscat;
using namespace jauscat::test;
using translate::errc;

namespace {

template <class Translator> std::vector<std::byte> sample_packet() {
    return to_packet<Translator>(wrench_effort).bytes;
}

/// What the way back says of the sample's packet with one word changed.
template <class Translator> errc back_with(word at, std::uint32_t value) {
    return from_packet<Translator>(with(sample_packet<Translator>(), at, value)).error;
}

} // namespace

TEMPLATE_TEST_CASE("a message shorter than its header is truncated", "", seed, self_contained) {
    for (std::size_t size = 0; size != 16; ++size)
        CHECK(to_packet<TestType>(std::span{wrench_effort}.first(size)).error == errc::truncated);
}

TEMPLATE_TEST_CASE("a packet shorter than its fields and data is truncated", "", seed, self_contained) {
    const auto packet = sample_packet<TestType>();
    for (std::size_t size = 0; size != packet.size(); ++size) {
        CAPTURE(size);
        CHECK(from_packet<TestType>(std::span{packet}.first(size)).error == errc::truncated);
    }
}

TEMPLATE_TEST_CASE("a packet that counts more data than it has is truncated", "", seed, self_contained) {
    const auto size = static_cast<std::uint32_t>(sample_packet<TestType>().size() - 56);
    CHECK(back_with<TestType>(word::ul_data_cnt, size + 1) == errc::truncated);
    CHECK(back_with<TestType>(word::ul_data_cnt, 0xFFFFFFFF) == errc::truncated);
}

TEMPLATE_TEST_CASE("a packet whose data ends within the header fields it carries is truncated", "", seed,
                   self_contained) {
    auto packet = to_packet<TestType>(message_with_body(0)).bytes;
    CHECK(from_packet<TestType>(packet).bytes == message_with_body(0));
    for (std::uint32_t count = 0; count != TestType::rest_size; ++count) {
        set(packet, word::ul_data_cnt, count);
        set(packet, word::ul_len, 16 + count);
        CHECK(from_packet<TestType>(packet).error == errc::truncated);
    }
}

TEMPLATE_TEST_CASE("a result one byte larger than its buffer gives no_space", "", seed, self_contained) {
    const auto packet = sample_packet<TestType>();
    std::vector<std::byte> out(packet.size());
    CHECK(TestType::to_packet(wrench_effort, std::span{out}).error() == errc::ok);
    CHECK(TestType::to_packet(wrench_effort, std::span{out}.first(packet.size() - 1)).error() == errc::no_space);
    CHECK(TestType::to_packet(wrench_effort, {}).error() == errc::no_space);
    CHECK(TestType::from_packet(packet, std::span{out}.first(wrench_effort.size())).error() == errc::ok);
    CHECK(TestType::from_packet(packet, std::span{out}.first(wrench_effort.size() - 1)).error() == errc::no_space);
    CHECK(TestType::from_packet(packet, {}).error() == errc::no_space);
}

TEMPLATE_TEST_CASE("a message with another body size than its header states has the wrong size", "", seed,
                   self_contained) {
    auto message = vector_of(wrench_effort);
    message[12] = std::byte{19};
    CHECK(to_packet<TestType>(message).error == errc::wrong_size);
    message[12] = std::byte{21};
    CHECK(to_packet<TestType>(message).error == errc::wrong_size);
    message[12] = std::byte{20};
    CHECK(to_packet<TestType>(message).error == errc::ok);
    message.pop_back();
    CHECK(to_packet<TestType>(message).error == errc::wrong_size);
}

TEMPLATE_TEST_CASE("a packet may state a larger length than its data need, but not a smaller one", "", seed,
                   self_contained) {
    const auto length = get(sample_packet<TestType>(), word::ul_len);
    CHECK(back_with<TestType>(word::ul_len, length - 1) == errc::wrong_size);
    CHECK(back_with<TestType>(word::ul_len, 0) == errc::wrong_size);

    auto padded = with(sample_packet<TestType>(), word::ul_len, length + 4);
    padded.resize(padded.size() + 4, std::byte{0xEE});
    CHECK(to_hex(from_packet<TestType>(padded).bytes) == to_hex(wrench_effort));
}

TEST_CASE("a self-contained packet whose data state another body size has the wrong size") {
    auto packet = sample_packet<self_contained>();
    packet[64] = std::byte{19};
    CHECK(from_packet<self_contained>(packet).error == errc::wrong_size);
    packet[64] = std::byte{21};
    CHECK(from_packet<self_contained>(packet).error == errc::wrong_size);
}

TEMPLATE_TEST_CASE("the largest body fills a packet, and one byte more is too large", "", seed, self_contained) {
    const auto largest = message_with_body(TestType::max_body);
    const auto packet = to_packet<TestType>(largest);
    REQUIRE(packet.error == errc::ok);
    CHECK(packet.bytes.size() == 56 + 1540);
    CHECK(get(packet.bytes, word::ul_data_cnt) == 1540);
    CHECK(get(packet.bytes, word::ul_len) == 1556);
    CHECK(from_packet<TestType>(packet.bytes).bytes == largest);

    CHECK(to_packet<TestType>(message_with_body(TestType::max_body + 1)).error == errc::too_large);

    auto swollen = with(with(packet.bytes, word::ul_data_cnt, 1541), word::ul_len, 1557);
    swollen.push_back({});
    std::vector<std::byte> out(2000);
    CHECK(TestType::from_packet(swollen, out).error() == errc::too_large);
}

TEMPLATE_TEST_CASE("a table for cards from before 2011-09 accepts four bytes more", "",
                   (translation::seed_table_of<6900, translation::ra_command_codes, 1544>),
                   (translation::self_contained_table_of<6900, translation::ra_command_codes, 1544>)) {
    using older = translate::translator<typename TestType::type>;
    STATIC_REQUIRE(hilscher::max_sdo_data_before_2011_09 == 1544);
    const auto largest = message_with_body(older::max_body);
    const auto packet = to_packet<older>(largest);
    REQUIRE(packet.error == errc::ok);
    CHECK(get(packet.bytes, word::ul_data_cnt) == 1544);
    CHECK(get(packet.bytes, word::ul_len) == 1560);
    CHECK(from_packet<older>(packet.bytes).bytes == largest);
    CHECK(to_packet<older>(message_with_body(older::max_body + 1)).error == errc::too_large);
}

TEMPLATE_TEST_CASE("a command code that is not in the table's list is unknown", "", seed, self_contained) {
    const auto [low, high] = GENERATE(std::pair{0x00, 0x00}, std::pair{0x12, 0x00}, std::pair{0x03, 0x04},
                                      std::pair{0x01, 0xD0}, std::pair{0xFF, 0xFF});
    auto message = vector_of(wrench_effort);
    message[2] = static_cast<std::byte>(low);
    message[3] = static_cast<std::byte>(high);
    CHECK(to_packet<TestType>(message).error == errc::unknown_command_code);
}

TEMPLATE_TEST_CASE("an index outside of 6900 to 7155 is not a component", "", seed, self_contained) {
    CHECK(back_with<TestType>(word::ul_index, 0) == errc::unknown_index);
    CHECK(back_with<TestType>(word::ul_index, 6899) == errc::unknown_index);
    CHECK(back_with<TestType>(word::ul_index, 6900) == errc::ok);
    CHECK(back_with<TestType>(word::ul_index, 7155) == errc::ok);
    CHECK(back_with<TestType>(word::ul_index, 7156) == errc::unknown_index);
    CHECK(back_with<TestType>(word::ul_index, 0x10000 + 6933) == errc::unknown_index);
}

TEMPLATE_TEST_CASE("a subindex outside of 1 to 158 is not a command code", "", seed, self_contained) {
    CHECK(back_with<TestType>(word::ul_sub_index, 0) == errc::unknown_subindex);
    CHECK(back_with<TestType>(word::ul_sub_index, 1) == errc::ok);
    CHECK(back_with<TestType>(word::ul_sub_index, 158) == errc::ok);
    CHECK(back_with<TestType>(word::ul_sub_index, 159) == errc::unknown_subindex);
    CHECK(back_with<TestType>(word::ul_sub_index, 255) == errc::unknown_subindex);
    CHECK(back_with<TestType>(word::ul_sub_index, 256) == errc::unknown_subindex);
    CHECK(back_with<TestType>(word::ul_sub_index, 0x100 + 26) == errc::unknown_subindex);
}

TEST_CASE("the seed table refuses reserved data flags and sequence positions, the self-contained one carries flags") {
    for (unsigned flag = 0; flag != 16; ++flag) {
        CAPTURE(flag);
        const bool defined = flag == 0 || flag == 1 || flag == 2 || flag == 4 || flag == 8;
        auto message = vector_of(wrench_effort);
        message[13] = static_cast<std::byte>(flag << 4);
        CHECK(to_packet<seed>(message).error == (defined ? errc::ok : errc::reserved_value));
        CHECK(from_packet<self_contained>(to_packet<self_contained>(message).bytes).bytes == message);
    }
    for (std::uint32_t ul_ext = 0; ul_ext != 0x1000; ++ul_ext) {
        CAPTURE(ul_ext);
        const bool defined = ul_ext == 0 || ul_ext == 0x80 || ul_ext == 0xC0 || ul_ext == 0x40 || ul_ext == 0x2C0;
        CHECK(back_with<seed>(word::ul_ext, ul_ext) == (defined ? errc::ok : errc::reserved_value));
    }
}

TEST_CASE("a value that does not fit its JAUS field is out of range") {
    CHECK(back_with<seed>(word::ul_dest, 255) == errc::ok);
    CHECK(back_with<seed>(word::ul_dest, 256) == errc::out_of_range);
    CHECK(back_with<seed>(word::ul_dest_id, 255) == errc::ok);
    CHECK(back_with<seed>(word::ul_dest_id, 256) == errc::out_of_range);
    CHECK(back_with<seed>(word::ul_node_id, 255) == errc::ok);
    CHECK(back_with<seed>(word::ul_node_id, 256) == errc::out_of_range);
    CHECK(back_with<self_contained>(word::ul_node_id, 255) == errc::ok);
    CHECK(back_with<self_contained>(word::ul_node_id, 256) == errc::out_of_range);
    CHECK(back_with<self_contained>(word::ul_node_id, 0xFFFFFFFF) == errc::out_of_range);
}

TEMPLATE_TEST_CASE("a packet that is not a download request is the wrong packet", "", seed, self_contained) {
    CHECK(back_with<TestType>(word::ul_cmd, 0x00650006) == errc::wrong_packet);
    CHECK(back_with<TestType>(word::ul_cmd, 0x00650009) == errc::wrong_packet);
    CHECK(back_with<TestType>(word::ul_sta, 0xC0000001) == errc::wrong_packet);
    CHECK(back_with<TestType>(word::ul_rout, 1) == errc::wrong_packet);
}

TEST_CASE("the self-contained table fixes receiver and sequence position") {
    CHECK(back_with<self_contained>(word::ul_dest, 0x21) == errc::wrong_packet);
    CHECK(back_with<self_contained>(word::ul_dest_id, 1) == errc::wrong_packet);
    CHECK(back_with<self_contained>(word::ul_ext, 0x80) == errc::wrong_packet);
}

TEMPLATE_TEST_CASE("sender, sender reference and packet number are set by the caller", "", seed, self_contained) {
    packet given{};
    given.head.ul_src = 0x11121314;
    given.head.ul_src_id = 0x21222324;
    given.head.ul_id = 0x31323334;
    const auto there = to_packet<TestType>(wrench_effort, given);
    CHECK(get(there.bytes, word::ul_src) == 0x11121314);
    CHECK(get(there.bytes, word::ul_src_id) == 0x21222324);
    CHECK(get(there.bytes, word::ul_id) == 0x31323334);
    CHECK(from_packet<TestType>(there.bytes).bytes == vector_of(wrench_effort));

    auto without = there.bytes;
    for (const auto at : {word::ul_src, word::ul_src_id, word::ul_id}) set(without, at, 0);
    CHECK(without == sample_packet<TestType>());
}

TEMPLATE_TEST_CASE("the caller's value for a field of the table is overwritten", "", seed, self_contained) {
    packet given{};
    given.head.ul_dest = given.head.ul_dest_id = given.head.ul_len = given.head.ul_ext = given.head.ul_rout = 77;
    given.head.ul_cmd = hilscher::packet_command::sdo_upload_req;
    given.head.ul_sta = hilscher::packet_status::fail;
    given.ul_node_id = given.ul_index = given.ul_sub_index = given.ul_data_cnt = 77;
    CHECK(to_packet<TestType>(wrench_effort, given).bytes == sample_packet<TestType>());
}

TEMPLATE_TEST_CASE("a part of a large data set is not delivered to a slave", "", translation::seed_table,
                   translation::self_contained_table) {
    using delivery = bridging::delivery<TestType>;
    for (const auto flag : {jaus::data_flag::first, jaus::data_flag::middle, jaus::data_flag::repeated,
                            jaus::data_flag::last, static_cast<jaus::data_flag>(3)})
        CHECK(delivery::deliverable({.destination = {.node = 2}, .data_flag = flag}) == errc::fragment_to_slave);
}

TEMPLATE_TEST_CASE("a message to every node or to none names no slave", "", translation::seed_table,
                   translation::self_contained_table) {
    using delivery = bridging::delivery<TestType>;
    CHECK(delivery::deliverable({.destination = {.node = 0}}) == errc::broadcast_names_no_slave);
    CHECK(delivery::deliverable({.destination = {.node = 1}}) == errc::ok);
    CHECK(delivery::deliverable({.destination = {.component = 255, .node = 254, .subsystem = 255}}) == errc::ok);
    CHECK(delivery::deliverable({.destination = {.node = 255}}) == errc::broadcast_names_no_slave);
}

TEST_CASE("every translation error has a distinct text") {
    std::set<std::string_view> lines;
    for (int i = 0; i <= static_cast<int>(errc::no_capacity); ++i)
        lines.insert(translate::describe(static_cast<errc>(i)));
    CHECK(lines.size() == static_cast<std::size_t>(errc::no_capacity) + 1);
    CHECK(!lines.contains("unknown error"));
    CHECK(translate::describe(static_cast<errc>(200)) == "unknown error");
}

TEST_CASE("a diagnosis names the field of the message that a row refuses, and its value") {
    const auto refused = [](std::size_t at, unsigned value) {
        auto message = vector_of(wrench_effort);
        message[at] = static_cast<std::byte>(value);
        const auto found =
            translate::diagnose_to_packet<translation::seed_table>(to_packet<seed>(message).error, message);
        return std::tuple{found.error, found.row != translate::diagnosis::no_row, found.field, found.value};
    };
    CHECK(refused(3, 0xD0) == std::tuple{errc::unknown_command_code, true, "command_code", 0xD005});
    CHECK(refused(13, 0x30) == std::tuple{errc::reserved_value, true, "data_flag", 3});
    CHECK(refused(12, 19) == std::tuple{errc::wrong_size, true, "data_size", 19});
    CHECK(refused(12, 20) == std::tuple{errc::ok, false, "", 0});
}

TEST_CASE("a diagnosis names the field of the packet that a row refuses, and its value") {
    const auto refused = [](word at, std::uint32_t value) {
        const auto packet = with(sample_packet<seed>(), at, value);
        const auto found =
            translate::diagnose_from_packet<translation::seed_table>(from_packet<seed>(packet).error, packet);
        return std::tuple{found.error, found.row != translate::diagnosis::no_row, found.field, found.value};
    };
    CHECK(refused(word::ul_index, 6899) == std::tuple{errc::unknown_index, true, "ul_index", 6899});
    CHECK(refused(word::ul_sub_index, 159) == std::tuple{errc::unknown_subindex, true, "ul_sub_index", 159});
    CHECK(refused(word::ul_dest, 256) == std::tuple{errc::out_of_range, true, "ul_dest", 256});
    CHECK(refused(word::ul_cmd, 0x00650006) == std::tuple{errc::wrong_packet, true, "ul_cmd", 0x00650006});
    CHECK(refused(word::ul_len, 0) == std::tuple{errc::wrong_size, true, "ul_len", 0});
    CHECK(refused(word::ul_data_cnt, 0xFFFF) == std::tuple{errc::truncated, false, "", 0});
    CHECK(refused(word::ul_index, 6933) == std::tuple{errc::ok, false, "", 0});
}
