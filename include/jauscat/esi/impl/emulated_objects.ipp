// The functions of emulated_objects.
#pragma once
#include <jauscat/esi/device_sii.hpp>
#include <jauscat/esi/emulated_objects.hpp>
#include <jauscat/esi/text_values.hpp>
#include <jauscat/ethercat/slave/copy_bits.hpp>

#include <algorithm>
#include <utility>

namespace jauscat::esi {

namespace detail {

/// Values of these types may be shorter than the type.
inline bool has_any_length(std::string_view type) {
    return is_string_type(type) || type.starts_with("UNICODE_STRING(") || type.starts_with("OCTET_STRING(");
}
/// Of a base type without a number of its own, that of an unsigned number of the same size, or of octets.
inline std::uint16_t type_number(const entry& of) {
    if (const auto known = parse_data_type(of.type); known != 0) return known;
    if (is_string_type(of.type)) return ethercat::data_types::visible_string;
    switch (of.bit_size) {
    case 8: return ethercat::data_types::unsigned8;
    case 16: return ethercat::data_types::unsigned16;
    case 32: return ethercat::data_types::unsigned32;
    case 64: return ethercat::data_types::unsigned64;
    default: return bridging::octet_string_type;
    }
}

} // namespace detail

inline namespace JAUSCAT_WAY {

JAUSCAT_DECL emulated_objects::emulated_objects(const emulated_device& of, ethercat::object_dictionary application)
    : device_{of},
      listed_{of.components(), application},
      mapped_{of.description(), listed_},
      standard_{of.description(), mapped_} {
    if (of.is_plain() || !of.source().has_coe) return;
    add_file_objects();
    add_values_of_device();
    add_places();
}

JAUSCAT_DECL void emulated_objects::show(ethercat::slave& of) noexcept {
    slave_ = &of;
    if (device_.is_plain()) mapped_.show(of.outputs(), of.inputs());
}

JAUSCAT_DECL void emulated_objects::add_file_objects() {
    for (const auto& each : device_.source().objects) {
        if (detail::find_property(each.properties, property_names::component) != nullptr) continue;
        auto& made = objects_[each.index];
        made.code = each.code;
        made.name = each.name;
        for (const auto& entry : each.entries) {
            stored_entry stored{.what = entry, .value = entry.default_data};
            const std::size_t size = (entry.bit_size + 7) / 8;
            stored.value.reserve(std::max<std::size_t>(size, 1));
            if (!detail::has_any_length(entry.type)) stored.value.resize(size);
            if (stored.value.empty()) stored.value.resize(1); // an empty text
            if (entry.subindex == 0 && entry.default_data.empty() && each.code != object_code::variable)
                stored.value.front() = static_cast<std::byte>(each.entries.back().subindex);
            made.entries.emplace(entry.subindex, std::move(stored));
        }
    }
}

JAUSCAT_DECL void emulated_objects::set_list(std::uint16_t index, const std::string& name, const char* type,
                                             std::size_t bytes, const std::vector<std::uint32_t>& values,
                                             bool is_configuration) {
    const bool is_new = !objects_.contains(index);
    auto& object = objects_[index];
    if (is_new) object.name = name;
    object.code = is_new ? object_code::record : object.code;
    const auto set = [&](std::uint8_t subindex, const char* of_type, std::size_t size, std::uint32_t value) {
        auto [at, is_added] = object.entries.try_emplace(
            subindex, stored_entry{.what = {.subindex = subindex,
                                            .name = subindex == 0 ? "Highest subindex" : name,
                                            .type = of_type,
                                            .bit_size = static_cast<std::uint32_t>(size * 8),
                                            .readable = true}});
        at->second.value = little_endian(value, (at->second.what.bit_size + 7) / 8);
    };
    set(0, "USINT", 1, static_cast<std::uint32_t>(values.size()));
    for (std::size_t i = 0; i != values.size(); ++i) set(static_cast<std::uint8_t>(i + 1), type, bytes, values[i]);
    for (auto& [subindex, each] : object.entries) each.is_fixed = is_configuration;
}

JAUSCAT_DECL emulated_objects::stored_entry& emulated_objects::mapped_entry(const pdo_entry& of, bool is_output) {
    const bool is_new = !objects_.contains(of.index);
    auto& object = objects_[of.index];
    if (is_new) {
        object.name = is_output ? "Mapped outputs" : "Mapped inputs";
        object.code = of.subindex == 0 ? object_code::variable : object_code::record;
    }
    if (of.subindex != 0) {
        auto& count =
            object.entries
                .try_emplace(
                    std::uint8_t{0},
                    stored_entry{.what = {.name = "Highest subindex", .type = "USINT", .bit_size = 8, .readable = true},
                                 .value = {std::byte{0}}})
                .first->second.value;
        if (!count.empty()) count[0] = std::max(count[0], static_cast<std::byte>(of.subindex));
    }
    return object.entries
        .try_emplace(of.subindex, stored_entry{.what = {.subindex = of.subindex,
                                                        .name = of.name,
                                                        .type = of.type,
                                                        .bit_size = of.bits,
                                                        .readable = true},
                                               .value = std::vector<std::byte>((of.bits + 7u) / 8u)})
        .first->second;
}

JAUSCAT_DECL void emulated_objects::add_values_of_device() {
    using namespace ethercat::standard_indices;
    using use = ethercat::sii_sync_manager_use;
    const auto& of = device_.source();
    if (!objects_.contains(device_type)) {
        objects_[device_type] = {.code = object_code::variable, .name = "Device type"};
        objects_[device_type].entries.emplace(
            std::uint8_t{0},
            stored_entry{.what = {.name = "Device type", .type = "UDINT", .bit_size = 32, .readable = true},
                         .value = little_endian(of.profile, 4)});
    }
    set_list(identity, "Identity", "UDINT", 4, {of.vendor_id, of.product_code, of.revision, of.serial}, false);
    std::vector<std::uint32_t> uses;
    for (const auto& each : of.sync_managers) uses.push_back(static_cast<std::uint32_t>(each.use));
    set_list(sync_manager_types, "SyncManager types", "USINT", 1, uses, false);
    for (const auto* const direction : {&of.rx_pdos, &of.tx_pdos})
        for (const auto& each : *direction) {
            std::vector<std::uint32_t> mapping;
            for (const auto& entry : each.entries)
                mapping.push_back(std::uint32_t{entry.index} << 16 | std::uint32_t{entry.subindex} << 8 | entry.bits);
            set_list(each.index, each.name.empty() ? "PDO" : each.name, "UDINT", 4, mapping, true);
        }
    constexpr std::uint16_t first_assignment = output_assignment - ethercat::manager_numbers::outputs;
    for (std::size_t i = 0; i != of.sync_managers.size(); ++i) {
        if (of.sync_managers[i].use == use::mailbox_out || of.sync_managers[i].use == use::mailbox_in) continue;
        std::vector<std::uint32_t> assigned;
        for (const auto* const direction : {&of.rx_pdos, &of.tx_pdos})
            for (const auto& each : *direction)
                if (each.sync_manager == i) assigned.push_back(each.index);
        set_list(static_cast<std::uint16_t>(first_assignment + i), "PDO assignment", "UINT", 2, assigned, true);
    }
}

JAUSCAT_DECL void emulated_objects::add_places() {
    const auto& of = device_.source();
    std::size_t output_bit = 0, input_area = 0;
    for (const auto& area : device_.description().areas) {
        std::size_t bit = area.is_output ? output_bit : 0;
        for (const auto& each : area.is_output ? of.rx_pdos : of.tx_pdos) {
            if (each.sync_manager != area.manager) continue;
            for (const auto& entry : each.entries) {
                if (entry.index != 0)
                    mapped_entry(entry, area.is_output).mapped = {area.is_output, input_area, bit, entry.bits};
                bit += entry.bits;
            }
        }
        if (area.is_output)
            output_bit += std::size_t{area.size} * 8;
        else
            ++input_area;
    }
}

JAUSCAT_DECL ethercat::object_read emulated_objects::read(std::uint16_t index, std::uint8_t subindex,
                                                          std::span<std::byte> out) noexcept {
    if (device_.is_plain()) return standard_.read(index, subindex, out);
    if (!objects_.contains(index)) return listed_.read(index, subindex, out);
    const auto* const at = find_in(objects_, index, subindex);
    if (at == nullptr) return {.error = ethercat::abort_code::no_subindex};
    if (!at->what.readable) return {.error = ethercat::abort_code::write_only};
    if (at->value.size() > out.size()) return {.error = ethercat::abort_code::exceeds_mailbox};
    std::ranges::copy(at->value, out.begin());
    if (at->mapped && slave_ != nullptr) {
        const std::span<const std::byte> memory =
            at->mapped->is_output ? slave_->outputs() : slave_->inputs(at->mapped->area);
        const auto bits = std::min(at->mapped->bits, at->value.size() * 8);
        if (at->mapped->first_bit + bits <= memory.size() * 8)
            ethercat::copy_bits(memory, at->mapped->first_bit, out, 0, bits);
    }
    return {.size = at->value.size()};
}

JAUSCAT_DECL ethercat::abort_code emulated_objects::write(std::uint16_t index, std::uint8_t subindex,
                                                          std::span<const std::byte> data) noexcept {
    using enum ethercat::abort_code;
    if (device_.is_plain()) return standard_.write(index, subindex, data);
    if (!objects_.contains(index)) return listed_.write(index, subindex, data);
    auto* const at = find_in(objects_, index, subindex);
    if (at == nullptr) return no_subindex;
    if (!at->what.writable) return read_only;
    const std::size_t size = (at->what.bit_size + 7) / 8;
    if (data.size() > size) return length_too_high;
    if (data.size() < size && !detail::has_any_length(at->what.type)) return length_too_low;
    if (at->is_fixed) {
        // A master that configures PDOs clears their number first.
        const bool is_cleared =
            subindex == 0 && std::ranges::all_of(data, [](std::byte b) { return b == std::byte{}; });
        return is_cleared || std::ranges::equal(data, at->value) ? none : value_range;
    }
    at->value.assign(data.begin(), data.end());
    return none;
}

JAUSCAT_DECL bool emulated_objects::is_described() const noexcept {
    return device_.is_plain() || device_.source().coe.sdo_information;
}

JAUSCAT_DECL std::uint16_t emulated_objects::next_index(std::uint16_t after) const noexcept {
    if (device_.is_plain()) return standard_.next_index(after);
    const auto listed = listed_.next_index(after);
    const auto next = objects_.upper_bound(after);
    if (next == objects_.end()) return listed;
    return listed == 0 ? next->first : std::min(listed, next->first);
}

JAUSCAT_DECL std::optional<ethercat::object_info> emulated_objects::describe(std::uint16_t index) const noexcept {
    if (device_.is_plain()) return standard_.describe(index);
    const auto found = objects_.find(index);
    if (found == objects_.end()) return listed_.describe(index);
    const auto& [code, name, entries] = found->second;
    if (entries.empty()) return {};
    const auto highest = entries.rbegin()->first;
    const auto is_text = [](const auto& each) { return detail::has_any_length(each.second.what.type); };
    return ethercat::object_info{
        .data_type = code == object_code::record ? std::uint16_t{} : detail::type_number(entries.rbegin()->second.what),
        .highest_subindex = highest,
        .code = static_cast<ethercat::object_code>(code),
        .name = name,
        .complete_access =
            code != object_code::variable && entries.size() == highest + 1u && std::ranges::none_of(entries, is_text)};
}

JAUSCAT_DECL std::optional<ethercat::entry_info> emulated_objects::describe(std::uint16_t index,
                                                                            std::uint8_t subindex) const noexcept {
    if (device_.is_plain()) return standard_.describe(index, subindex);
    if (!objects_.contains(index)) return listed_.describe(index, subindex);
    const auto* const at = find_in(objects_, index, subindex);
    if (at == nullptr) return {};
    ethercat::entry_access access{};
    if (at->what.readable) access = ethercat::readable_always;
    access.write_pre_op = access.write_safe_op = access.write_op = at->what.writable;
    if (at->mapped) (at->mapped->is_output ? access.rx_pdo : access.tx_pdo) = true;
    return ethercat::entry_info{.data_type = detail::type_number(at->what),
                                .bits = static_cast<std::uint16_t>(std::min<std::uint32_t>(at->what.bit_size, 0xFFFF)),
                                .access = access,
                                .name = at->what.name};
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::esi
