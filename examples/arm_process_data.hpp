// The robot arm's process data: commanded efforts in the outputs, efforts in force in the inputs.
#pragma once
#include "arm_application.hpp"
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/schema/translation/wrench_effort_image.hpp>
#include <jauscat/translate/image_translator.hpp>

namespace example {

/// The arm's side of the image tables for wrench efforts.
class arm_process_data {
  public:
    using image = jauscat::translation::wrench_effort_image;

    explicit arm_process_data(arm& behind) : arm_{behind} {}

    /// Call after each frame and when time has passed: executes a new command in the outputs, and writes the inputs. A
    /// command that the arm refuses is not executed later either, and the counter in the inputs does not change.
    void work(jauscat::ethercat::slave& slave) {
        const bool is_new = slave.take_outputs();
        if (slave.state() != jauscat::ethercat::al_state::op)
            seen_ = taken_; // the next master counts from there
        else if (is_new)
            take(slave.outputs());
        give(slave.inputs());
    }

  private:
    using command = jauscat::translate::image_translator<jauscat::translation::set_wrench_effort_table>;
    using report = jauscat::translate::image_translator<jauscat::translation::report_wrench_effort_table>;

    void take(std::span<const std::byte> written) {
        image values{};
        if (!jauscat::wire::decode(values, written) || values.command_count == 0 || values.command_count == seen_)
            return;
        seen_ = values.command_count;
        std::array<std::byte, jauscat::wire::max_size<jauscat::jaus::set_wrench_effort>> body{};
        const auto restored = command::from_image(written, body);
        if (!restored)
            return arm_.say(events::message_malformed, {{"reason", describe(restored.error())}},
                            "refused process data: " + std::string{describe(restored.error())});
        arm_.say(events::efforts_commanded, {{"command", seen_}},
                 "efforts by process data, command " + std::to_string(seen_));
        if (arm_.drive_by(*restored) == obedience::obeyed) taken_ = seen_;
    }

    void give(std::span<std::byte> read_next) const {
        std::array<std::byte, jauscat::wire::max_size<jauscat::jaus::report_wrench_effort>> body{};
        const auto encoded = jauscat::wire::encode(arm_.efforts(), body);
        std::array<std::byte, report::image_size> bytes{};
        static_cast<void>(jauscat::wire::encode(image{.command_count = taken_}, bytes)); // fits: it is all zeros
        if (read_next.size() == bytes.size() && encoded && report::to_image(*encoded, bytes))
            std::ranges::copy(bytes, read_next.begin());
    }

    arm& arm_;
    std::uint16_t seen_{};  ///< counter of the last command
    std::uint16_t taken_{}; ///< of the last one that was obeyed
};

} // namespace example
