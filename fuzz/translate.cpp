// Both translation tables in both directions, and delivery to a slave.
#include "support/canonical.hpp"
#include "support/target.hpp"
#include <jauscat/bridge/delivery.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>

using namespace fuzz;
using namespace jauscat;
using hilscher::sdo_download_request;

namespace {

template <class Table> struct checked {
    using translator = translate::translator<Table>;
    using delivery = bridging::delivery<Table>;
    using errc = translate::errc;

    static void message(std::span<const std::byte> input) {
        byte_vector packet(translator::max_packet_size);
        const auto there = translator::to_packet(input, packet);
        if (!there) {
            check(there.error() == errc::truncated || there.error() == errc::wrong_size ||
                      there.error() == errc::too_large || there.error() == errc::unknown_command_code ||
                      there.error() == errc::reserved_value,
                  "a message is refused for a reason that to_packet documents");
            return;
        }
        packet.resize(there->size());
        check(there->size() - translator::packet_size + translator::header_size == input.size() + translator::rest_size,
              "a packet carries the rest of the header and the body");
        byte_vector short_by_one(there->size() - 1);
        check(translator::to_packet(input, short_by_one).error() == errc::no_space, "one byte too few is no space");

        byte_vector message(input.size());
        const auto back = translator::from_packet(packet, message);
        check(back && back->size() == input.size(), "a packet that was made translates back");
        check(message == copy_of(input), "a message comes back byte for byte");
        deliver(input, packet);
    }

    static void deliver(std::span<const std::byte> message, std::span<const std::byte> packet) {
        jaus::header head{};
        static_cast<void>(wire::decode_prefix(head, message));
        if (delivery::deliverable(head) != errc::ok) return;
        const auto object = delivery::object_of(packet);
        check(object.station == head.destination.node && object.subindex != 0, "an object belongs to its slave");
        byte_vector received(message.size());
        const auto restored = delivery::message_of(
            object,
            {.subsystem = head.destination.subsystem, .station = object.station, .instance = head.destination.instance},
            received);
        check(restored && restored->size() == message.size(), "a delivered object is a message again");
        check(received == copy_of(message), "a message arrives at its slave byte for byte");
    }

    static void packet(std::span<const std::byte> input) {
        byte_vector message(translator::max_message_size);
        const auto back = translator::from_packet(input, message);
        if (!back) {
            check(back.error() != errc::no_space, "the largest message has room");
            return;
        }
        message.resize(back->size());
        sdo_download_request fields{};
        static_cast<void>(wire::decode_prefix(fields, input));
        check(fields.head.ul_len >= 16 + fields.ul_data_cnt, "a packet is as long as its data count says");
        byte_vector packet(translator::max_packet_size);
        const auto there = translator::to_packet(message, packet, fields);
        check(static_cast<bool>(there), "a message that was made translates");
        packet.resize(there->size());
        // Allowed: a packet may be longer than its data count says, and state that length; it comes back without.
        fields.head.ul_len = 16 + fields.ul_data_cnt;
        byte_vector expected = encoded(fields).value();
        const auto data = input.subspan(expected.size(), fields.ul_data_cnt);
        expected.insert(expected.end(), data.begin(), data.end());
        check(packet == expected, "a packet comes back byte for byte");
    }

    /// An object that any master may have written.
    static void object(std::span<const std::byte> input) {
        input_reader in{input};
        const auto index = in.take<wire::u16le>();
        const auto subindex = in.take();
        const bridging::slave_identity self{.subsystem = in.take(), .station = in.take(), .instance = in.take()};
        const byte_vector data = copy_of(in.rest());
        byte_vector message(translator::max_message_size);
        const auto message_bytes = delivery::message_of({self.station, index, subindex, data}, self, message);
        if (!message_bytes) {
            check(message_bytes.error() != errc::no_space, "the largest message has room");
            return;
        }
        message.resize(message_bytes->size());
        jaus::header head{};
        static_cast<void>(wire::decode_prefix(head, std::span<const std::byte>{message}));
        check(head.data_size == message_bytes->size() - jaus::header_size, "a delivered message states its size");
        check(head.destination.node == self.station, "a delivered message names its slave");
        byte_vector packet(translator::max_packet_size);
        const auto there = translator::to_packet(message, packet);
        check(static_cast<bool>(there), "a delivered message translates");
        const auto again = delivery::object_of(*there);
        check(again.index == index && again.subindex == subindex && copy_of(again.data) == data,
              "an object comes back as it was written");
    }
};

} // namespace

void fuzz::run(std::span<const std::byte> input) {
    [&]<class... Tables>(Tables...) {
        ((checked<Tables>::message(input), checked<Tables>::packet(input), checked<Tables>::object(input)), ...);
    }(translation::seed_table{}, translation::self_contained_table{});
}
