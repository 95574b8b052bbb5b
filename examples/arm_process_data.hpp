// The robot arm's process data: efforts commanded every cycle, and the efforts in force the way back.
#pragma once
#include "arm_application.hpp"
#include <jauscat/ethercat/image_entries.hpp>
#include <jauscat/ethercat/slave.hpp>
#include <jauscat/schema/translation/wrench_effort_image.hpp>
#include <jauscat/translate/image_translator.hpp>

namespace example {

/// The arm's side of the image tables for wrench efforts.
class arm_process_data {
  public:
    using image = jauscat::translation::wrench_effort_image;
    /// For the slave's description.
    static constexpr std::span<const jauscat::ethercat::pdo_entry> outputs{
        jauscat::ethercat::image_entries<image, jauscat::ethercat::image_objects::outputs>};
    static constexpr std::span<const jauscat::ethercat::pdo_entry> inputs{
        jauscat::ethercat::image_entries<image, jauscat::ethercat::image_objects::inputs>};

    explicit arm_process_data(arm& behind) : arm_{behind} {}

    /// To be called after each frame and after time has passed: obeys a new command in the outputs, and writes the
    /// inputs. An arm that was driven by process data stops when these are no longer in OP.
    void work(jauscat::ethercat::slave& slave) {
        if (slave.take_outputs()) take(slave.outputs());
        if (driven_ && slave.state() != jauscat::ethercat::al_state::op) {
            driven_ = false;
            arm_.halt("no process data any more");
        }
        give(slave.inputs());
    }

  private:
    using command = jauscat::translate::image_translator<jauscat::translation::set_wrench_effort_table>;
    using report = jauscat::translate::image_translator<jauscat::translation::report_wrench_effort_table>;

    void take(std::span<const std::byte> written) {
        image values{};
        if (!jauscat::wire::decode(values, written) || values.command_count == 0 || values.command_count == taken_)
            return;
        taken_ = values.command_count;
        std::array<std::byte, jauscat::wire::max_size<jauscat::jaus::set_wrench_effort>> body{};
        const auto size = command::back(written, body);
        if (!size) return arm_.say("refused process data: " + std::string{describe(size.error())});
        driven_ = true;
        arm_.say("efforts by process data, command " + std::to_string(taken_));
        arm_.drive_by(std::span{body}.first(size.size()));
    }

    void give(std::span<std::byte> read_next) const {
        std::array<std::byte, jauscat::wire::max_size<jauscat::jaus::report_wrench_effort>> body{};
        const auto size = jauscat::wire::encode(arm_.efforts(), body);
        std::array<std::byte, report::image_size> bytes{};
        static_cast<void>(jauscat::wire::encode(image{.command_count = taken_}, bytes)); // fits: it is all zeros
        if (read_next.size() == bytes.size() && size &&
            report::forth(std::span{body}.first(size.size()), bytes) == jauscat::translate::errc::ok)
            std::ranges::copy(bytes, read_next.begin());
    }

    arm& arm_;
    std::uint16_t taken_{}; ///< counter of the last command
    bool driven_{};
};

} // namespace example
