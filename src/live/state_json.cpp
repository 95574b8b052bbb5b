#include "state_json.hpp"

#include <jauscat/text/hex.hpp>
#include <jauscat/text/jaus.hpp>

#include <chrono>
#include <cmath>
#include <string>

namespace jauscat::net::live {

namespace {

using json = nlohmann::ordered_json;

json to_json(const live_slave& of) {
    json made{{"position", of.position}, {"name", of.name},     {"station", text::hex_word(of.station)},
              {"state", of.state},       {"wanted", of.wanted}, {"al_status", of.al_status}};
    if (of.errors)
        made["errors"] = {{"invalid_frames", of.errors->invalid_frames},
                          {"forwarded", of.errors->forwarded},
                          {"lost_links", of.errors->lost_links}};
    made["in_service"] = of.is_in_service;
    made["at_rest"] = of.is_at_rest;
    return made;
}

} // namespace

json to_json(const live_system& of) {
    return {{"subsystem", of.subsystem},
            {"name", of.name},
            {"address", of.address},
            {"generation", of.is_sae ? "sae" : "ra"},
            {"alive", of.is_alive}};
}

json to_json(const live_component& of) {
    json made{{"id", text::to_text(of.id)}, {"own", of.is_own}, {"name", of.name}, {"state", of.state}};
    made["controller"] = of.controller ? text::to_text(*of.controller) : std::string{};
    if (of.controller) made["authority"] = of.authority;
    if (of.age) made["age"] = std::round(std::chrono::duration<double>{*of.age}.count() * 10) / 10;
    return made;
}

json to_json(const live_bus& of) {
    json made{{"name", of.name}, {"state", of.state}};
    if (of.period > duration{}) {
        made["period_us"] = std::chrono::duration_cast<std::chrono::microseconds>(of.period).count();
        made["cycles"] = of.cycles;
        made["working_counter"] = {{"expected", of.expected_working_counter},
                                   {"last", of.working_counter},
                                   {"wrong", of.wrong_working_counters}};
        made["frames_lost"] = of.frames_lost;
    }
    if (of.clock)
        made["clock"] = {
            {"reference", of.clock->reference}, {"offset_ns", of.clock->offset_ns}, {"in_step", of.clock->is_in_step}};
    if (!of.lateness_counts.empty())
        made["histogram"] = {{"upper_us", of.lateness_limits_us}, {"counts", of.lateness_counts}};
    made["slaves"] = json::array();
    for (const auto& slave : of.slaves) made["slaves"].push_back(to_json(slave));
    return made;
}

} // namespace jauscat::net::live
