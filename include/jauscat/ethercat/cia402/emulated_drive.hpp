// An emulated CiA 402 drive with one or more axes, for an emulated slave: its objects and its process data.
#pragma once

#include <jauscat/ethercat/cia402/axis_places.hpp>
#include <jauscat/ethercat/cia402/emulated_axis.hpp>
#include <jauscat/ethercat/slave/assignable_pdos.hpp>
#include <jauscat/ethercat/slave/object_dictionary.hpp>
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/ethercat/slave/slave_description.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::cia402 {

namespace detail {

/// Where no object is mapped.
inline constexpr object padding_byte{.bits = 8};

// Objects, not pointers to them: with UBSan, g++ compares no address of a base with nullptr in a constant expression.
template <std::size_t Axes, std::size_t Count>
consteval std::array<ethercat::pdo_entry, Axes * Count> entries_of(const std::array<object, Count>& mapped) {
    std::array<ethercat::pdo_entry, Axes * Count> entries{};
    for (std::size_t i = 0; i != entries.size(); ++i) {
        const auto& each = mapped[i % Count];
        if (each.index == 0)
            entries[i] = {.bits = each.bits};
        else
            entries[i] = {.index = each.index_of(i / Count),
                          .subindex = each.subindex,
                          .bits = each.bits,
                          .data_type = static_cast<std::uint8_t>(each.data_type),
                          .name = each.name};
    }
    return entries;
}
template <std::size_t Axes, std::size_t Count> consteval auto layout_of(const std::array<object, Count>& mapped) {
    pdo_layout<Axes * Count> layout;
    for (std::size_t i = 0; i != Axes * Count; ++i) {
        const auto& each = mapped[i % Count];
        static_cast<void>(layout.append(each.index == 0 ? padding(each.bits) : mapping_of(each, i / Count)));
    }
    return layout;
}

inline constexpr std::array<object, 6> mapped_outputs{
    objects::controlword,     objects::mode_of_operation, padding_byte,
    objects::target_position, objects::target_velocity,   objects::target_torque};
inline constexpr std::array<object, 7> mapped_inputs{
    objects::statusword,      objects::mode_display,  padding_byte,       objects::position_actual,
    objects::velocity_actual, objects::torque_actual, objects::error_code};

} // namespace detail

/// The process data of the emulated drive: those of `cyclic_outputs` and `cyclic_inputs`, for each axis.
template <std::size_t Axes = 1> inline constexpr auto drive_outputs = detail::entries_of<Axes>(detail::mapped_outputs);
template <std::size_t Axes = 1> inline constexpr auto drive_inputs = detail::entries_of<Axes>(detail::mapped_inputs);

/// A slave with this description and, behind `standard_objects`, an `emulated_drive` is a drive; with `assignable_pdos`
/// in front of both a drive that a master maps as it needs it.
template <std::size_t Axes = 1>
inline constexpr ethercat::slave_description drive_description{.vendor = 0x4A43,
                                                               .product = 0x402,
                                                               .revision = 1,
                                                               .mailbox_out_size = 128,
                                                               .mailbox_in_size = 128,
                                                               .name = "Emulated CiA 402 drive",
                                                               .outputs = drive_outputs<Axes>,
                                                               .inputs = drive_inputs<Axes>,
                                                               .synchronization = true};

/// The objects of `Axes` axes, and their process data. Models described_object_source.
template <std::size_t Axes = 1> class emulated_drive {
    static_assert(Axes >= 1 && Axes <= max_axes, "emulated_drive: a drive has 1 to 8 axes");

  public:
    std::array<emulated_axis, Axes> axes{};

    constexpr emulated_drive() noexcept = default;
    explicit constexpr emulated_drive(const motor_model& motor) noexcept { axes.fill(emulated_axis{motor}); }

    /// The drive's part of a cycle: outputs in, up to `now`, inputs out. To be called after each frame, and every few
    /// milliseconds without one.
    void work(ethercat::slave& slave, time_point now) noexcept {
        const bool operational = slave.state() == ethercat::al_state::op;
        if (slave.take_outputs() && operational) take(slave.outputs());
        for (auto& each : axes) each.on_time(now, operational);
        if (const auto inputs = slave.inputs(); !inputs.empty()) give(inputs);
    }
    /// The same with PDOs that the master maps and assigns.
    void work(ethercat::slave& slave, ethercat::assignable_pdos& pdos, time_point now) noexcept {
        pdos.follow(slave);
        const bool operational = slave.state() == ethercat::al_state::op;
        if (slave.take_outputs() && operational) {
            pdos.take(slave.outputs());
            for (auto& each : axes) each.on_targets();
        }
        for (auto& each : axes) each.on_time(now, operational);
        if (const auto inputs = slave.inputs(); !inputs.empty()) pdos.give(inputs);
    }
    /// New outputs of the master.
    constexpr void take(std::span<const std::byte> outputs) noexcept {
        for (std::size_t i = 0; i != Axes; ++i) {
            auto& values = axes[i].values;
            const auto& at = places[i];
            values.controlword = load<std::uint16_t>(at.controlword, outputs);
            values.mode_of_operation = load<std::int8_t>(at.mode, outputs);
            values.target_position = load<std::int32_t>(at.target_position, outputs);
            values.target_velocity = load<std::int32_t>(at.target_velocity, outputs);
            values.target_torque = load<std::int16_t>(at.target_torque, outputs);
            axes[i].on_targets();
        }
    }
    /// The inputs for the master.
    constexpr void give(std::span<std::byte> inputs) const noexcept {
        for (std::size_t i = 0; i != Axes; ++i) {
            const auto& values = axes[i].values;
            const auto& at = places[i];
            store(at.statusword, inputs, values.statusword);
            store(at.mode_display, inputs, values.mode_display);
            store(at.position, inputs, values.position_actual);
            store(at.velocity, inputs, values.velocity_actual);
            store(at.torque, inputs, values.torque_actual);
            store(at.error_code, inputs, values.error_code);
        }
    }

    /// Aborts: no_object, no_subindex, exceeds_mailbox.
    ethercat::object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
        const auto found = find(index, subindex);
        if (found.error != ethercat::abort_code::none) return {.error = found.error};
        const std::size_t size = found.slot == nullptr ? 1 : found.slot->described->bits / 8u;
        if (size > out.size()) return {.error = ethercat::abort_code::exceeds_mailbox};
        const auto value =
            found.slot == nullptr ? std::int64_t{highest(index)} : found.slot->get(axes[found.axis].values);
        store(pdo_place{0, static_cast<std::uint8_t>(size * 8)}, out, value);
        return {.size = size};
    }
    /// Aborts: no_object, no_subindex, read_only, length_mismatch.
    [[nodiscard]] ethercat::abort_code write(std::uint16_t index, std::uint8_t subindex,
                                             std::span<const std::byte> data) noexcept {
        const auto found = find(index, subindex);
        if (found.error != ethercat::abort_code::none) return found.error;
        if (found.slot == nullptr || !found.slot->described->writable) return ethercat::abort_code::read_only;
        if (data.size() * 8 != found.slot->described->bits) return ethercat::abort_code::length_mismatch;
        found.slot->set(axes[found.axis].values, load<std::int64_t>(pdo_place{0, found.slot->described->bits}, data));
        return ethercat::abort_code::none;
    }
    [[nodiscard]] std::uint16_t next_index(std::uint16_t after) const noexcept {
        for (std::size_t axis = 0; axis != Axes; ++axis)
            for (const auto& each : value_slots)
                if (each.described->index_of(axis) > after) return each.described->index_of(axis);
        return 0;
    }
    [[nodiscard]] std::optional<ethercat::object_info> describe(std::uint16_t index) const noexcept {
        const auto* const slot = first_of(index);
        if (slot == nullptr) return {};
        const bool variable = slot->described->subindex == 0;
        return ethercat::object_info{.data_type = slot->described->data_type,
                                     .highest_subindex = highest(index),
                                     .code = variable ? ethercat::object_code::variable : ethercat::object_code::record,
                                     .name = slot->described->name,
                                     .complete_access = !variable};
    }
    [[nodiscard]] std::optional<ethercat::entry_info> describe(std::uint16_t index,
                                                               std::uint8_t subindex) const noexcept {
        const auto found = find(index, subindex);
        if (found.error != ethercat::abort_code::none) return {};
        if (found.slot == nullptr) return ethercat::highest_subindex_info;
        const auto& object = *found.slot->described;
        auto access = object.writable ? ethercat::accessible_always : ethercat::readable_always;
        access.rx_pdo = object.mapping == mapping::outputs;
        access.tx_pdo = object.mapping == mapping::inputs;
        return ethercat::entry_info{
            .data_type = object.data_type, .bits = object.bits, .access = access, .name = object.name};
    }

  private:
    struct place_of_value {
        const value_slot* slot{}; // nullptr: subindex 0 of a record
        std::size_t axis{};
        ethercat::abort_code error{};
    };

    static constexpr auto places = [] {
        std::array<axis_places, Axes> made{};
        constexpr auto outputs = detail::layout_of<Axes>(detail::mapped_outputs);
        constexpr auto inputs = detail::layout_of<Axes>(detail::mapped_inputs);
        for (std::size_t i = 0; i != Axes; ++i) made[i] = places_of(outputs, inputs, i);
        return made;
    }();

    static constexpr std::size_t axis_of(std::uint16_t index) noexcept {
        return index < 0x6000 ? Axes : std::size_t{index - 0x6000u} / axis_offset;
    }
    static constexpr const value_slot* first_of(std::uint16_t index) noexcept {
        const auto axis = axis_of(index);
        if (axis >= Axes) return nullptr;
        for (const auto& each : value_slots)
            if (each.described->index_of(axis) == index) return &each;
        return nullptr;
    }
    static constexpr std::uint8_t highest(std::uint16_t index) noexcept {
        std::uint8_t most = 0;
        for (const auto& each : value_slots)
            if (each.described->index_of(axis_of(index)) == index) most = std::max(most, each.described->subindex);
        return most;
    }
    static constexpr place_of_value find(std::uint16_t index, std::uint8_t subindex) noexcept {
        const auto* const first = first_of(index);
        if (first == nullptr) return {.error = ethercat::abort_code::no_object};
        const auto axis = axis_of(index);
        for (const auto& each : value_slots)
            if (each.described->index_of(axis) == index && each.described->subindex == subindex)
                return {.slot = &each, .axis = axis};
        if (subindex == 0) return {.axis = axis};
        return {.axis = axis, .error = ethercat::abort_code::no_subindex};
    }
};

} // namespace jauscat::cia402
