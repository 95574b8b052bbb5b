// Messages with the constructs of JSIDL, from any bytes: an error, or a message that encodes and comes back; a raw
// message, a view and diagnose agree.
#include "support/target.hpp"
#include <jauscat/schema/sae/core/events.hpp>
#include <jauscat/schema/sae/core/list_manager.hpp>
#include <jauscat/schema/sae/environment_sensing/range_sensor.hpp>
#include <jauscat/schema/sae/message_id.hpp>
#include <jauscat/schema/sae/mobility/gps_fix.hpp>
#include <jauscat/schema/sae/mobility/local_operating_zone.hpp>
#include <jauscat/wire/wire.hpp>

using namespace fuzz;
namespace wire = jauscat::wire;
using wire::errc;

namespace {

template <class T> byte_vector encoded(const T& value) {
    byte_vector out(wire::encoded_size(value));
    const auto written = wire::encode(value, out, wire::tolerate_values);
    check(written && written->size() == out.size(), "what decodes encodes, in as many bytes as encoded_size says");
    return out;
}

template <class T> void check_message(std::span<const std::byte> body) {
    const byte_vector bytes = copy_of(body);
    wire::arena& memory = fresh_arena();
    T value{}, tolerated{};
    const errc strict = wire::decode(value, bytes, memory).error();
    const errc error = wire::decode(tolerated, bytes, memory, wire::tolerate_values).error();
    wire::raw<T> raw{};
    const errc raw_error = wire::decode(raw, bytes, memory).error();
    if (strict == errc::arena_full || error == errc::arena_full || raw_error == errc::arena_full) return;
    check(wire::diagnose<T>(bytes).error == strict, "diagnose names the error of decode");
    check(strict == error || (error == errc::ok && strict == errc::outside_value_set),
          "only values outside their value sets are tolerated");
    check(raw_error == error, "message and raw are refused for the same reason");
    const errc view_error = wire::view<T>{bytes}.error();
    check(error != errc::ok || view_error == errc::ok, "a view accepts what decodes");
    if (error != errc::ok) return;
    check(wire::check_values(tolerated) == strict, "check_values and decode agree");
    byte_vector raw_bytes(bytes.size());
    check(wire::encode(raw, raw_bytes) && wire::encoded_size(raw) == bytes.size(),
          "a raw message has the size of the bytes");
    const byte_vector again = encoded(tolerated);
    T other{};
    const errc other_error = wire::decode(other, again, memory, wire::tolerate_values).error();
    check(other_error == errc::arena_full || (other_error == errc::ok && encoded(other) == again),
          "a message comes back");
}

} // namespace

void fuzz::run(std::span<const std::byte> input) {
    // The ID tells which one: seeds are the golden messages as they are.
    const auto id = jauscat::sae::message_id_of(input);
    const auto tried = [&]<class... Messages>() {
        static_cast<void>((... || (Messages::schema::message_id == id && (check_message<Messages>(input), true))));
    };
    using namespace jauscat::sae;
    tried.template
    operator()<core::create_event, core::query_events, core::reject_event_request, core::set_element,
               mobility::set_local_operating_zone, environment_sensing::report_sensor_geometric_properties,
               mobility::report_gps_fix, environment_sensing::report_range_sensor_data,
               environment_sensing::report_range_sensor_compressed_data>();
}
