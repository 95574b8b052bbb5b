// JAUS on the cyclic path: commands go into a slave's outputs and so reach it in the next cycle, queries are answered
// from its inputs. No mailbox, no I/O.
//
// The slave repeats in its inputs the counter of the last command that it has executed. A frame that returns only
// proves that the outputs were written. Until the counter is repeated, the next command is merged with the previous
// one.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/bridge/delivery.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/jaus/message/requested_fields.hpp>
#include <jauscat/translate/image_translator.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace jauscat::bridging {

/// One component of a slave with `CommandTable`, an image_table into its outputs that counts commands, and
/// `ReportTable`, one for its inputs, whose field at `CountIn` repeats the counter; by default the same as in the
/// outputs.
template <class CommandTable, class ReportTable, class CountIn = typename CommandTable::counter_row::counts_messages>
class image_exchange {
  public:
    using command = translate::image_translator<CommandTable>;
    using report = translate::image_translator<ReportTable>;
    static constexpr std::uint16_t command_code = jaus::command_code_of<typename CommandTable::message_type>;
    static constexpr std::uint16_t report_code = jaus::command_code_of<typename ReportTable::message_type>;
    static constexpr std::uint16_t query_code = report_code - 0x2000; // RA 3.3 part 3
    static_assert(jaus::report_code_of(query_code) == report_code, "image_exchange: the inputs must be a report");
    using counter = typename CommandTable::counter_row::counts_messages::type;
    /// Commands that wait for their acknowledgement at one time.
    static constexpr std::size_t capacity = 16;

    /// `timeout`: a command that the slave has not executed after this time is answered with NAK.
    constexpr image_exchange(const slave_identity& slave, std::uint8_t component,
                             duration timeout = std::chrono::seconds{1}) noexcept
        : slave_{slave}, component_{component}, timeout_{timeout} {}

    /// Call before the first command, and after the slave was lost: the counter continues from the last command that
    /// the slave has executed, so that `outputs` do not count as a new one. Errors: wrong_size (outputs or inputs of
    /// another image), out_of_range.
    [[nodiscard]] constexpr result<void, translate::errc> start(std::span<std::byte> outputs,
                                                                std::span<const std::byte> inputs) noexcept {
        typename CommandTable::image_type image{};
        if (outputs.size() != command::image_size || inputs.size() != report::image_size)
            return translate::errc::wrong_size;
        if (const auto used = wire::decode(image, outputs); !used) return translate::errc_of(used.error());
        count_field::of(image) = taken(inputs);
        if constexpr (has_optional_fields) CommandTable::presence_row::says_presence::of(image) = {};
        return translate::errc_of(wire::encode(image, outputs).error());
    }

    /// Whether the message is for the process image. All others are for the mailbox.
    [[nodiscard]] constexpr bool takes(const jaus::header& head) const noexcept {
        return (head.command_code == command_code || head.command_code == query_code) &&
               (head.destination.component == component_ || head.destination.component == 255) &&
               head.destination.node == slave_.station && head.data_flag == jaus::data_flag::only &&
               !jaus::is_acknowledgement(head);
    }

    /// A command into `outputs`. What is refused here the caller answers. Errors: those of image_translator::to_image,
    /// and no_capacity where `capacity` commands wait for their acknowledgement already; the outputs are then
    /// unchanged.
    [[nodiscard]] constexpr result<void, translate::errc>
    on_command(const jaus::header& head, std::span<const std::byte> body, std::span<std::byte> outputs,
               std::span<const std::byte> inputs, time_point now) noexcept {
        const bool wanted = head.ack_nak == jaus::ack_nak::request;
        if (wanted && waiting_ == capacity) return translate::errc::no_capacity;
        const auto done = merges_next(outputs, inputs) ? merge(body, outputs) : command::to_image(body, outputs);
        if (wanted && done) wait_[waiting_++] = {head, deadline{now, timeout_}, given(outputs)};
        return done;
    }

    /// Writes the report requested by the query with this header and body to `out`, and returns it. Errors:
    /// truncated, wrong_size, reserved_value (a malformed query), those of image_translator::read, no_space.
    template <class Query>
    [[nodiscard]] constexpr result<std::span<std::byte>, translate::errc>
    on_query(const jaus::header& head, std::span<const std::byte> body, std::span<const std::byte> inputs,
             std::span<std::byte> out) const noexcept {
        static_assert(jaus::command_code_of<Query> == query_code, "on_query: not the query of this report");
        Query query{};
        translate::image_message<typename ReportTable::message_type> values{};
        if (const auto used = wire::decode(query, body); !used) return translate::errc_of(used.error());
        if (const auto read = report::read(inputs, values); !read) return read.error();
        jaus::keep_requested(values, query.presence_vector);
        if (out.size() < jaus::header_size) return translate::errc::no_space;
        const auto encoded = wire::encode(values, out.subspan(jaus::header_size));
        if (!encoded) return translate::errc_of(encoded.error());
        jaus::header answer = jaus::answer_to(addressed(head));
        answer.command_code = report_code;
        answer.data_size = static_cast<std::uint16_t>(encoded->size());
        if (const auto head_bytes = wire::encode(answer, out); !head_bytes)
            return translate::errc_of(head_bytes.error());
        return out.first(jaus::header_size + encoded->size());
    }

    /// After each cycle, until it returns 0: writes the next acknowledgement to `out`, which holds 16 bytes. ACK for a
    /// command that the slave has executed, NAK for one that it has not executed in time.
    [[nodiscard]] constexpr std::size_t acknowledgement(std::span<const std::byte> inputs, time_point now,
                                                        std::span<std::byte> out) noexcept {
        const auto last = taken(inputs);
        const auto waits = std::span{wait_}.first(waiting_);
        const auto over = [&](const waiting& each) {
            return has_reached(each.count, last) || each.until.is_reached(now);
        };
        const auto first = std::ranges::find_if(waits, over);
        if (first == waits.end()) return 0;
        const auto how = has_reached(first->count, last) ? jaus::ack_nak::ack : jaus::ack_nak::nak;
        const auto made = jaus::make_acknowledgement(addressed(first->head), how, out);
        std::copy(first + 1, waits.end(), first);
        --waiting_;
        return made ? made->size() : 0;
    }

    /// Whether the next command is merged with the one before, which the slave has not executed. A command without
    /// optional fields replaces it.
    [[nodiscard]] static constexpr bool merges_next(std::span<const std::byte> outputs,
                                                    std::span<const std::byte> inputs) noexcept {
        return has_optional_fields && given(outputs) != taken(inputs);
    }
    /// The counter in the outputs: the last command given; 0 for none.
    [[nodiscard]] static constexpr auto given(std::span<const std::byte> outputs) noexcept {
        typename CommandTable::image_type image{};
        static_cast<void>(wire::decode_prefix(image, outputs));
        return count_field::of(image);
    }
    /// The counter in the inputs: the last command that the slave has executed; 0 for none.
    [[nodiscard]] static constexpr auto taken(std::span<const std::byte> inputs) noexcept {
        typename ReportTable::image_type image{};
        static_cast<void>(wire::decode_prefix(image, inputs));
        return CountIn::of(image);
    }

    /// Whether the command `wanted` is not later than `now`. Counters go round: one is later than another if it is less
    /// than half a round ahead.
    [[nodiscard]] static constexpr bool has_reached(counter wanted, counter now) noexcept {
        return static_cast<counter>(now - wanted) <= std::numeric_limits<counter>::max() / 2;
    }

  private:
    using count_field = typename CommandTable::counter_row::counts_messages;

    static constexpr bool has_optional_fields = !std::is_void_v<typename CommandTable::presence_row>;

    [[nodiscard]] static constexpr result<void, translate::errc> merge(std::span<const std::byte> body,
                                                                       std::span<std::byte> outputs) noexcept {
        if constexpr (has_optional_fields)
            return command::merge(body, outputs);
        else
            return command::to_image(body, outputs);
    }

    struct waiting {
        jaus::header head{};
        deadline until{};
        counter count{};
    };

    [[nodiscard]] constexpr jaus::header addressed(jaus::header head) const noexcept {
        head.destination = slave_.answering_as(head.destination, component_);
        return head;
    }

    slave_identity slave_;
    std::uint8_t component_;
    duration timeout_;
    std::array<waiting, capacity> wait_{};
    std::size_t waiting_{};
};

} // namespace jauscat::bridging
