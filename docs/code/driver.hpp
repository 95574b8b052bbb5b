// The application of write-a-slave.md: what an EtherCAT slave does with objects that are JAUS messages.
#pragma once
// [includes]
#include <jauscat/bridge/delivery.hpp>
#include <jauscat/bridge/object_list.hpp>
#include <jauscat/ethercat/slave/object_dictionary.hpp>
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/jaus/message/copy_present.hpp>
#include <jauscat/jaus/message/requested_fields.hpp>
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>

#include <algorithm>
#include <array>

namespace bridging = jauscat::bridging;
namespace ethercat = jauscat::ethercat;
namespace jaus = jauscat::jaus;
// [includes end]

// [application]
using driver_table = jauscat::translation::self_contained_table_at_2000h;

/// The application: restores the JAUS message of a written object and calls its handler.
class driver {
  public:
    ethercat::abort_code write(std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data) noexcept {
        std::array<std::byte, delivery::translator::max_message_size> bytes{};
        const auto restored = delivery::message_of({self.station, index, subindex, data}, self, bytes);
        if (!restored) return ethercat::abort_code::parameter_incompatible;
        const auto message = jaus::split(*restored);
        if (!message) return ethercat::abort_code::parameter_incompatible;
        jaus::dispatcher handlers{
            jaus::on<jaus::set_wrench_effort>([&](const jaus::header&, const jaus::set_wrench_effort& command) {
                jaus::copy_present(command, effort); // and set the motors
            }),
            jaus::on<jaus::query_wrench_effort>([&](const jaus::header& query, const jaus::query_wrench_effort& asked) {
                auto answer = effort;
                jaus::keep_requested(answer, asked.presence_vector);
                report_size = prepare(query, answer);
            })};
        const auto what = handlers(message.header, message.body);
        return what == jaus::dispatched::handled ? ethercat::abort_code::none : ethercat::abort_code::value_range;
    }

    /// The report for the last query.
    ethercat::object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
        const auto object = delivery::object_of(std::span{report}.first(report_size));
        if (object.index != index || object.subindex != subindex) return {ethercat::abort_code::no_data, 0};
        if (object.data.size() > out.size()) return {ethercat::abort_code::exceeds_mailbox, 0};
        std::ranges::copy(object.data, out.begin());
        return {ethercat::abort_code::none, object.data.size()};
    }

    bridging::slave_identity self{.subsystem = 2, .station = 2};
    jaus::report_wrench_effort effort{};

  private:
    using delivery = bridging::delivery<driver_table>;

    /// A report is in the slave's own object: it is a message from the component to itself.
    std::size_t prepare(const jaus::header& query, const jaus::report_wrench_effort& answer) noexcept {
        std::array<std::byte, 64> message{};
        const auto made =
            jaus::make_message({.destination = query.destination, .source = query.destination}, answer, message);
        const auto translated = delivery::translator::to_packet(*made, report);
        return made && translated ? translated->size() : 0;
    }

    std::array<std::byte, 128> report{};
    std::size_t report_size{};
};

/// The slave's objects: component 33 takes these messages.
using driver_objects = jauscat::bridging::object_list<driver_table, 33, jaus::set_wrench_effort,
                                                      jaus::query_wrench_effort, jaus::report_wrench_effort>;
// [application end]
