// Reports of the core service, for service connections to them and events of them.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/message_outcome.hpp>
#include <jauscat/jaus/events/report_field.hpp>
#include <jauscat/jaus/message/hook.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/jaus/message/message_sink.hpp>
#include <jauscat/jaus/message/presence_bits.hpp>
#include <jauscat/schema/jaus/communications.hpp>
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/schema/jaus/dynamic_configuration.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::jaus {

/// A report that every component has.
struct core_report {
    std::uint16_t command_code{}; ///< of the report
    std::uint16_t query_code{};   ///< of the query that it answers
    field_reader read_field{};    ///< null: its events have no boundaries
    bool on_change{true};         ///< its events may be sent on change

    [[nodiscard]] constexpr bool has_fields() const noexcept { return command_code == command_code_of<report_time>; }
    /// Bits of its presence vector; all where it has none.
    [[nodiscard]] constexpr std::uint32_t presence_bits() const noexcept {
        return has_fields() ? presence_bits_of<report_time> : 0xFFFFFFFF;
    }
};

/// The time has no events on change: it changes all the time.
inline constexpr std::array core_reports{
    core_report{0x4001, 0x2001, &read_field<report_component_authority>},
    core_report{0x4002, 0x2002, &read_field<report_component_status>},
    core_report{0x400D, 0x200D, &read_field<report_component_control>},
    core_report{.command_code = 0x4011, .query_code = 0x2011, .on_change = false},
    core_report{.command_code = 0x4202, .query_code = 0x2202},
    core_report{.command_code = 0x4B00, .query_code = 0x2B00},
    core_report{.command_code = 0x4B03, .query_code = 0x2B03},
};

/// Hertz; more often a core report is not sent.
inline constexpr double max_core_report_rate = 100;

/// The one with this code; nullptr: none.
[[nodiscard]] constexpr const core_report* core_report_of(std::uint16_t command_code) noexcept {
    const auto found = std::ranges::find(core_reports, command_code, &core_report::command_code);
    return found == core_reports.end() ? nullptr : &*found;
}

/// Answers a query to `out`.
using query_answer =
    hook<message_outcome(const header& query, std::span<const std::byte> body, time_point now, message_sink out)>;

/// Writes a core report of `self` to the front of `body`, as `answer` gives it, and returns its size; nothing where
/// there is none, or it is longer. `query`: the body of the query for it; empty: all fields, and the component's own
/// identification.
[[nodiscard]] constexpr std::optional<std::size_t> write_core_report(const core_report& report, const address& self,
                                                                     std::span<const std::byte> query,
                                                                     std::span<std::byte> body, time_point now,
                                                                     query_answer answer) noexcept {
    std::array<std::byte, 1> all{};
    if (query.empty() && report.has_fields()) {
        all[0] = static_cast<std::byte>(report.presence_bits());
        query = all;
    } else if (query.empty() && report.command_code == command_code_of<report_identification>) {
        all[0] = static_cast<std::byte>(query_type::component_identification);
        query = all;
    }
    std::optional<std::size_t> size;
    const auto take = [&](std::span<const std::byte> message) {
        header head{};
        if (!wire::decode_prefix(head, message) || head.command_code != report.command_code ||
            head.data_flag != data_flag::only || message.size() - header_size > body.size())
            return;
        std::ranges::copy(message.subspan(header_size), body.begin());
        size = message.size() - header_size;
    };
    const header head{.command_code = report.query_code,
                      .destination = self,
                      .source = self,
                      .data_size = static_cast<std::uint16_t>(query.size())};
    static_cast<void>(answer(head, query, now, take));
    return size;
}

/// The same with the fields of a presence vector, as a service connection asks for them.
[[nodiscard]] constexpr std::optional<std::size_t> write_core_report(const core_report& report, const address& self,
                                                                     std::uint32_t presence_vector,
                                                                     std::span<std::byte> body, time_point now,
                                                                     query_answer answer) noexcept {
    const std::array query{static_cast<std::byte>(presence_vector)};
    return write_core_report(report, self, report.has_fields() ? std::span<const std::byte>{query} : wire::blob{}, body,
                             now, answer);
}

} // namespace jauscat::jaus
