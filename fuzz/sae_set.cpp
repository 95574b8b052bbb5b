// All messages of a set of SAE services, from any bytes, by their entries in the catalogue: an error, or a message that
// encodes and comes back, also from its JSON; diagnose, annotate and the list of values outside their value sets agree.
// The program's name tells which set.
#include "support/target.hpp"
#include <jauscat/catalogue/json.hpp>
#include <jauscat/catalogue/sae.hpp>
#include <jauscat/schema/sae/message_id.hpp>

#include <filesystem>
#include <map>
#include <string>

using namespace fuzz;
namespace catalogue = jauscat::catalogue;
namespace wire = jauscat::wire;
using wire::errc;

namespace {

const catalogue::list* set;

byte_vector encoded(const catalogue::any_message& message) {
    auto bytes = message.encode(wire::tolerate_values);
    check(static_cast<bool>(bytes), "what decodes encodes");
    return *std::move(bytes);
}

void check_payload(const catalogue::entry& type, std::span<const std::byte> payload) {
    const auto message = type.decode(payload, wire::tolerate_values);
    const auto strict = type.decode(payload).error().error, diagnosed = type.diagnose(payload).error;
    check(strict == diagnosed || strict == errc::arena_full, "diagnose names the error of decode");
    const auto lines = type.annotate(payload);
    if (!message) {
        check(message.error().error == strict, "only values outside their value sets are tolerated");
        return;
    }
    check(!lines.empty(), "a message has a line for its ID");
    static_cast<void>(message->to_text());
    const bool is_inside = message->outside_values().empty();
    check(strict == (is_inside ? errc::ok : errc::outside_value_set), "a value outside its set is named");
    check(message->encode().error() == strict, "encode refuses the values that decode refuses");

    const byte_vector bytes = encoded(*message);
    const auto again = type.decode(bytes, wire::tolerate_values);
    check(again && encoded(*again) == bytes, "a message comes back");
    const auto fields = catalogue::to_json(*message);
    const auto read = catalogue::from_json(type, fields);
    check(read && catalogue::to_json(*read) == fields, "a message comes back from its JSON");
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int*, char*** argv) {
    const std::map<std::string, const catalogue::list*> sets{
        {"fuzz_sae_core", &catalogue::sae_core_1_1()},
        {"fuzz_sae_mobility", &catalogue::sae_mobility_1_1()},
        {"fuzz_sae_environment_sensing", &catalogue::sae_environment_sensing_2_0()},
        {"fuzz_sae_manipulator", &catalogue::sae_manipulator_2_0()},
        {"fuzz_sae_ugv", &catalogue::sae_ground_vehicle_1_0()}};
    const auto found = sets.find(std::filesystem::path{**argv}.filename().string());
    check(found != sets.end(), "the program has the name of a set");
    set = found->second;
    return 0;
}

void fuzz::run(std::span<const std::byte> input) {
    byte_vector payload = copy_of(input);
    // Seeds are golden messages as they are; any other two bytes choose a message, too.
    const auto id = jauscat::sae::message_id_of(input);
    if (!id) return;
    const auto* type = set->find(*id);
    if (type == nullptr) {
        type = &*(set->begin() + static_cast<std::ptrdiff_t>(*id % set->size()));
        static_cast<void>(wire::u16le::store(payload.data(), type->command_code()));
    }
    check_payload(*type, payload);
}
