// CiA 402 drives on an emulated bus.
#pragma once

#include "app/emulated_bus.hpp"
#include <jauscat/ethercat/cia402/emulated_drive.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace jauscat::test {

/// The mode of operation and the byte behind it have changed places.
inline constexpr auto other_drive_outputs = [] {
    auto entries = cia402::drive_outputs<>;
    std::swap(entries[1], entries[2]);
    return entries;
}();

/// The mode of operation is not among them: a master writes it by SDO.
inline constexpr auto outputs_without_mode = [] {
    auto entries = cia402::drive_outputs<>;
    entries[1].index = 0x2000;
    return entries;
}();

struct emulated_joint {
    explicit emulated_joint(const ethercat::slave_description& is = cia402::drive_description<>) : description{is} {}

    cia402::emulated_drive<> drive{};
    ethercat::slave_description description;
    ethercat::standard_objects objects{description, drive};
    ethercat::assignable_pdos pdos{description, objects};
    ethercat::slave slave{description, pdos};
    bool was_up{};
    unsigned bring_ups{};

    [[nodiscard]] cia402::emulated_axis& axis() { return drive.axes[0]; }
    static bool has_clock() { return false; }
    void work(std::span<std::byte>, time_point now) { on_time(now); }
    void on_time(time_point now) {
        slave.work();
        slave.on_time(now);
        const bool is_up = slave.state() != ethercat::al_state::init;
        if (!std::exchange(was_up, is_up) && is_up) ++bring_ups;
        drive.work(slave, pdos, now);
    }
};

class drive_bus : public basic_emulated_bus<emulated_joint> {
  public:
    explicit drive_bus(const std::vector<ethercat::slave_description>& drives)
        : basic_emulated_bus{[&](auto& made) {
              for (const auto& each : drives) made.emplace_back(each);
          }} {}

    void set_fault(std::size_t i, std::uint16_t code) {
        with(i, [&](auto& each) { each.axis().disturbed.fault = code; });
    }
};

} // namespace jauscat::test
