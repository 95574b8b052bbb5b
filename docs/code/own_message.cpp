// Step 7 of declare-a-message.md: a layout becomes a JAUS message.
//     docs_own_message
// [includes]
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/text/jaus.hpp>

#include <array>
#include <iostream>
// [includes end]

// [declare]
namespace gripper {

struct newtons {
    static constexpr double min = 0, max = 500;
    static constexpr std::string_view unit = "N";
};

/// Set Gripper, code D101h: RA 3.3 reserves D000h to FFFFh for experimental messages.
struct set_gripper {
    std::uint8_t finger{};
    std::optional<double> force{}; ///< newtons, 0 to 500

    struct schema : jauscat::wire::items {
        static constexpr std::uint16_t command_code = 0xD101;
        using T = set_gripper;
        using type = layout<field<&T::finger, u8>, presence<u8, field<&T::force, scaled<u16le, newtons>>>>;
    };
};

} // namespace gripper
// [declare end]

namespace jaus = jauscat::jaus;

int main() {
    // [use]
    std::array<std::byte, 64> buffer{};
    const jaus::header head{.experimental = true,
                            .destination = {.instance = 1, .component = 33, .node = 2, .subsystem = 2},
                            .source = {.instance = 1, .component = 32, .node = 1, .subsystem = 1}};
    const auto made = jaus::make_message(head, gripper::set_gripper{.finger = 1, .force = 120}, buffer);
    if (!made) return std::cerr << describe(made.error()) << '\n', 1;

    // The receiver: from bytes to the handler of the message's type.
    jaus::dispatcher handlers{
        jaus::on<gripper::set_gripper>([](const jaus::header& from, const gripper::set_gripper& command) {
            std::cout << jauscat::text::to_text(from.source) << " says: finger " << int{command.finger} << ", "
                      << command.force.value_or(0) << " N\n";
        }),
        jaus::on_unknown([](const jaus::header& from, auto) {
            std::cout << "no handler for " << jauscat::text::message_name(from.command_code) << '\n';
        })};
    const auto message = jaus::split(*made);
    if (!message) return std::cerr << describe(message.error) << '\n', 1;
    return handlers(message.header, message.body) == jaus::dispatched::handled ? 0 : 1;
    // [use end]
}
