// Questions about a slave's objects: the messages byte for byte, fragments, refusals.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/ethercat/sdo_information.hpp>
#include <jauscat/ethercat/sdo_transfer.hpp>

#include <string>
#include <vector>

using namespace jauscat::ethercat;
using jauscat::test::from_hex;
using jauscat::test::to_hex;

namespace {

using bytes = std::vector<std::byte>;

std::string encoded(const auto& question) {
    bytes out(question.size());
    question.encode(out);
    return to_hex(out);
}
mail take(auto& protocol, const char* hex) {
    const auto message = from_hex(hex);
    return protocol.take(message);
}

} // namespace

TEST_CASE("questions about objects are the standard's byte for byte") {
    CHECK(encoded(sdo_information::list(object_list_type::all, {})) == "00 80 01 00 00 00 01 00");
    CHECK(encoded(sdo_information::list(object_list_type::tx_pdo, {})) == "00 80 01 00 00 00 03 00");
    CHECK(encoded(sdo_information::object(0x1018, {})) == "00 80 03 00 00 00 18 10");
    CHECK(encoded(sdo_information::entry({0x1018, 2, 7}, {})) == "00 80 05 00 00 00 18 10 02 07");
}

TEST_CASE("a list comes in one message or in fragments, and its type is left out") {
    bytes into(8);
    auto whole = sdo_information::list(object_list_type::all, into);
    REQUIRE(take(whole, "0080 02 00 0000 0100 0010 1810") == mail::final);
    CHECK(whole.result() == outcome{.size = 4});
    CHECK(to_hex(into) == "00 10 18 10 00 00 00 00");

    auto parts = sdo_information::list(object_list_type::all, into);
    REQUIRE(take(parts, "0080 82 00 0200 0100 0010") == mail::more);
    REQUIRE(take(parts, "0080 82 00 0100 0810 0910") == mail::more);
    REQUIRE(take(parts, "0080 02 00 0000 1810") == mail::final);
    CHECK(parts.result() == outcome{.size = 8});
    CHECK(to_hex(into) == "00 10 08 10 09 10 18 10");
}

TEST_CASE("a fragment that is missing or comes twice is noticed") {
    bytes into(20);
    auto missing = sdo_information::list(object_list_type::all, into);
    REQUIRE(take(missing, "0080 82 00 0200 0100 0010") == mail::more);
    REQUIRE(take(missing, "0080 02 00 0000 1810") == mail::final);
    CHECK(missing.result() == outcome{.error = master_errc::fragment_missing, .detail = 1});

    auto twice = sdo_information::list(object_list_type::all, into);
    REQUIRE(take(twice, "0080 82 00 0200 0100 0010") == mail::more);
    REQUIRE(take(twice, "0080 82 00 0200 0100 0010") == mail::final);
    CHECK(twice.result().error == master_errc::fragment_missing);
}

TEST_CASE("descriptions are taken for the object that was asked for, and for no other") {
    bytes into(40);
    auto object = sdo_information::object(0x1018, into);
    CHECK(take(object, "0080 04 00 0000 0010 0700 00 07 41") == mail::other);
    CHECK(take(object, "0080 06 00 0000 1810 0107 0700 2000 0700") == mail::other);
    CHECK(take(object, "0030 60 1810 02 00000000") == mail::other);
    REQUIRE(take(object, "0080 04 00 0000 1810 2300 04 09 4944") == mail::final);
    CHECK(object.result() == outcome{.size = 8});

    auto entry = sdo_information::entry({0x1018, 2, 7}, into);
    CHECK(take(entry, "0080 06 00 0000 1810 0107 0700 2000 0700") == mail::other);
    REQUIRE(take(entry, "0080 06 00 0000 1810 0207 0700 2000 0700 50") == mail::final);
    CHECK(entry.result() == outcome{.size = 11});
    entry_answer answer{};
    REQUIRE(jauscat::wire::decode_prefix(answer, into));
    CHECK(answer.bits == 32);
    CHECK(answer.access.read_op);
    CHECK_FALSE(answer.access.write_pre_op);
}

TEST_CASE("a refusal ends the question with the slave's abort code, and short answers are passed over") {
    bytes into(4);
    auto object = sdo_information::object(0x7000, into);
    CHECK(take(object, "") == mail::other);
    CHECK(take(object, "0080") == mail::other);
    CHECK(take(object, "0080 04 00 00") == mail::other);
    CHECK(take(object, "0080 04 00 0000 00") == mail::other);
    REQUIRE(take(object, "0080 07 00 0000 00000206") == mail::final);
    CHECK(object.result() == outcome{.error = master_errc::sdo_abort, .detail = 0x06020000});

    auto large = sdo_information::object(0x1018, into);
    REQUIRE(take(large, "0080 04 00 0000 1810 2300 04 09 4944") == mail::final);
    CHECK(large.result() == outcome{.error = master_errc::data_too_long, .detail = 4});
}

TEST_CASE("complete access is a bit of the request, and its answer may name any subindex") {
    const auto data = from_hex("0100 1100 0016");
    auto download = sdo_transfer::download(0x1C12, 0, data, {.complete_access = true});
    CHECK(encoded(download) == "00 20 31 12 1c 00 06 00 00 00 01 00 11 00 00 16");
    CHECK(take(download, "0030 70 121c 01 00000000") == mail::final);
    CHECK(download.result());

    bytes into(10);
    auto upload = sdo_transfer::upload(0x1C12, 1, into, {.complete_access = true});
    CHECK(encoded(upload) == "00 20 50 12 1c 01 00 00 00 00");
    CHECK(take(upload, "0030 53 121c 01 01020304") == mail::final);
    CHECK(upload.result() == outcome{.size = 4});

    auto refused = sdo_transfer::upload(0x1C12, 0, into, {.complete_access = true});
    CHECK(take(refused, "0020 90 121c 00 04000106") == mail::final);
    CHECK(refused.result() == outcome{.error = master_errc::sdo_abort, .detail = 0x06010004});
}
