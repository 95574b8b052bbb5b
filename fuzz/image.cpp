// A message into a process image and out of one, against the codec.
#include "support/target.hpp"
#include <jauscat/bridge/image_exchange.hpp>
#include <jauscat/schema/translation/wrench_effort_image.hpp>
#include <jauscat/wire/raw.hpp>

using namespace fuzz;
using namespace jauscat;
using translation::wrench_effort_image;

namespace {

using command = translate::image_translator<translation::set_wrench_effort_table>;
using exchange =
    bridging::image_exchange<translation::set_wrench_effort_table, translation::report_wrench_effort_table>;

wrench_effort_image values_of(const byte_vector& image) {
    wrench_effort_image values{};
    check(static_cast<bool>(wire::decode(values, image)), "an image has any bytes");
    return values;
}

/// Each element of `body` is in `after`, where it has one; else `after` has what `before` had.
void check_elements(std::span<const std::byte> body, const byte_vector& before, const byte_vector& after) {
    wire::raw<jaus::set_wrench_effort> message{};
    check(static_cast<bool>(wire::decode(message, body)), "what was taken decodes");
    const auto old_values = values_of(before), new_values = values_of(after);
    wire::visit(message, [&]<class Item>(Item item, const auto& element) {
        wire::visit(old_values, [&](auto field, const auto& old_value) {
            wire::visit(new_values, [&]<class Field>(Field, const auto& new_value) {
                if constexpr (std::is_same_v<Field, decltype(field)> &&
                              std::is_same_v<std::remove_cvref_t<decltype(*element)>,
                                             std::remove_cvref_t<decltype(new_value)>>)
                    if (item.name() == field.name())
                        check(new_value == (element ? *element : old_value), "an element is the last one commanded");
            });
        });
    });
}

void command_into(std::span<const std::byte> body, const byte_vector& before) {
    byte_vector after = before;
    const auto error = command::to_image(body, after);
    jaus::set_wrench_effort real{};
    const bool decodes = static_cast<bool>(wire::decode(real, body));
    if (error != translate::errc::ok) {
        check(after == before, "a refused message changes no byte");
        byte_vector merged = before;
        check(command::merge(body, merged) == error && merged == before, "merging refuses the same");
        // What an image holds from before may be no value either, if not this table has written it.
        check(!decodes || error == translate::errc::out_of_range, "what decodes as real values goes into an image");
        return;
    }
    check(decodes, "what goes into an image decodes as real values");
    check_elements(body, before, after);
    byte_vector back(wire::max_size<jaus::set_wrench_effort>);
    const auto restored = command::from_image(after, back);
    byte_vector known = copy_of(body);
    known[1] &= std::byte{0x0F}; // the presence bits without a field are ignored
    check(restored && std::ranges::equal(*restored, known), "the body comes back byte for byte");

    byte_vector merged = before;
    const auto old_bits = values_of(before).presence_vector;
    check(command::merge(body, merged) == translate::errc::ok, "what goes into an image is merged too");
    auto expected = values_of(after);
    expected.presence_vector |= old_bits;
    check(values_of(merged) == expected, "merging keeps the presence bits from before, and is the same else");
}

} // namespace

void fuzz::run(std::span<const std::byte> input) {
    input_reader in{input};
    const byte_vector before = in.take_bytes(command::image_size);
    command_into(copy_of(in.rest()), before);

    byte_vector body(wire::max_size<jaus::set_wrench_effort>);
    const auto restored = command::from_image(before, body);
    const bool defined = values_of(before).presence_vector < 0x1000;
    check(static_cast<bool>(restored) == defined,
          "an image is a message unless it has a bit for an element that is none");

    // Messages and images that anyone may send, through the exchange.
    exchange jaus{{.subsystem = 1, .station = 2}, 33};
    byte_vector outputs = copy_of(before), inputs = in.take_bytes(command::image_size);
    check(jaus.start(outputs, inputs) && jaus.given(outputs) == jaus.taken(inputs), "commands are counted on");
    const jaus::header head{.ack_nak = jaus::ack_nak::request, .source = {1, 32, 1, 1}};
    std::size_t waiting = 0;
    while (!in.empty()) {
        const auto piece = in.take_bytes(in.take() % 24);
        waiting += jaus.on_command(head, piece, outputs, inputs, {}) == translate::errc::ok;
        std::array<std::byte, 64> report{};
        const auto answered = jaus.on_query<jaus::query_wrench_effort>(head, piece, inputs, report);
        check(!answered || answered->size() <= report.size(), "a report fits");
    }
    std::array<std::byte, 16> answer{};
    std::size_t answers = 0;
    while (jaus.acknowledgement(inputs, jauscat::time_point{std::chrono::seconds{1}}, answer) != 0) ++answers;
    check(answers == waiting, "each command that was taken is answered once");
}
