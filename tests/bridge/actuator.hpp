// An emulated slave whose objects are JAUS messages, with faults on demand.
#pragma once
#include <jauscat/bridge/delivery.hpp>
#include <jauscat/bridge/listed_objects.hpp>
#include <jauscat/bridge/object_list.hpp>
#include <jauscat/ethercat/slave/image_entries.hpp>
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/jaus/message/copy_present.hpp>
#include <jauscat/schema/jaus/messages.hpp>
#include <jauscat/schema/translation/seed_table.hpp>
#include <jauscat/schema/translation/wrench_effort_image.hpp>
#include <jauscat/translate/image_translator.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace test {

namespace bridging = jauscat::bridging;
namespace ethercat = jauscat::ethercat;
namespace jaus = jauscat::jaus;

/// State of the actuator, and the code of each message that it has executed.
class actuator {
  public:
    using table = jauscat::translation::seed_table;
    using image = jauscat::translation::wrench_effort_image;

    double effort{};  ///< the propulsive linear effort in x that is in force, in percent
    bool emergency{}; ///< takes no efforts
    std::vector<std::uint16_t> executed{};
    std::vector<double> efforts{}; ///< each that was commanded, in order
    /// The next writes of this code are aborted.
    std::uint16_t abort_code_of{};
    unsigned aborts{};
    ethercat::abort_code abort{ethercat::abort_code::general};
    unsigned aborted{}; ///< so many were

    explicit actuator(std::uint8_t subsystem, std::uint16_t station)
        : self_{.subsystem = subsystem, .station = station} {
        reset();
    }
    /// As after power-on.
    void reset() {
        effort = 0;
        emergency = false;
    }

    ethercat::abort_code write(std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data) noexcept {
        using ethercat::abort_code;
        const auto restored = delivery::message_of({self_.station, index, subindex, data}, self_, message_);
        if (!restored) return abort_code::parameter_incompatible;
        const auto parts = jaus::split(*restored);
        const auto code = parts.header.command_code;
        if (code == abort_code_of && aborts != 0) {
            --aborts;
            ++aborted;
            return abort;
        }
        if (code == jaus::command_code_of<jaus::set_wrench_effort>) {
            if (emergency) return abort_code::device_state;
            jaus::set_wrench_effort told{};
            if (!jauscat::wire::decode(told, parts.body)) return abort_code::value_range;
            drive(told);
        }
        if (code == jaus::command_code_of<jaus::set_emergency>) {
            emergency = true;
            effort = 0;
        }
        if (code == jaus::command_code_of<jaus::clear_emergency>) emergency = false;
        if (code == jaus::command_code_of<jaus::query_wrench_effort>) prepare(parts.header);
        executed.push_back(code);
        return abort_code::none;
    }
    ethercat::object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
        std::array<std::byte, delivery::translator::max_packet_size> packet{};
        const auto translated = delivery::translator::to_packet(report_, packet);
        if (!translated) return {ethercat::abort_code::no_data, 0};
        const auto object = delivery::object_of(*translated);
        if (object.index != index || object.subindex != subindex) return {ethercat::abort_code::no_data, 0};
        std::ranges::copy(object.data, out.begin());
        return {ethercat::abort_code::none, object.data.size()};
    }
    /// Process data: outputs in OP into force, and what is in force into the inputs.
    void work(ethercat::slave& slave) {
        if (slave.take_outputs()) take(slave.outputs());
        if (driven_ && slave.state() != ethercat::al_state::op) {
            driven_ = false;
            effort = 0;
        }
        give(slave.inputs());
    }

  private:
    using delivery = bridging::delivery<table>;
    using command = jauscat::translate::image_translator<jauscat::translation::set_wrench_effort_table>;
    using report = jauscat::translate::image_translator<jauscat::translation::report_wrench_effort_table>;

    void drive(const jaus::set_wrench_effort& told) {
        if (!told.propulsive_linear_effort_x) return;
        effort = *told.propulsive_linear_effort_x;
        efforts.push_back(effort);
    }
    void prepare(const jaus::header& query) {
        jaus::header head = jaus::answer_to(query);
        head.destination = head.source = query.destination;
        std::array<std::byte, 256> bytes{};
        const auto made =
            jaus::make_message(head, jaus::report_wrench_effort{.propulsive_linear_effort_x = effort}, bytes);
        report_.assign(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(made->size()));
    }
    void take(std::span<const std::byte> written) {
        image values{};
        if (!jauscat::wire::decode(values, written) || values.command_count == taken_ || emergency) return;
        taken_ = values.command_count;
        std::array<std::byte, 64> body{};
        const auto message_bytes = command::from_image(written, body);
        jaus::set_wrench_effort told{};
        if (!message_bytes || !jauscat::wire::decode(told, *message_bytes)) return;
        driven_ = true;
        drive(told);
    }
    void give(std::span<std::byte> inputs) const {
        std::array<std::byte, report::image_size> bytes{};
        static_cast<void>(jauscat::wire::encode(image{.command_count = taken_}, bytes));
        std::array<std::byte, 64> body{};
        const auto encoded =
            jauscat::wire::encode(jaus::report_wrench_effort{.propulsive_linear_effort_x = effort}, body);
        if (inputs.size() == bytes.size() && encoded &&
            report::to_image(*encoded, bytes) == jauscat::translate::errc::ok)
            std::ranges::copy(bytes, inputs.begin());
    }

    bridging::slave_identity self_;
    std::vector<std::byte> report_{};
    std::array<std::byte, delivery::translator::max_message_size> message_{};
    std::uint16_t taken_{};
    bool driven_{};
};

/// The slave that it is behind.
class emulated_actuator {
  public:
    static constexpr std::array objects{
        jauscat::bridging::object_list<actuator::table, 33, jaus::set_wrench_effort, jaus::query_wrench_effort,
                                       jaus::report_wrench_effort, jaus::set_emergency, jaus::clear_emergency,
                                       jaus::set_travel_speed, jaus::set_end_effector_path_motion,
                                       jaus::report_heartbeat_pulse>::description,
        jauscat::bridging::object_list<actuator::table, 34, jaus::set_wrench_effort, jaus::set_emergency,
                                       jaus::clear_emergency, jaus::set_travel_speed,
                                       jaus::set_end_effector_path_motion>::description};

    /// Its alias is 100 more than the station address.
    emulated_actuator(std::uint8_t subsystem, std::uint16_t station,
                      ethercat::clock_width clock = ethercat::clock_width::no_clock)
        : behind{subsystem, station}, alias_{static_cast<std::uint16_t>(100 + station)}, clock_{clock} {}

    /// A frame passes.
    void pass(std::span<std::byte> frame, jauscat::time_point now) {
        slave.pass(frame);
        on_time(now);
    }
    /// After each frame, and in between.
    void work(std::span<std::byte>, jauscat::time_point now) { on_time(now); }
    void on_time(jauscat::time_point now) {
        slave.on_time(now);
        if (hangs) return;
        slave.work();
        behind.work(slave);
    }
    [[nodiscard]] bool has_clock() const { return clock_ != ethercat::clock_width::no_clock; }
    void power_cycle() {
        slave.power_on();
        behind.reset();
    }

    actuator behind;
    bool hangs{}; ///< the application, not the controller of the slave

  private:
    static constexpr std::span<const ethercat::pdo_entry> outputs{
        ethercat::image_entries<actuator::image, ethercat::image_objects::outputs>};
    static constexpr std::span<const ethercat::pdo_entry> inputs{
        ethercat::image_entries<actuator::image, ethercat::image_objects::inputs>};
    std::uint16_t alias_;
    ethercat::clock_width clock_;
    ethercat::slave_description description_{.vendor = 1,
                                             .product = 2,
                                             .station_alias = alias_,
                                             .mailbox_out_size = 256,
                                             .mailbox_in_size = 256,
                                             .name = "actuator",
                                             .outputs = outputs,
                                             .inputs = inputs,
                                             .clock = clock_,
                                             .needs_sync = clock_ != ethercat::clock_width::no_clock};
    bridging::listed_objects list_{objects, behind, bridging::size_rule::up_to_largest};
    ethercat::standard_objects dictionary_{description_, list_};
    std::array<std::byte, 4096> memory_{};

  public:
    ethercat::slave slave{description_, dictionary_, {.transfer_memory = memory_}};
};

} // namespace test
