#include "support/log.hpp"

#include <chrono>
#include <nlohmann/json.hpp>

namespace example {

std::string log_lines(event_kind kind, const event_members& members, const std::string& text, std::uint64_t left_out) {
    if (chosen_log_format() == log_format::text)
        return left_out == 0 ? text : "(" + std::to_string(left_out) + " such were left out)\n" + text;
    const std::chrono::duration<double> time = std::chrono::steady_clock::now().time_since_epoch();
    nlohmann::ordered_json line{{"event", kind.name}, {"time", time.count()}, {"program", program_name()}};
    for (const auto& member : members)
        std::visit([&](const auto& value) { line[std::string{member.name}] = value; }, member.value);
    if (left_out != 0) line["left_out"] = left_out;
    line["text"] = text.ends_with('\n') ? text.substr(0, text.size() - 1) : text;
    // What a peer has sent may be no UTF-8.
    return line.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace example
