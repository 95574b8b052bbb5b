// text.md: messages from lines of text, and messages as JSON. Takes every line of lines.txt.
//     docs_text_lines (in this folder)
// [includes]
#include <jauscat/schema/jaus/messages.hpp>
#include <jauscat/text/from_text.hpp>
#include <jauscat/text/json.hpp>
#include <jauscat/text/print.hpp>

#include <array>
#include <fstream>
#include <iostream>

namespace jaus = jauscat::jaus;
namespace text = jauscat::text;
namespace wire = jauscat::wire;
// [includes end]

namespace {

/// Those of lines.txt.
using messages =
    jaus::message_list<jaus::set_wrench_effort, jaus::report_component_status, jaus::set_camera_pose, jaus::report_time,
                       jaus::set_joint_efforts, jaus::create_event, jaus::report_camera_pose, jaus::report_image>;

/// Whether each line is a message that encodes.
bool takes_all_lines() {
    std::ifstream lines{"lines.txt"};
    bool good = true;
    for (std::string line; std::getline(lines, line);) {
        std::array<std::byte, 1024> memory{}, bytes{};
        wire::arena arena{memory};
        jauscat::result<std::span<std::byte>, wire::errc> encoded{wire::errc::truncated};
        const auto read = text::from_text(line, arena, messages{},
                                          [&](const auto& message) { encoded = wire::encode(message, bytes); });
        if (encoded) continue;
        std::cerr << line << ": " << (read ? describe(encoded.error()) : describe(read.error())) << '\n';
        good = false;
    }
    return good;
}

} // namespace

int main() {
    // [use]
    std::array<std::byte, 1024> memory{}; // for lists, texts and bytes
    wire::arena arena{memory};
    jaus::set_wrench_effort command{};
    auto read = text::from_text("propulsive_linear_effort_x=50 resistive_linear_effort_x=12.5%", command, arena);
    if (!read) return std::cerr << describe(read.error()) << '\n', 1;
    std::cout << text::to_text(command) << text::to_json(command).dump(2) << '\n';

    read = text::from_text("propulsive_linear_effort_x=150", command, arena);
    if (read.error().code == text::errc::out_of_range) std::cout << describe(read.error()) << '\n';
    read = text::from_text("propulsive_linear_efort_x=50", command, arena);
    if (read.error().code == text::errc::unknown_field) std::cout << describe(read.error()) << '\n';
    // [use end]
    return takes_all_lines() ? 0 : 1;
}
