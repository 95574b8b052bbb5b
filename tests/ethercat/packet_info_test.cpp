// Packets that read a slave's dictionary: confirmations byte for byte, with a slave with given answers.
#include "ethercat/packet_bench.hpp"
#include <jauscat/schema/ethercat/hilscher_info.hpp>

using namespace jauscat::ethercat;
using namespace jauscat::hilscher;
using jauscat::test::from_hex;
using jauscat::test::hex_of;
using jauscat::test::packet_bench;
using jauscat::test::to_hex;
using bytes = std::vector<std::byte>;

namespace {

// A slave at station 100h with mailboxes of 1486 bytes, with given answers from the CoE header on.
struct bench : packet_bench {
    std::deque<bytes> replies{};
    bytes asked{}; ///< the last request, CoE header on

    bench() {
        add({.vendor = 1, .mailbox_out_size = size, .mailbox_in_offset = 0x1600, .mailbox_in_size = size});
        REQUIRE(link.run(master, bring_up{0, 0x100}));
        link.on_way_back = [this](bytes& frame) { substitute(frame); };
    }
    std::string answer_with(std::string_view mail, const char* request) {
        replies = {from_hex(mail)};
        return answer(request);
    }

    static constexpr std::uint16_t size = 1486;

  private:
    void substitute(bytes& frame) {
        constexpr std::size_t command_at = 16, ado_at = 20, data_at = 26, header = 6;
        const bool out = frame.at(command_at) == std::byte{5} && frame.at(ado_at + 1) == std::byte{0x10};
        const bool in = frame.at(command_at) == std::byte{4} && frame.at(ado_at + 1) == std::byte{0x16};
        const auto mail = std::span{frame}.subspan(data_at);
        if (out) {
            asked.assign(mail.begin() + header, mail.begin() + header + std::to_integer<int>(mail[0]));
            counter_ = mail[5] & std::byte{0x70};
        }
        if (!in) return;
        const bool full = !asked.empty() && !replies.empty();
        frame.at(data_at + size) = full ? std::byte{1} : std::byte{}; // working counter
        if (!full) return;
        const auto& reply = replies.front();
        std::ranges::copy(reply, mail.begin() + header);
        mail[0] = static_cast<std::byte>(reply.size() & 0xFF);
        mail[1] = static_cast<std::byte>(reply.size() >> 8);
        mail[5] = counter_ | std::byte{3};
        replies.pop_front();
    }
    std::byte counter_{};
};

constexpr const char* list = "20000000 00000000 00000000 00000000 08000000 01000000 00000000 0a006500"
                             " 00000000 00000000 00010000 01000000";
constexpr const char* object = "20000000 00000000 00000000 00000000 08000000 01000000 00000000 18006500"
                               " 00000000 00000000 00010000 18100000";
constexpr const char* entry = "20000000 00000000 00000000 00000000 10000000 01000000 00000000 1a006500"
                              " 00000000 00000000 00010000 18100000 02000000 7f000000";

/// A confirmation's header.
std::string head(std::uint32_t length, std::uint32_t status, std::uint32_t command) {
    std::array<std::byte, 40> out{};
    REQUIRE(jauscat::wire::encode(packet_header{.ul_dest = 0x20,
                                                .ul_len = length,
                                                .ul_id = 1,
                                                .ul_sta = static_cast<packet_status>(status),
                                                .ul_cmd = static_cast<packet_command>(command)},
                                  out));
    return to_hex(out);
}
std::string confirmation(std::uint32_t length, std::uint32_t status, std::uint32_t command, const char* body) {
    return head(length, status, command) + " " + hex_of(body);
}

} // namespace

TEST_CASE("an OD list is confirmed with its indices") {
    bench b;
    CHECK(b.answer_with("0080 02 00 0000 0100 0010 1810 0020", list) ==
          confirmation(18, 0, 0x65000B, "00010000 01000000 03000000 0010 1810 0020"));
    CHECK(to_hex(b.asked) == hex_of("0080 01 00 0000 0100"));
    CHECK(b.answer_with("0080 02 00 0000 0100", list) == confirmation(12, 0, 0x65000B, "00010000 01000000 00000000"));
    CHECK(b.answer_with("0080 02 00 0000 0100 0010 18", list) == // half an index is none
          confirmation(14, 0, 0x65000B, "00010000 01000000 01000000 0010"));
}

TEST_CASE("an OD list has one of five types") {
    bench b;
    for (std::uint32_t type = 1; type != 6; ++type) {
        b.replies = {from_hex("0080 02 00 0000 0000 0010")};
        b.replies.front().at(6) = static_cast<std::byte>(type);
        const auto answer =
            b.ask(get_od_list_request{.ul_node_id = 0x100, .ul_list_type = static_cast<packet_list_type>(type)});
        CHECK(answer.status == 0);
        CHECK(answer.length == 14);
        CHECK(b.asked.at(6) == static_cast<std::byte>(type));
    }
    for (const std::uint32_t type : {0u, 6u, 0x10001u, 0xFFFFFFFFu}) {
        const auto answer =
            b.ask(get_od_list_request{.ul_node_id = 0x100, .ul_list_type = static_cast<packet_list_type>(type)});
        CHECK(answer.status == 0xC0650017);
        CHECK(answer.length == 8);
    }
}

TEST_CASE("an object description is confirmed with its name") {
    bench b;
    CHECK(b.answer_with("0080 04 00 0000 1810 2300 04 09 4964656e74697479", object) ==
          confirmation(36, 0, 0x650019,
                       "00010000 18100000 23000000 09000000 00000000 04000000 08000000 4964656e74697479"));
    CHECK(to_hex(b.asked) == hex_of("0080 03 00 0000 1810"));
    CHECK(b.answer_with("0080 04 00 0000 1810 0700 00 17", object) ==
          confirmation(28, 0, 0x650019, "00010000 18100000 07000000 07000000 01000000 00000000 00000000"));
    CHECK(b.answer_with("0080 04 00 0000 1810 07", object) == // too short to be one
          confirmation(8, 0xC0650029, 0x650019, "00010000 18100000"));
}

TEST_CASE("an entry description is confirmed with unit, values and name") {
    bench b;
    CHECK(b.answer_with("0080 06 00 0000 1810 02 0f 0700 2000 8100 05060708 4e616d65", entry) ==
          confirmation(48, 0, 0x65001B,
                       "00010000 18100000 02000000 0f000000 07000000 20000000 81000000 00000000 01000000"
                       " 05060708 04000000 4e616d65"));
    CHECK(to_hex(b.asked) == hex_of("0080 05 00 0000 1810 02 7f"));
    CHECK(b.answer_with("0080 06 00 0000 1810 02 77 0500 0800 7f03 01 00 ff 4e", entry) == // no unit
          confirmation(48, 0, 0x65001B,
                       "00010000 18100000 02000000 77000000 05000000 08000000 7f030000 01000000 00000000"
                       " 00000000 04000000 0100ff4e"));
    CHECK(b.answer_with("0080 06 00 0000 1810 02 00 0700 2000 0700", entry) ==
          confirmation(44, 0, 0x65001B,
                       "00010000 18100000 02000000 00000000 07000000 20000000 07000000 00000000 00000000"
                       " 00000000 00000000"));
    for (const auto* const too_short :
         {"0080 06 00 0000 1810 02 08 0700 2000 0700 010203", "0080 06 00 0000 1810 02 08 0700 2000 07"})
        CHECK(b.answer_with(too_short, entry) == confirmation(12, 0xC0650029, 0x65001B, "00010000 18100000 02000000"));
}

TEST_CASE("an entry description requests what its mask of seven bits names") {
    bench b;
    const auto status = [&](std::uint32_t mask) {
        b.replies = {from_hex("0080 06 00 0000 1810 02 00 0700 2000 0700")};
        const auto answer = b.ask(get_entry_description_request{
            .ul_node_id = 0x100, .ul_index = 0x1018, .ul_sub_index = 2, .ul_access_bit_mask = mask});
        CHECK(answer.length == (answer.status == 0 ? 44 : 12));
        return answer.status;
    };
    CHECK(status(0) == 0);
    CHECK(b.asked.back() == std::byte{0});
    CHECK(status(0x29) == 0);
    CHECK(b.asked.back() == std::byte{0x29});
    CHECK(status(0x80) == 0xC0650019);
    CHECK(status(0x101) == 0xC0650019);
}

TEST_CASE("an answer can fill the packet, and a longer one is too big") {
    bench b;
    // Two fragments: 700 indices, then the rest.
    const auto list_of = [&](std::size_t indices) {
        bytes first = from_hex("0080 82 00 0100 0100"), second = from_hex("0080 02 00 0000");
        first.resize(first.size() + 1400);
        second.resize(second.size() + 2 * indices - 1400);
        b.replies = {first, second};
        return b.ask(get_od_list_request{.ul_node_id = 0x100, .ul_list_type = packet_list_type::all});
    };
    CHECK(list_of(772).length == 12 + 2 * 772);
    CHECK(list_of(772).status == 0);
    CHECK(list_of(773).status == 0xC0650018);
    CHECK(list_of(773).length == 8);

    const auto described = [&](std::size_t name) {
        bytes first = from_hex("0080 84 00 0100 1810 2300 04 09"), second = from_hex("0080 04 00 0000");
        first.resize(first.size() + 1000);
        second.resize(second.size() + name - 1000);
        b.replies = {first, second};
        return b.ask(get_object_description_request{.ul_node_id = 0x100, .ul_index = 0x1018});
    };
    CHECK(described(1528).length == 28 + 1528);
    CHECK(described(1529).status == 0xC0650018);
    CHECK(described(1529).length == 8);

    const auto entry_of = [&](const char* info, std::size_t values) {
        bytes first = from_hex("0080 86 00 0100 1810 02"), second = from_hex("0080 06 00 0000");
        const auto rest = from_hex(std::string{info} + " 0700 2000 0700");
        first.insert(first.end(), rest.begin(), rest.end());
        first.resize(first.size() + 1000);
        second.resize(second.size() + values - 1000);
        second.back() = std::byte{0xA5};
        b.replies = {first, second};
        return b.ask(get_entry_description_request{.ul_node_id = 0x100, .ul_index = 0x1018, .ul_sub_index = 2});
    };
    CHECK(entry_of("00", 1512).length == 44 + 1512);
    CHECK(entry_of("00", 1512).body.substr(3 * (44 + 1511)) == "a5");
    CHECK(entry_of("08", 4 + 1512).body.substr(3 * (44 + 1511)) == "a5");
    for (const auto& [info, values] : {std::pair{"00", 1513u}, {"08", 1517u}, {"00", 1600u}}) {
        CHECK(entry_of(info, values).status == 0xC0650018);
        CHECK(entry_of(info, values).length == 12);
    }
}

TEST_CASE("a refusal by the slave is confirmed with the abort's status and the request's fields") {
    bench b;
    CHECK(b.answer_with("0080 07 00 0000 00000206", object) ==
          confirmation(8, 0xC0650031, 0x650019, "00010000 18100000"));
    CHECK(b.answer_with("0080 07 00 0000 11000906", entry) ==
          confirmation(12, 0xC065003A, 0x65001B, "00010000 18100000 02000000"));
    CHECK(b.answer_with("0080 07 00 0000 23000008", list) ==
          confirmation(8, 0xC0650043, 0x65000B, "00010000 01000000"));
    b.replies.clear();
    CHECK(b.answer(list) == confirmation(8, 0xC0650015, 0x65000B, "00010000 01000000")); // nothing comes
}

TEST_CASE("an impossible description is not requested") {
    bench b;
    const auto sent = b.master.statistics().sent;
    const auto object_status = [&](std::uint32_t node, std::uint32_t index) {
        return b.ask(get_object_description_request{.ul_node_id = node, .ul_index = index}).status;
    };
    CHECK(object_status(0x10100, 0x1018) == 0xC065000F);
    CHECK(object_status(0x101, 0x1018) == 0xC065000F);
    CHECK(object_status(0x100, 0x11018) == 0xC0000009);
    const auto entry_status = [&](std::uint32_t node, std::uint32_t index, std::uint32_t subindex) {
        return b.ask(get_entry_description_request{.ul_node_id = node, .ul_index = index, .ul_sub_index = subindex})
            .status;
    };
    CHECK(entry_status(0x10100, 0x1018, 0) == 0xC065000F);
    CHECK(entry_status(0x100, 0x11018, 0) == 0xC0000009);
    CHECK(entry_status(0x100, 0x1018, 0x100) == 0xC0000009);
    CHECK(b.ask(get_od_list_request{.ul_node_id = 0x10100, .ul_list_type = packet_list_type::all}).status ==
          0xC065000F);
    CHECK(b.master.statistics().sent == sent);
}
