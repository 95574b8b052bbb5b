// Variants, constants and embedded messages as text and JSON.
#include "support/bytes.hpp"
#include "support/catch.hpp"
#include <jauscat/schema/sae/core/events.hpp>
#include <jauscat/schema/sae/mobility/gps_fix.hpp>
#include <jauscat/text/annotate.hpp>
#include <jauscat/text/from_text.hpp>
#include <jauscat/text/json.hpp>
#include <jauscat/text/print.hpp>

#include <string>

namespace {

namespace text = jauscat::text;
namespace wire = jauscat::wire;
namespace core = jauscat::sae::core;
namespace mobility = jauscat::sae::mobility;
using support::bytes;

const mobility::report_gps_fix with_variant{
    .gps_fix_rec = {.gps_fix_time_seconds = 1, .gps_fix_time_nano_seconds = 2},
    .gps_status_var =
        mobility::min_gps_rec{.gps_validity = mobility::gps_validity::valid, .gps_magnetic_variation = -90}};
constexpr auto encoded_variant = bytes(0x28, 0x44, 1, 0, 1, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0, 0, 0, 0);

struct memory {
    alignas(8) std::array<std::byte, 1000> bytes{};
    wire::arena arena{bytes};
};

} // namespace

TEST_CASE("annotate names the constant, the variant's index and its fields") {
    CHECK(text::annotate<mobility::report_gps_fix>(encoded_variant) == R"(  0000  28 44         message_id = 0x4428
  0002  01            presence_vector = 0x01
  0003  00            gps_fix_rec.presence_vector = 0x00
  0004  01 00 00 00   gps_fix_rec.gps_fix_time_seconds = 1 second
  0008  02 00 00 00   gps_fix_rec.gps_fix_time_nano_seconds = 2
  000c  00            gps_status_var.index = 0
  000d  01            gps_status_var.gps_validity = valid (1)
  000e  00 00 00 00   gps_status_var.gps_magnetic_variation = -90 degree (raw 0)
)");
}

TEST_CASE("annotate accepts a value outside its value set") {
    auto in = encoded_variant;
    in[13] = std::byte{7};
    CHECK(text::annotate<mobility::report_gps_fix>(in).find(
              "gps_status_var.gps_validity = 0x07 (outside its values)\n") != std::string::npos);
    CHECK(text::to_text(wire::diagnose<mobility::report_gps_fix>(in)) ==
          "outside value set: the standard does not define this value: gps_status_var.gps_validity at byte 13");
}

TEST_CASE("a variant prints the name of its alternative") {
    CHECK(text::to_text(with_variant) == R"(  presence_vector = 0x01
  gps_fix_rec
    presence_vector = 0x00
    gps_fix_time_seconds = 1 second
    gps_fix_time_nano_seconds = 2
  gps_status_var = min_gps_rec
    gps_validity = valid (1)
    gps_magnetic_variation = -90 degree (raw 0)
)");
}

TEST_CASE("a variant is an object of its alternative in JSON") {
    const auto json = text::to_json(with_variant);
    CHECK(json.at("gps_status_var").dump() ==
          R"({"min_gps_rec":{"gps_validity":1,"gps_magnetic_variation":{"value":-90.0,"raw":0}}})");
    memory lent;
    mobility::report_gps_fix found{};
    REQUIRE(text::from_json(json, found, lent.arena));
    CHECK(found == with_variant);
}

TEST_CASE("JSON of a variant names one known alternative") {
    const auto why = [](const char* status) {
        auto json = text::to_json(with_variant);
        json["gps_status_var"] = text::json::parse(status);
        memory lent;
        mobility::report_gps_fix found{};
        return text::from_json(json, found, lent.arena).error().message;
    };
    CHECK(why(R"({"min_gps_recs": {}})") ==
          "gps_status_var has no alternative 'min_gps_recs'; did you mean min_gps_rec?");
    CHECK(why(R"({"min_gps_rec": {}, "alt_gps_rec": {}})") == "gps_status_var has more than one alternative");
    CHECK(why("[]") == "gps_status_var is one of several structures: an object with the name of one of them");
    CHECK(why(R"({"min_gps_rec": {"gps_magnetic_variation": 0}})") ==
          "gps_status_var.min_gps_rec.gps_validity is missing");
}

TEST_CASE("an embedded message is hex in text and JSON") {
    constexpr auto query = bytes(0x02, 0x20);
    const core::create_event made{.request_id = 1, .query_message = wire::embedded_message{query}};
    CHECK(text::to_text(made).find("query_message = 2 bytes: 02 20") != std::string::npos);
    const auto json = text::to_json(made);
    CHECK(json.at("query_message") == "0220");
    memory lent;
    core::create_event found{};
    REQUIRE(text::from_json(json, found, lent.arena));
    CHECK(wire::blob{found.query_message.bytes()} == wire::blob{query});
}
