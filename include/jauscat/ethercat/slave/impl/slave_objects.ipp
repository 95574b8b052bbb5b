// The functions of slave_objects.
#pragma once
#include <jauscat/ethercat/slave/slave_objects.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION abort_code slave_objects::refusal(const transfer_object& object, bool writes) noexcept {
    if (!object.complete) {
        const auto refused = refusal(object.index, object.subindex, writes);
        return refused == abort_code::none && writes ? count_refusal(object.index, object.subindex) : refused;
    }
    const complete_object whole{*this, object.index, object.subindex};
    if (!whole.is_possible())
        return is_described() && !describe(object.index) ? abort_code::no_object : abort_code::complete_access;
    return whole.for_subindices([&](std::uint8_t subindex) {
        if (writes && subindex == 0) return chosen_refusal(object.index, subindex);
        const auto refused = refusal(object.index, subindex, writes);
        if (refused != abort_code::none || !writes) return refused;
        if (!is_writable(describe(object.index, subindex)->access)) return abort_code::read_only;
        // From subindex 0 on, the transfer clears the count itself.
        return object.subindex == 0 ? abort_code::none : count_refusal(object.index, subindex);
    });
}

JAUSCAT_FUNCTION object_read slave_objects::read(const transfer_object& object, std::span<std::byte> out) noexcept {
    if (object.complete) return complete_object{*this, object.index, object.subindex}.read(out);
    return read(object.index, object.subindex, out);
}

JAUSCAT_FUNCTION abort_code slave_objects::write(const transfer_object& object,
                                                 std::span<const std::byte> data) noexcept {
    if (!object.complete) return write(object.index, object.subindex, data);
    complete_object whole{*this, object.index, object.subindex};
    return data.size() == whole.size() ? whole.write(data) : abort_code::length_mismatch;
}

JAUSCAT_FUNCTION object_read slave_objects::read(std::uint16_t index, std::uint8_t subindex,
                                                 std::span<std::byte> out) noexcept {
    if (!keeps_count(index) || subindex != 0) return objects_.read(index, subindex, out);
    if (out.empty()) return {.error = abort_code::exceeds_mailbox};
    out[0] = static_cast<std::byte>(rule_.entries(index));
    return {.size = 1};
}

JAUSCAT_FUNCTION abort_code slave_objects::write(std::uint16_t index, std::uint8_t subindex,
                                                 std::span<const std::byte> data) noexcept {
    if (!keeps_count(index) || subindex != 0) return objects_.write(index, subindex, data);
    if (data.size() != 1) return abort_code::length_mismatch;
    rule_.set_entries(index, std::to_integer<std::uint8_t>(data[0]));
    return abort_code::none;
}

JAUSCAT_FUNCTION std::optional<object_info> slave_objects::describe(std::uint16_t index) const noexcept {
    return objects_.describe(index);
}

JAUSCAT_FUNCTION std::optional<entry_info> slave_objects::describe(std::uint16_t index,
                                                                   std::uint8_t subindex) const noexcept {
    auto entry = objects_.describe(index, subindex);
    if (!entry) return entry;
    if (subindex == 0 && keeps_count(index))
        entry->access.write_pre_op = entry->access.write_safe_op = entry->access.write_op = true;
    if (options_.state_rule && subindex_0_rule::covers(index))
        entry->access.write_safe_op = entry->access.write_op = false;
    return entry;
}

JAUSCAT_FUNCTION abort_code slave_objects::refusal(std::uint16_t index, std::uint8_t subindex,
                                                   bool writes) const noexcept {
    const auto chosen = chosen_refusal(index, subindex);
    return chosen != abort_code::none ? chosen : state_refusal(index, subindex, writes);
}

JAUSCAT_FUNCTION abort_code slave_objects::chosen_refusal(std::uint16_t index, std::uint8_t subindex) const noexcept {
    for (const auto& each : options_.refused)
        if (each.index == index && (!each.subindex || *each.subindex == subindex)) return each.code;
    return abort_code::none;
}

JAUSCAT_FUNCTION abort_code slave_objects::count_refusal(std::uint16_t index, std::uint8_t subindex) const noexcept {
    return keeps_count(index) ? rule_.refusal(index, subindex) : abort_code::none;
}

JAUSCAT_FUNCTION abort_code slave_objects::state_refusal(std::uint16_t index, std::uint8_t subindex,
                                                         bool writes) const noexcept {
    if (!options_.state_rule) return abort_code::none;
    const auto entry = describe(index, subindex);
    if (!entry) { // of objects that say nothing, only those are known
        const bool mapping = !is_described() && subindex_0_rule::covers(index);
        return mapping && writes && state_ != al_state::pre_op ? abort_code::device_state : abort_code::none;
    }
    const auto& a = entry->access;
    const bool now = state_ == al_state::op        ? (writes ? a.write_op : a.read_op)
                     : state_ == al_state::safe_op ? (writes ? a.write_safe_op : a.read_safe_op)
                                                   : (writes ? a.write_pre_op : a.read_pre_op);
    const bool ever = writes ? is_writable(a) : is_readable(a);
    return ever && !now ? abort_code::device_state : abort_code::none;
}

JAUSCAT_FUNCTION bool slave_objects::keeps_count(std::uint16_t index) const noexcept {
    if (!options_.subindex_0_rule || !subindex_0_rule::covers(index)) return false;
    const auto object = objects_.describe(index);
    if (!object) return true;
    for (unsigned subindex = 1; subindex <= object->highest_subindex; ++subindex) {
        const auto entry = objects_.describe(index, static_cast<std::uint8_t>(subindex));
        if (entry && is_writable(entry->access)) return true;
    }
    return false;
}

} // namespace jauscat::ethercat
