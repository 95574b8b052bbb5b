// Questions about a slave's objects: the messages byte for byte, fragments, refusals.
#include "ethercat/described_objects.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/simulated_link.hpp"
#include <jauscat/ethercat/master/sdo_information.hpp>
#include <jauscat/ethercat/master/sdo_transfer.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>

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
reply_kind take(auto& protocol, const char* hex) {
    const auto message = from_hex(hex);
    return protocol.take(message);
}

} // namespace

TEST_CASE("object queries equal the standard's byte for byte") {
    CHECK(encoded(sdo_information::list(object_list_type::all, {})) == "00 80 01 00 00 00 01 00");
    CHECK(encoded(sdo_information::list(object_list_type::tx_pdo, {})) == "00 80 01 00 00 00 03 00");
    CHECK(encoded(sdo_information::object(0x1018, {})) == "00 80 03 00 00 00 18 10");
    CHECK(encoded(sdo_information::entry({0x1018, 2, 7}, {})) == "00 80 05 00 00 00 18 10 02 07");
}

TEST_CASE("a list arrives in one message or in fragments, without its type") {
    bytes into(8);
    auto whole = sdo_information::list(object_list_type::all, into);
    REQUIRE(take(whole, "0080 02 00 0000 0100 0010 1810") == reply_kind::complete);
    CHECK(whole.result() == master_result<std::size_t>{4});
    CHECK(to_hex(into) == "00 10 18 10 00 00 00 00");

    auto parts = sdo_information::list(object_list_type::all, into);
    REQUIRE(take(parts, "0080 82 00 0200 0100 0010") == reply_kind::fragment);
    REQUIRE(take(parts, "0080 82 00 0100 0810 0910") == reply_kind::fragment);
    REQUIRE(take(parts, "0080 02 00 0000 1810") == reply_kind::complete);
    CHECK(parts.result() == master_result<std::size_t>{8});
    CHECK(to_hex(into) == "00 10 08 10 09 10 18 10");
}

TEST_CASE("a missing or duplicate fragment is detected") {
    bytes into(20);
    auto missing = sdo_information::list(object_list_type::all, into);
    REQUIRE(take(missing, "0080 82 00 0200 0100 0010") == reply_kind::fragment);
    REQUIRE(take(missing, "0080 02 00 0000 1810") == reply_kind::complete);
    CHECK(missing.result().error() == master_error{.code = master_errc::fragment_missing, .fragments = 1});

    auto twice = sdo_information::list(object_list_type::all, into);
    REQUIRE(take(twice, "0080 82 00 0200 0100 0010") == reply_kind::fragment);
    REQUIRE(take(twice, "0080 82 00 0200 0100 0010") == reply_kind::complete);
    CHECK(twice.result().error().code == master_errc::fragment_missing);
}

TEST_CASE("more fragments than the buffer can need are refused at once") {
    bytes into(80);
    auto many = sdo_information::list(object_list_type::all, into);
    REQUIRE(take(many, "0080 82 00 ffff 0100") == reply_kind::complete);
    CHECK(many.result().error() == master_error{.code = master_errc::too_many_fragments, .fragments = 0xFFFF});

    auto most = sdo_information::list(object_list_type::all, into);
    REQUIRE(take(most, "0080 82 00 0c00 0100") == reply_kind::fragment);
    auto one_more = sdo_information::list(object_list_type::all, into);
    REQUIRE(take(one_more, "0080 82 00 0d00 0100") == reply_kind::complete);
    CHECK(one_more.result().error().code == master_errc::too_many_fragments);
}

TEST_CASE("a description counts only for the object that was requested") {
    bytes into(40);
    auto object = sdo_information::object(0x1018, into);
    CHECK(take(object, "0080 04 00 0000 0010 0700 00 07 41") == reply_kind::unrelated);
    CHECK(take(object, "0080 06 00 0000 1810 0107 0700 2000 0700") == reply_kind::unrelated);
    CHECK(take(object, "0030 60 1810 02 00000000") == reply_kind::unrelated);
    REQUIRE(take(object, "0080 04 00 0000 1810 2300 04 09 4944") == reply_kind::complete);
    CHECK(object.result() == master_result<std::size_t>{8});

    auto entry = sdo_information::entry({0x1018, 2, 7}, into);
    CHECK(take(entry, "0080 06 00 0000 1810 0107 0700 2000 0700") == reply_kind::unrelated);
    REQUIRE(take(entry, "0080 06 00 0000 1810 0207 0700 2000 0700 50") == reply_kind::complete);
    CHECK(entry.result() == master_result<std::size_t>{11});
    entry_answer answer{};
    REQUIRE(jauscat::wire::decode_prefix(answer, into));
    CHECK(answer.bits == 32);
    CHECK(answer.access.read_op);
    CHECK_FALSE(answer.access.write_pre_op);
}

TEST_CASE("a refusal ends the query with the slave's abort code, and short answers are ignored") {
    bytes into(4);
    auto object = sdo_information::object(0x7000, into);
    CHECK(take(object, "") == reply_kind::unrelated);
    CHECK(take(object, "0080") == reply_kind::unrelated);
    CHECK(take(object, "0080 04 00 00") == reply_kind::unrelated);
    CHECK(take(object, "0080 04 00 0000 00") == reply_kind::unrelated);
    REQUIRE(take(object, "0080 07 00 0000 00000206") == reply_kind::complete);
    CHECK(object.result().error() == master_error{.code = master_errc::sdo_abort, .abort = abort_code{0x06020000}});

    auto large = sdo_information::object(0x1018, into);
    REQUIRE(take(large, "0080 04 00 0000 1810 2300 04 09 4944") == reply_kind::complete);
    CHECK(large.result().error() == master_error{.code = master_errc::data_too_long, .bytes = 4});
}

TEST_CASE("complete access is a bit of the request, and its answer may have any subindex") {
    const auto data = from_hex("0100 1100 0016");
    auto download = sdo_transfer::download(0x1C12, 0, data, {.complete_access = true});
    CHECK(encoded(download) == "00 20 31 12 1c 00 06 00 00 00 01 00 11 00 00 16");
    CHECK(take(download, "0030 70 121c 01 00000000") == reply_kind::complete);
    CHECK(download.result());

    bytes into(10);
    auto upload = sdo_transfer::upload(0x1C12, 1, into, {.complete_access = true});
    CHECK(encoded(upload) == "00 20 50 12 1c 01 00 00 00 00");
    CHECK(take(upload, "0030 53 121c 01 01020304") == reply_kind::complete);
    CHECK(upload.result() == master_result<std::size_t>{4});

    auto refused = sdo_transfer::upload(0x1C12, 0, into, {.complete_access = true});
    CHECK(take(refused, "0020 90 121c 00 04000106") == reply_kind::complete);
    CHECK(refused.result().error() == master_error{.code = master_errc::sdo_abort, .abort = abort_code{0x06010004}});
}

namespace {

// A slave that describes itself, on a link that may be bad.
struct bench {
    slave_description description;
    jauscat::test::described_objects objects{};
    standard_objects dictionary;
    bytes memory = bytes(200);
    std::array<slave, 1> devices;
    jauscat::test::simulated_link link{devices};
    master_for<16> master{
        {.frame_timeout = std::chrono::milliseconds{1}, .frame_lifetime = std::chrono::milliseconds{3}}};

    explicit bench(std::uint16_t mailbox)
        : description{.mailbox_out_size = mailbox, .mailbox_in_size = mailbox},
          dictionary{description, objects},
          devices{slave{description, dictionary, {.transfer_memory = memory}}} {
        REQUIRE(link.run(master, bring_up{0, 1}));
    }
    template <master_job Job> typename Job::result_type run(const Job& job) { return link.run(master, job); }
};

} // namespace

TEST_CASE("a master reads a slave's object list at every mailbox size") {
    for (const auto mailbox : std::to_array<std::uint16_t>({24, 30, 64, 128, 1486})) {
        INFO("mailbox of " << mailbox);
        bench b{mailbox};
        bytes into(100);
        const auto listed = b.run(list_objects{1, object_list_type::all, into});
        REQUIRE(listed);
        CHECK(to_hex(listed->bytes()) == "00 10 08 10 18 10 00 1c 00 20 01 20 02 20 03 20 00 30");

        const auto described = b.run(describe_object{1, 0x3000, into});
        REQUIRE(described);
        CHECK(to_hex(described->bytes) == "00 30 00 00 04 09 6d 69 78 74 75 72 65");

        const auto entry = b.run(describe_entry{1, 0x3000, 3, 7, into});
        REQUIRE(entry);
        CHECK(to_hex(entry->bytes) == "00 30 03 07 05 00 10 00 3f 00 70 61 72 74");

        CHECK(b.run(describe_object{1, 0x7000, into}).error() ==
              master_error{.code = master_errc::sdo_abort, .abort = abort_code{0x06020000}});
        CHECK(b.run(list_objects{1, object_list_type::all, std::span{into}.first(10)}).error().code ==
              master_errc::data_too_long);
        const auto again = b.run(list_objects{1, object_list_type::all, into});
        REQUIRE(again);
        CHECK(to_hex(again->bytes()) == to_hex(listed->bytes()));
    }
}

TEST_CASE("a whole object is read or written in one transfer") {
    for (const auto mailbox : std::to_array<std::uint16_t>({24, 128})) {
        bench b{mailbox};
        bytes into(100);
        const auto all = b.run(upload{1, 0x1018, 0, into, {.complete_access = true}});
        REQUIRE(all);
        CHECK(all->size() == 2 + 4 * 4);
        CHECK(to_hex(std::span{into}.first(2)) == "04 00");

        const auto mixture = b.run(upload{1, 0x3000, 1, into, {.complete_access = true}});
        REQUIRE(mixture);
        const bytes before(mixture->begin(), mixture->end());
        CHECK(b.run(download{1, 0x3000, 1, before, {.complete_access = true}}));
        CHECK(b.run(download{1, 0x3000, 1, from_hex("01"), {.complete_access = true}}).error() ==
              master_error{.code = master_errc::sdo_abort, .abort = abort_code{0x06070010}});
    }
}

TEST_CASE("over a bad link a list is correct or absent") {
    bench b{24};
    b.link.faults = {.lose = 10, .duplicate = 10, .delay = 20};
    bytes into(100);
    unsigned good = 0;
    for (int i = 0; i != 1'000; ++i) {
        const auto result = b.run(list_objects{1, object_list_type::all, into});
        if (!result) {
            // After a question was given up, an answer with its counter may be taken for a late one, and passed over.
            CHECK(
                (result.error().code == master_errc::no_reply || result.error().code == master_errc::mailbox_timeout));
            continue;
        }
        ++good;
        REQUIRE(to_hex(result->bytes()) == "00 10 08 10 18 10 00 1c 00 20 01 20 02 20 03 20 00 30");
    }
    CHECK(good > 990);
}
