// The exchange of packets around one message: confirmations, a query's report, acknowledgements.
#include "samples.hpp"
#include "support/catch.hpp"
#include <jauscat/bridge/packet_exchange.hpp>
#include <jauscat/text/packet_status_text.hpp>

#include <random>
#include <set>

using namespace jauscat;
using namespace jauscat::test;
using bridging::exchange_progress;
using hilscher::packet_status;
using translate::errc;

namespace {

using bytes = std::vector<std::byte>;

constexpr bridging::slave_identity arm{.subsystem = 1, .station = 2, .instance = 5};

/// What a step led to, and the bytes it made.
struct step {
    exchange_progress what{};
    bytes made{};
};

/// An exchange with its buffer.
template <class Table> struct conversation {
    bridging::packet_exchange<Table> exchange{arm};
    bytes buffer = bytes(bridging::packet_exchange<Table>::buffer_size);

    step made(bridging::exchange_step s) {
        return {s.what, {buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(s.size)}};
    }
    step begin(std::span<const std::byte> message, const packet& given = {}) {
        return made(exchange.begin(message, buffer, given));
    }
    step confirm(std::span<const std::byte> confirmation) {
        return made(exchange.on_confirmation(confirmation, buffer));
    }
    std::string acknowledgement() {
        std::array<std::byte, 16> out{};
        return to_hex(std::span{out}.first(exchange.acknowledgement(out)));
    }
};
using seed_conversation = conversation<translation::seed_table>;
using self_contained_conversation = conversation<translation::self_contained_table>;

bytes wanting_acknowledgement(bytes message) {
    message[0] |= std::byte{0x10};
    return message;
}
const auto commanding = vector_of(wrench_effort);

/// Answers to the sample under the seed table: ulDest and ulDestId are the request's, ulLen is 0.
const auto download_done = from_hex("01000000 00000000 05000000 00000000 00000000 00000000 00000000 09006500"
                                    " 00000000 00000000");
const auto download_no_object = from_hex("01000000 00000000 05000000 00000000 00000000 00000000 310065c0 09006500"
                                         " 00000000 00000000");

/// Query Wrench Effort to 1.2.33.5 from 4.3.32.2, sequence number 34, and what is exchanged for it.
const auto query = from_hex("0602 0524 05210201 02200304 0200 2200 ff0f");
const auto query_download = from_hex("01000000 00000000 05000000 00000000 1a000000 00000000 00000000 08006500"
                                     " 00000000 00000000 02000000 151b0000 48000000 0a000000"
                                     " 0602 02200304 2200 ff0f");
const auto report_upload = from_hex("01000000 00000000 05000000 00000000 0c000000 00000000 00000000 06006500"
                                    " 00000000 00000000 02000000 151b0000 79000000");
// The arm has written its report to itself: source 1.2.33.5, sequence number 0.
const auto report_uploaded = from_hex("01000000 00000000 05000000 00000000 1b000000 00000000 00000000 07006500"
                                      " 00000000 00000000 02000000 151b0000 79000000 0b000000"
                                      " 0602 05210201 0000 408000");
const auto upload_no_data = from_hex("01000000 00000000 05000000 00000000 0c000000 00000000 440065c0 07006500"
                                     " 00000000 00000000 02000000 151b0000 79000000");
const auto report = from_hex("0602 0544 02200304 05210201 0300 2200 408000");

} // namespace

TEST_CASE("a command is one download, done when confirmed") {
    seed_conversation c;
    const auto request = c.begin(commanding);
    CHECK(request.what == exchange_progress::request);
    CHECK(to_hex(request.made) == to_hex(wrench_effort_seed));
    const auto end = c.confirm(download_done);
    CHECK(end.what == exchange_progress::done);
    CHECK(end.made.empty());
    CHECK(c.exchange.status() == packet_status::ok);
    CHECK(c.acknowledgement().empty()); // none was asked for
}

TEST_CASE("a message with acknowledgement request gets ACK when done, and nothing before") {
    seed_conversation c;
    REQUIRE(c.begin(wanting_acknowledgement(commanding)).what == exchange_progress::request);
    CHECK(c.acknowledgement().empty());
    REQUIRE(c.confirm(download_done).what == exchange_progress::done);
    CHECK(c.acknowledgement() == hex_of("3602 0504 02200304 05210201 0000 2200"));
}

TEST_CASE("a confirmation with an error gives NAK on request, and a text") {
    seed_conversation c;
    REQUIRE(c.begin(wanting_acknowledgement(commanding)).what == exchange_progress::request);
    const auto end = c.confirm(download_no_object);
    CHECK(end.what == exchange_progress::failed);
    CHECK(end.made.empty());
    CHECK(c.exchange.status() == packet_status::sdo_abort_no_object);
    CHECK(c.exchange.error() == errc::ok);
    CHECK(c.acknowledgement() == hex_of("2602 0504 02200304 05210201 0000 2200"));
    CHECK(text::explain(c.exchange.status()) ==
          "no such object in the dictionary (ulSta 0xC0650031, abort code 0x06020000)");

    REQUIRE(c.begin(commanding).what == exchange_progress::request);
    REQUIRE(c.confirm(download_no_object).what == exchange_progress::failed);
    CHECK(c.acknowledgement().empty());
}

TEST_CASE("a query is downloaded to its own subindex, and its report is uploaded and sent to the asker") {
    seed_conversation c;
    CHECK(to_hex(c.begin(query).made) == to_hex(query_download));
    const auto upload = c.confirm(download_done);
    CHECK(upload.what == exchange_progress::request);
    CHECK(to_hex(upload.made) == to_hex(report_upload));
    const auto end = c.confirm(report_uploaded);
    CHECK(end.what == exchange_progress::done);
    CHECK(to_hex(end.made) == to_hex(report));
    CHECK(c.acknowledgement().empty());
}

TEST_CASE("under the self-contained table the report of a query is also sent to the asker") {
    self_contained_conversation c;
    CHECK(to_hex(c.begin(query).made) ==
          hex_of("20000000 00000000 00000000 00000000 1e000000 00000000 00000000 08006500 00000000 00000000"
                 " 02000000 151b0000 48000000 0e000000 0602 05 01 02200304 0200 2200 ff0f"));
    const auto upload = c.confirm(from_hex("20000000 00000000 00000000 00000000 00000000 00000000 00000000 09006500"
                                           " 00000000 00000000"));
    CHECK(to_hex(upload.made) ==
          hex_of("20000000 00000000 00000000 00000000 0c000000 00000000 00000000 06006500 00000000 00000000"
                 " 02000000 151b0000 79000000"));
    const auto end = c.confirm(from_hex("20000000 00000000 00000000 00000000 1f000000 00000000 00000000 07006500"
                                        " 00000000 00000000 02000000 151b0000 79000000 0f000000"
                                        " 0602 05 01 05210201 0300 0000 408000"));
    CHECK(end.what == exchange_progress::done);
    CHECK(to_hex(end.made) == to_hex(report));
}

TEST_CASE("a query with acknowledgement request is acknowledged with its report, and gets NAK without one") {
    seed_conversation c;
    REQUIRE(c.begin(wanting_acknowledgement(query)).what == exchange_progress::request);
    REQUIRE(c.confirm(download_done).what == exchange_progress::request);
    CHECK(c.acknowledgement().empty());
    REQUIRE(c.confirm(report_uploaded).what == exchange_progress::done);
    CHECK(c.acknowledgement() == hex_of("3602 0524 02200304 05210201 0000 2200"));

    REQUIRE(c.begin(wanting_acknowledgement(query)).what == exchange_progress::request);
    REQUIRE(c.confirm(download_done).what == exchange_progress::request);
    CHECK(c.confirm(upload_no_data).what == exchange_progress::failed);
    CHECK(c.exchange.status() == packet_status::sdo_abort_unknown);
    CHECK(c.acknowledgement() == hex_of("2602 0524 02200304 05210201 0000 2200"));
}

TEST_CASE("the caller's fields are in every request, and identify its confirmations") {
    seed_conversation c;
    packet given{};
    given.head.ul_src = 0x11;
    given.head.ul_src_id = 0x22;
    given.head.ul_id = 0x33;
    const auto mine = [](bytes confirmation) {
        set(confirmation, word::ul_src, 0x11);
        set(confirmation, word::ul_src_id, 0x22);
        set(confirmation, word::ul_id, 0x33);
        return confirmation;
    };
    CHECK(to_hex(c.begin(query, given).made) == to_hex(mine(query_download)));
    CHECK(c.confirm(download_done).what == exchange_progress::ignored);
    for (const auto at : {word::ul_src, word::ul_src_id, word::ul_id, word::ul_cmd})
        CHECK(c.confirm(with(mine(download_done), at, 0x44)).what == exchange_progress::ignored);
    CHECK(c.confirm(mine(report_uploaded)).what == exchange_progress::ignored); // nothing was uploaded yet
    CHECK(to_hex(c.confirm(mine(download_done)).made) == to_hex(mine(report_upload)));
    CHECK(c.confirm(mine(download_done)).what == exchange_progress::ignored);
    CHECK(c.confirm(mine(report_uploaded)).what == exchange_progress::done);
    CHECK(c.confirm(mine(report_uploaded)).what == exchange_progress::ignored);
}

TEST_CASE("no confirmation is expected before an exchange begins, and one shorter than a packet header is ignored") {
    seed_conversation c;
    CHECK(c.confirm(download_done).what == exchange_progress::ignored);
    REQUIRE(c.begin(commanding).what == exchange_progress::request);
    for (std::size_t size = 0; size != download_done.size(); ++size)
        CHECK(c.confirm(std::span{download_done}.first(size)).what == exchange_progress::ignored);
    CHECK(c.confirm(download_done).what == exchange_progress::done);
}

TEST_CASE("a message that cannot be delivered fails at once, with NAK on request") {
    const auto asking = wanting_acknowledgement(commanding);
    const auto refused = [](bytes message) {
        seed_conversation c;
        const auto begun = c.begin(message);
        CHECK(begun.what == exchange_progress::failed);
        CHECK(begun.made.empty());
        CHECK(c.confirm(download_done).what == exchange_progress::ignored);
        return std::pair{c.exchange.error(), c.acknowledgement()};
    };
    const auto changed = [&](std::size_t at, unsigned value) {
        auto message = asking;
        message[at] = static_cast<std::byte>(value);
        return message;
    };
    const auto nak = hex_of("2602 0504 02200304 05210201 0000 2200");
    CHECK(refused(changed(13, 0x10)) == std::pair{errc::fragment_to_slave, nak});
    CHECK(refused(changed(12, 0x13)) == std::pair{errc::wrong_size, nak});
    CHECK(refused(changed(6, 255)) == std::pair{errc::broadcast_names_no_slave, nak});         // from the slave at hand
    CHECK(refused(changed(6, 0)) == std::pair{errc::broadcast_names_no_slave, std::string{}}); // 0 is nobody
    CHECK(refused(changed(3, 0x99)) ==
          std::pair{errc::unknown_command_code, hex_of("2602 0599 02200304 05210201 0000 2200")});
    CHECK(refused({asking.begin(), asking.begin() + 15}) == std::pair{errc::truncated, std::string{}});
    CHECK(refused(wanting_acknowledgement(message_with_body(seed::max_body + 1))) == std::pair{errc::too_large, nak});
}

TEST_CASE("an uploaded object that is not a report fails with the reason") {
    const auto failure = [](const bytes& confirmation) {
        seed_conversation c;
        c.begin(query);
        c.confirm(download_done);
        CHECK(c.confirm(confirmation).what == exchange_progress::failed);
        return c.exchange.error();
    };
    CHECK(failure(bytes(report_uploaded.begin(), report_uploaded.begin() + 55)) == errc::truncated);
    CHECK(failure(bytes(report_uploaded.begin(), report_uploaded.end() - 1)) == errc::truncated);
    CHECK(failure(with(report_uploaded, word::ul_data_cnt, 12)) == errc::truncated);
    CHECK(failure(with(report_uploaded, word::ul_data_cnt, 0xFFFFFFFF)) == errc::truncated);
    CHECK(failure(with(report_uploaded, word::ul_data_cnt, 7)) == errc::truncated); // ends within the source
    CHECK(failure(with(report_uploaded, word::ul_node_id, 3)) == errc::wrong_packet);
    CHECK(failure(with(report_uploaded, word::ul_index, 6934)) == errc::wrong_packet);
    CHECK(failure(with(report_uploaded, word::ul_sub_index, 120)) == errc::wrong_packet);
}

namespace {
constexpr std::array<std::uint16_t, 1> query_alone{0x2405};
} // namespace

TEST_CASE("a query whose report has no rank in the table fails when the report is requested") {
    conversation<translation::seed_table_of<6900, query_alone>::type> c;
    REQUIRE(c.begin(query).what == exchange_progress::request);
    CHECK(c.confirm(download_done).what == exchange_progress::failed);
    CHECK(c.exchange.error() == errc::unknown_command_code);
}

TEST_CASE("an answer has no broadcast source: octets of 255 become the slave's own, the component the report's") {
    auto to_all = wanting_acknowledgement(query);
    to_all[4] = to_all[5] = to_all[7] = std::byte{255};
    auto uploaded = with(with(report_uploaded, word::ul_dest, 255), word::ul_dest_id, 255);
    set(uploaded, word::ul_index, 6900 + 255);
    seed_conversation c;
    REQUIRE(c.begin(to_all).what == exchange_progress::request);
    REQUIRE(c.confirm(download_done).what == exchange_progress::request);
    const auto end = c.confirm(uploaded);
    REQUIRE(end.what == exchange_progress::done);
    CHECK(to_hex(end.made) == to_hex(report)); // from 1.2.33.5
    CHECK(c.acknowledgement().empty());        // which component acknowledges is not known

    // A slave that says it is every component has told nothing.
    uploaded[59] = std::byte{255};
    c.begin(to_all);
    c.confirm(download_done);
    CHECK(c.confirm(uploaded).what == exchange_progress::failed);
    CHECK(c.exchange.error() == errc::out_of_range);

    auto command_to_instances = wanting_acknowledgement(commanding);
    command_to_instances[4] = std::byte{255};
    c.begin(command_to_instances);
    REQUIRE(c.confirm(download_done).what == exchange_progress::done);
    CHECK(c.acknowledgement() == hex_of("3602 0504 02200304 05210201 0000 2200"));
}

TEST_CASE("with random confirmations a step stays within the buffer, and a report is a message to the asker") {
    std::mt19937 random{2011};
    int reports = 0, failures = 0, ignored = 0;
    for (int i = 0; i != 20'000; ++i) {
        seed_conversation c;
        REQUIRE(c.begin(query).what == exchange_progress::request);
        REQUIRE(c.confirm(download_done).what == exchange_progress::request);
        auto confirmation = random() % 4 == 0 ? upload_no_data : report_uploaded;
        for (auto changes = random() % 4; changes != 0; --changes)
            confirmation[random() % confirmation.size()] = static_cast<std::byte>(random());
        if (random() % 4 == 0) confirmation.resize(random() % 100, std::byte{0xA5});
        const auto s = c.exchange.on_confirmation(confirmation, c.buffer);
        REQUIRE(s.size <= c.buffer.size());
        REQUIRE(s.what != exchange_progress::request);
        failures += s.what == exchange_progress::failed;
        ignored += s.what == exchange_progress::ignored;
        if (s.what != exchange_progress::done) continue;
        ++reports;
        const auto told = jaus::split(std::span{c.buffer}.first(s.size));
        const bool other_version = told.error == jaus::errc::wrong_version; // the slave's own word
        REQUIRE((told || other_version));
        REQUIRE(told.header.destination == jaus::address{2, 32, 3, 4});
        REQUIRE(told.header.source == jaus::address{5, 33, 2, 1});
        REQUIRE(told.header.command_code == 0x4405);
        REQUIRE(told.header.sequence_number == 34);
    }
    CHECK(reports > 2000);
    CHECK(failures > 2000);
    CHECK(ignored > 1000);
}

TEST_CASE("abort codes and ulSta correspond as in the manuals") {
    using ethercat::abort_code;
    const std::pair<std::uint32_t, std::uint32_t> listed[]{
        {0x05030000, 0xC0650027}, {0x05040000, 0xC0650028}, {0x05040001, 0xC0650029}, {0x05040002, 0xC065002A},
        {0x05040003, 0xC065002B}, {0x05040004, 0xC065002C}, {0x05040005, 0xC065002D}, {0x06010000, 0xC065002E},
        {0x06010001, 0xC065002F}, {0x06010002, 0xC0650030}, {0x06020000, 0xC0650031}, {0x06040041, 0xC0650032},
        {0x06040042, 0xC0650033}, {0x06040043, 0xC0650034}, {0x06040047, 0xC0650035}, {0x06060000, 0xC0650036},
        {0x06070010, 0xC0650037}, {0x06070012, 0xC0650038}, {0x06070013, 0xC0650039}, {0x06090011, 0xC065003A},
        {0x06090030, 0xC065003B}, {0x06090031, 0xC065003C}, {0x06090032, 0xC065003D}, {0x06090036, 0xC065003E},
        {0x08000000, 0xC065003F}, {0x08000020, 0xC0650040}, {0x08000021, 0xC0650041}, {0x08000022, 0xC0650042},
        {0x08000023, 0xC0650043}};
    for (const auto& [abort, status] : listed) {
        CAPTURE(abort);
        CHECK(static_cast<std::uint32_t>(hilscher::status_of(static_cast<abort_code>(abort))) == status);
        CHECK(static_cast<std::uint32_t>(hilscher::abort_of(static_cast<packet_status>(status))) == abort);
    }
    for (const std::uint32_t other : {0x06010003u, 0x06010006u, 0x06090033u, 0x060A0023u, 0x08000024u, 0x12345678u}) {
        CAPTURE(other);
        CHECK(static_cast<std::uint32_t>(hilscher::status_of(static_cast<abort_code>(other))) == 0xC0650044);
    }
    CHECK(hilscher::status_of(abort_code::none) == packet_status::ok);
    CHECK(hilscher::abort_of(packet_status::ok) == abort_code::none);
    CHECK(hilscher::abort_of(packet_status::sdo_abort_unknown) == abort_code::none);
    CHECK(hilscher::abort_of(packet_status::coe_timeout) == abort_code::none);
}

TEST_CASE("every status of an SDO service has its text, and others are reported as unknown") {
    std::set<std::string_view> texts;
    std::size_t codes = 0;
    for (const std::uint32_t family : {0xC0000000u, 0xC0650000u})
        for (std::uint32_t n = 0; n != 0x80; ++n) {
            const auto text = describe(static_cast<packet_status>(family + n));
            if (text == "unknown status") continue;
            ++codes;
            texts.insert(text);
        }
    CHECK(codes == 62);
    CHECK(texts.size() == codes);
    CHECK(text::explain(packet_status::coe_timeout) == "the slave did not answer in time (ulSta 0xC0650015)");
    CHECK(text::explain(static_cast<packet_status>(0xC0DE)) == "unknown status (ulSta 0x0000C0DE)");
}
