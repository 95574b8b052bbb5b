// mapping-table.md: a message into a slave's process data.
//     docs_image
// [includes]
#include <jauscat/ethercat/slave/image_entries.hpp>
#include <jauscat/text/annotate.hpp>
#include <jauscat/translate/image_translator.hpp>

#include <array>
#include <iostream>

namespace translate = jauscat::translate;
// [includes end]

// [message]
struct millimetres {
    static constexpr double min = 0, max = 200;
    static constexpr std::string_view unit = "mm";
};

/// Set Gripper: the body of the message.
struct set_gripper {
    std::optional<double> opening{};      ///< millimetres, 0 to 200
    std::optional<std::uint8_t> finger{}; ///< 1 is the first

    // clang-format off
    struct schema : jauscat::wire::items {
        static constexpr std::uint16_t command_code = 0xD101;
        using T = set_gripper;
        using type = layout<presence<u8,
            field<&T::opening, scaled<u16le, millimetres>>,
            field<&T::finger, u8>>>;
    };
    // clang-format on
};

/// The slave's outputs: 6 bytes, the same in every cycle.
struct gripper_outputs {
    std::uint16_t command_count{}; ///< incremented by each command
    std::uint8_t presence{};       ///< fields of the last command
    std::uint16_t opening{};
    std::uint8_t finger{};

    // clang-format off
    struct schema : jauscat::wire::items {
        using T = gripper_outputs;
        using type = layout<
            field<&T::command_count, u16le>,
            field<&T::presence, u8>,
            field<&T::opening, u16le>,
            field<&T::finger, u8>>;
    };
    // clang-format on
};
// [message end]

// clang-format off
// [table]
using M = set_gripper;
using P = gripper_outputs;
using translate::at;

using gripper_table = translate::image_table<M, P,
    translate::counter<at<&P::command_count>>,
    translate::presence_bits<at<&P::presence>>,
    translate::element<at<&M::opening>, at<&P::opening>>,
    translate::element<at<&M::finger>, at<&P::finger>>>;
// [table end]
// clang-format on

int main() {
    // [use]
    using gripper = translate::image_translator<gripper_table>;
    std::array<std::byte, gripper::image_size> outputs{};
    for (const set_gripper& command : {set_gripper{.opening = 80, .finger = 2}, set_gripper{.opening = 20}}) {
        std::array<std::byte, 8> body{};
        const auto encoded = jauscat::wire::encode(command, body);
        if (const auto done = gripper::to_image(*encoded, outputs); !done)
            return std::cerr << describe(done.error()) << '\n', 1;
        std::cout << jauscat::text::annotate<gripper_outputs>(outputs) << '\n';
    }
    // The master takes the description of the process data from the same struct.
    for (const auto& entry : jauscat::ethercat::image_entries<gripper_outputs, 0x7000>)
        std::cout << jauscat::text::hex_number(entry.index, 4) << ':' << int{entry.subindex} << "  " << int{entry.bits}
                  << " bits  " << entry.name << '\n';
    // [use end]
}
