// mapping-table.md: a message of one's own in the tables of this library.
//     docs_private_code
// [includes]
#include <jauscat/bridge/delivery.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>
#include <jauscat/text/hex.hpp>

#include <array>
#include <iostream>

namespace jaus = jauscat::jaus;
namespace translation = jauscat::translation;
// [includes end]

/// Set Gripper, a message of one's own.
struct set_gripper {
    std::uint8_t finger{};
    std::uint8_t percent{};

    struct schema : jauscat::wire::items {
        static constexpr std::uint16_t command_code = 0xD101;
        using T = set_gripper;
        using type = layout<field<&T::finger, u8>, field<&T::percent, u8>>;
    };
};

// [table]
/// RA 3.3's 158 codes keep their ranks; D101h is appended and has rank 159. The index base is 2000h.
inline constexpr auto command_codes = translation::ra_command_codes_and<jaus::command_code_of<set_gripper>>;
using gripper_table = translation::self_contained_table_of<translation::manufacturer_index_base, command_codes>::type;
// [table end]

int main() {
    // [use]
    using delivery = jauscat::bridging::delivery<gripper_table>;
    std::array<std::byte, 64> buffer{};
    const jaus::header head{.experimental = true,
                            .destination = {.instance = 1, .component = 33, .node = 2, .subsystem = 2},
                            .source = {.instance = 1, .component = 32, .node = 1, .subsystem = 1}};
    const auto message = jaus::make_message(head, set_gripper{.finger = 1, .percent = 50}, buffer);
    if (!message) return std::cerr << describe(message.error()) << '\n', 1;

    std::array<std::byte, delivery::translator::max_packet_size> room{};
    const auto packet = delivery::translator::to_packet(*message, room);
    if (!packet) return std::cerr << describe(packet.error()) << '\n', 1;

    const auto object = delivery::object_of(*packet);
    std::cout << "station " << object.station << ", object " << jauscat::text::hex_number(object.index, 4)
              << ", subindex " << int{object.subindex} << ", data " << jauscat::text::hex(object.data) << '\n';
    // [use end]
}
