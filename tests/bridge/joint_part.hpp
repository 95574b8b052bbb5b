// Joint efforts by the process data of actuators, one for each joint.
#pragma once
#include "actuator.hpp"
#include <jauscat/bridge/process_part.hpp>
#include <jauscat/schema/jaus/manipulator.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace test {

class joint_part final : public bridging::process_part {
  public:
    static constexpr std::size_t most = 32;
    using errc = jauscat::translate::errc;
    template <class T> using result = jauscat::result<T, errc>;

    std::optional<bridging::drive_fault> fault{}; ///< as a drive reports it
    bool reset_helps{true};
    unsigned starts{}, steps{}, resets{};
    unsigned checks{};  ///< of the slaves' objects
    unsigned missing{}; ///< slaves without data at the last step
    std::vector<ethercat::init_command> start_up_objects{};

    [[nodiscard]] std::span<const ethercat::init_command> start_up(std::size_t, jauscat::duration) override {
        return start_up_objects;
    }

    [[nodiscard]] ethercat::master_error check_objects(std::size_t) override {
        ++checks;
        return {};
    }
    [[nodiscard]] result<void> start(bridging::slave_group slaves, jauscat::duration) override {
        ++starts;
        ++number_;
        for (std::size_t i = 0; i != slaves.size(); ++i) {
            if (slaves[i].outputs.size() != image_size || slaves[i].inputs.size() != image_size)
                return errc::wrong_size;
            offset_[i] = static_cast<std::uint16_t>(taken(slaves[i]) - number_);
            put(i, slaves[i], 0);
        }
        return {};
    }
    [[nodiscard]] bool takes(std::uint16_t code) const override {
        return code == jaus::command_code_of<jaus::set_joint_efforts> ||
               code == jaus::command_code_of<jaus::query_joint_efforts>;
    }
    [[nodiscard]] bool uses_mailbox() const override { return false; }
    [[nodiscard]] result<std::uint32_t> command(const jaus::header&, std::span<const std::byte> body,
                                                bridging::slave_group slaves, jauscat::time_point) override {
        jaus::basic_set_joint_efforts<most> told{};
        if (!jauscat::wire::decode(told, body)) return errc::truncated;
        if (told.joint_effort.size() != slaves.size()) return errc::wrong_size;
        ++number_;
        for (std::size_t i = 0; i != slaves.size(); ++i) put(i, slaves[i], told.joint_effort[i]);
        return number_;
    }
    std::uint32_t stop(bridging::stop_order, bridging::slave_group slaves) override {
        ++number_;
        for (std::size_t i = 0; i != slaves.size(); ++i)
            if (!slaves[i].outputs.empty()) put(i, slaves[i], 0);
        return number_;
    }
    [[nodiscard]] std::uint32_t executed(bridging::slave_group slaves) const override {
        for (std::size_t i = 0; i != slaves.size(); ++i)
            if (!slaves[i].outputs.empty() && taken(slaves[i]) != static_cast<std::uint16_t>(number_ + offset_[i]))
                return number_ - 1;
        return number_;
    }
    [[nodiscard]] result<std::span<std::byte>> answer(const jaus::header& query, std::span<const std::byte>,
                                                      bridging::slave_group slaves,
                                                      std::span<std::byte> out) const override {
        jaus::basic_report_joint_efforts<most> report{};
        for (const auto& each : slaves) {
            actuator::image values{};
            static_cast<void>(jauscat::wire::decode(values, each.inputs));
            if (!report.joint_effort.push_back(values.propulsive_linear_effort_x / 327.67)) return errc::no_space;
        }
        const auto made = jaus::make_message(jaus::answer_to(query), report, out);
        if (!made) return errc::no_space;
        return *made;
    }
    std::optional<bridging::drive_fault> step(bridging::slave_group slaves, jauscat::time_point) override {
        ++steps;
        missing =
            static_cast<unsigned>(std::ranges::count_if(slaves, [](const auto& each) { return each.outputs.empty(); }));
        return fault;
    }
    void reset() override {
        ++resets;
        if (reset_helps) fault.reset();
    }

  private:
    static constexpr std::size_t image_size = jauscat::wire::max_size<actuator::image>;

    static std::uint16_t taken(const bridging::slave_data& slave) {
        actuator::image values{};
        static_cast<void>(jauscat::wire::decode(values, slave.inputs));
        return values.command_count;
    }
    void put(std::size_t i, const bridging::slave_data& slave, double percent) const {
        const actuator::image values{.command_count = static_cast<std::uint16_t>(number_ + offset_[i]),
                                     .presence_vector = 1,
                                     .propulsive_linear_effort_x = static_cast<std::int16_t>(percent * 327.67)};
        static_cast<void>(jauscat::wire::encode(values, slave.outputs));
    }

    std::uint32_t number_{};
    std::array<std::uint16_t, most> offset_{};
};

} // namespace test
