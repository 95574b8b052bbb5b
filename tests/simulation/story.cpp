#include "simulation/story.hpp"

#include <jauscat/text/jaus.hpp>

#include <array>
#include <cstdio>

namespace simulation {
namespace {

std::string state_text(std::uint32_t state) {
    constexpr std::array names{"Initialize", "Ready", "Standby", "Shutdown", "Failure", "Emergency"};
    return state < names.size() ? names[state] : "state " + std::to_string(state);
}
std::string control_text(std::uint32_t state) {
    constexpr std::array names{"does not want control", "asks for control", "has control",
                               "is refused control",    "has lost control", "gets no answer about control"};
    return state < names.size() ? names[state] : "control state " + std::to_string(state);
}
std::string stop_text(std::uint16_t order) {
    constexpr std::array names{"rest", "Set Emergency", "Clear Emergency"};
    return order < names.size() ? names[order] : "stop " + std::to_string(order);
}
std::string connection_text(std::uint32_t state) {
    constexpr std::array names{"is free",      "is requested", "is active",     "is stale: requested again",
                               "is suspended", "is refused",   "is unanswered", "ends"};
    return state < names.size() ? names[state] : "is in state " + std::to_string(state);
}
std::string time_text(time at) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%12.4f s  ", std::chrono::duration<double>(at).count());
    return text.data();
}
std::string address_text(std::uint32_t address) {
    return std::to_string(address >> 24U) + '.' + std::to_string(address >> 16U & 0xFFU) + '.' +
           std::to_string(address >> 8U & 0xFFU) + '.' + std::to_string(address & 0xFFU);
}
std::string message_text(const happening& one) {
    if (one.code == 0) return "a message";
    std::array<char, 64> numbers{};
    std::snprintf(numbers.data(), numbers.size(), " %04Xh, number %u", unsigned{one.code}, unsigned{one.number});
    auto text = jauscat::text::message_name(one.code) + numbers.data();
    if (one.message != 0) text += " (message " + std::to_string(one.message) + ")";
    return text;
}

} // namespace

std::string text_of(const happening& one, const std::vector<std::string>& names) {
    const auto name = [&](std::uint8_t who) { return who < names.size() ? names[who] : std::string{"nobody"}; };
    const auto message = [&] { return message_text(one); };
    const auto command = [&] { return one.value == 0 ? std::string{} : ", command " + std::to_string(one.value); };
    const auto ms = std::to_string(one.value) + " ms";
    switch (one.what) {
    case deed::starts: return name(one.who) + " starts, life " + std::to_string(one.number);
    case deed::goes_mute: return name(one.who) + ": its component does nothing any more, its node goes on";
    case deed::dies: return name(one.who) + " dies";
    case deed::freezes: return name(one.who) + " is suspended for " + ms;
    case deed::goes_on: return name(one.who) + " goes on";
    case deed::clock_leaps: return name(one.who) + ": its clock leaps by " + ms;
    case deed::sends: return name(one.who) + " sends to " + name(one.whom) + ": " + message();
    case deed::gets: return name(one.who) + " gets from " + name(one.whom) + ": " + message() + command();
    case deed::queues: return name(one.who) + " keeps for later: " + message();
    case deed::merges:
        return name(one.who) + " merges with the command before, which its slave has not confirmed: " + message() +
               command();
    case deed::loses: return "the network loses, " + name(one.who) + " to " + name(one.whom) + ": " + message();
    case deed::doubles: return "the network doubles, " + name(one.who) + " to " + name(one.whom) + ": " + message();
    case deed::delays:
        return "the network delays by " + ms + ", " + name(one.who) + " to " + name(one.whom) + ": " + message();
    case deed::parts: return "the network is cut from " + name(one.who) + " to " + name(one.whom);
    case deed::joins: return "the network is whole again from " + name(one.who) + " to " + name(one.whom);
    case deed::acknowledges: return name(one.who) + " acknowledges to " + name(one.whom) + ": " + message();
    case deed::refuses: return name(one.who) + " refuses (NAK) to " + name(one.whom) + ": " + message();
    case deed::drops:
        return name(one.who) + " does not execute of " + name(one.whom) + ": " + message() + command() + ": " + one.why;
    case deed::hears_acknowledged: return name(one.who) + " learns that it was acknowledged: " + message();
    case deed::hears_refused: return name(one.who) + " learns that it was refused: " + message();
    case deed::hears_nothing: return name(one.who) + " gives up, no acknowledgement: " + message();
    case deed::executes:
        return name(one.who) + " executes " + message() +
               (one.value == 0 ? ": all efforts 0" : ": efforts of command " + std::to_string(one.value));
    case deed::rests: return name(one.who) + " comes to rest";
    case deed::enters_state:
        return name(one.who) + ": " + state_text(one.number) + " -> " + state_text(one.value) +
               (one.message != 0 ? " by message " + std::to_string(one.message) : "");
    case deed::controlled_by:
        return name(one.who) + " is controlled by " + (one.whom == 0 ? std::string{"nobody"} : name(one.whom));
    case deed::control: return name(one.who) + " " + control_text(one.value);
    case deed::delivers_large: return name(one.who) + " gets the whole large data set " + std::to_string(one.value);
    case deed::sends_large: return name(one.who) + " sends the large data set " + std::to_string(one.value);
    case deed::gives_up: return name(one.who) + " is told that " + address_text(one.value) + " is lost";
    case deed::hears_of: return name(one.who) + " is told that " + address_text(one.value) + " is there";
    case deed::owes_stop: return name(one.who) + " requires " + stop_text(one.number) + ", because " + one.why;
    case deed::stop_refused:
        return name(one.who) + ": its slave refuses " + stop_text(one.number) + ", attempt " +
               std::to_string(one.value);
    case deed::settled: return name(one.who) + ": its slaves have confirmed all stop orders";
    case deed::uses_slave: return name(one.who) + " uses " + name(one.whom);
    case deed::loses_slave: return name(one.who) + " counts " + name(one.whom) + " as lost, because " + one.why;
    case deed::connects:
        return name(one.who) + ": its connection to " + name(one.whom) + ' ' + connection_text(one.value);
    case deed::ignores_report:
        return name(one.who) + " ignores report " + std::to_string(one.number) + " of " + name(one.whom) +
               ", because it has a newer one";
    case deed::begins_transfer:
        return name(one.who) + ": transfer " + std::to_string(one.value) + " of its application " + one.why +
               " subindex " + std::to_string(one.number) + " of " + name(one.whom);
    case deed::ends_transfer:
        return name(one.who) + ": transfer " + std::to_string(one.value) + " of its application, to " + name(one.whom) +
               ", " + one.why;
    case deed::is_ended: return name(one.who) + " is told to end (SIGTERM)";
    case deed::person: return "a person ends the emergency at " + name(one.who);
    case deed::ring: return ring_text(one, names);
    }
    return "something happens";
}

std::string line_of(const happening& one, const std::vector<std::string>& names) {
    return time_text(one.at) + text_of(one, names);
}

std::string line_of(time at, const char* what, std::span<const std::byte> content) {
    std::string line = time_text(at) + what;
    line += ':';
    for (const auto each : content) {
        std::array<char, 4> digits{};
        std::snprintf(digits.data(), digits.size(), " %02x", std::to_integer<unsigned>(each));
        line += digits.data();
    }
    return line;
}

} // namespace simulation
