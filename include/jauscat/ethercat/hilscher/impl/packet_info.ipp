// The functions of packet_info.
#pragma once
#include <jauscat/ethercat/hilscher/packet_info.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION service_step packet_od_list::begin(master& m, const packet_io& io) noexcept {
    if (const auto wrong = check_target(); wrong != hilscher::packet_status::ok) return service_step::done(wrong);
    if (asked.ul_list_type < hilscher::packet_list_type::all ||
        asked.ul_list_type > hilscher::packet_list_type::start_up)
        return service_step::done(hilscher::packet_status::coe_invalid_list_type);
    return service_step::started(
        m.start(list_objects{station(), static_cast<object_list_type>(asked.ul_list_type), io.room(fields_size)}));
}

JAUSCAT_FUNCTION service_answer packet_od_list::answer(confirmation& out, const master& m,
                                                       const packet_io&) const noexcept {
    const auto indices = m.result<list_objects>();
    if (!indices) return {.status = hilscher::status_of(indices.error())};
    out.ul_node_id = asked.ul_node_id;
    out.ul_list_type = asked.ul_list_type;
    out.ul_data_cnt = static_cast<std::uint32_t>(indices->size());
    return {.size = indices->bytes().size()};
}

JAUSCAT_FUNCTION service_step packet_object::begin(master& m, const packet_io& io) noexcept {
    if (const auto wrong = check_target(); wrong != hilscher::packet_status::ok) return service_step::done(wrong);
    return service_step::started(m.start(describe_object{station(), index(), place(io)}));
}

JAUSCAT_FUNCTION service_answer packet_object::answer(confirmation& out, const master& m,
                                                      const packet_io&) const noexcept {
    const auto described = m.result<describe_object>();
    if (!described) return {.status = hilscher::status_of(described.error())};
    const auto& object = described->object;
    out.ul_node_id = asked.ul_node_id;
    out.ul_index = asked.ul_index;
    out.ul_data_type = object.data_type;
    out.ul_obj_code = static_cast<std::uint32_t>(object.code) & 0x0Fu;
    out.ul_obj_category = static_cast<std::uint32_t>(object.code) >> 4;
    out.ul_max_num_sub_index = object.highest_subindex;
    out.ul_ob_name_len = static_cast<std::uint32_t>(described->name.size());
    return {.size = described->name.size()};
}

JAUSCAT_FUNCTION std::span<std::byte> packet_object::place(const packet_io& io) noexcept {
    return io.room(fields_size - wire::max_size<object_answer>);
}

JAUSCAT_FUNCTION service_step packet_entry::begin(master& m, const packet_io& io) noexcept {
    if (const auto wrong = check_target(); wrong != hilscher::packet_status::ok) return service_step::done(wrong);
    if (asked.ul_access_bit_mask > 0x7F)
        return service_step::done(hilscher::packet_status::coe_invalid_access_bit_mask);
    return service_step::started(m.start(describe_entry{
        station(), index(), subindex(), static_cast<std::uint8_t>(asked.ul_access_bit_mask), place(io)}));
}

JAUSCAT_FUNCTION service_answer packet_entry::answer(confirmation& out, const master& m,
                                                     const packet_io& io) const noexcept {
    const auto described = m.result<describe_entry>();
    if (!described) return {.status = hilscher::status_of(described.error())};
    const auto& entry = described->entry;
    auto rest = described->bytes.subspan(wire::max_size<entry_answer>);
    hilscher::entry_unit unit{};
    if ((entry.value_info & unit_bit) != 0) {
        const auto used = wire::decode_prefix(unit, rest);
        if (!used) return {.status = hilscher::status_of({.code = master_errc::unexpected_reply})};
        rest = rest.subspan(*used);
    }
    const auto values = io.room(fields_size);
    if (rest.size() > values.size()) return {.status = hilscher::packet_status::coe_slave_response_too_big};
    std::ranges::copy_backward(rest, values.begin() + static_cast<std::ptrdiff_t>(rest.size()));

    out.ul_node_id = asked.ul_node_id;
    out.ul_index = asked.ul_index;
    out.ul_sub_index = asked.ul_sub_index;
    out.ul_value_info = entry.value_info;
    out.ul_data_type = entry.data_type;
    out.ul_bit_len = entry.bits;
    out.ul_ob_access = entry.access;
    out.f_rx_pdo_mapping = entry.access.rx_pdo ? 1 : 0;
    out.f_tx_pdo_mapping = entry.access.tx_pdo ? 1 : 0;
    out.ul_unit_type = unit.ul_unit_type;
    out.ul_data_len = static_cast<std::uint32_t>(rest.size());
    return {.size = rest.size()};
}

JAUSCAT_FUNCTION std::span<std::byte> packet_entry::place(const packet_io& io) noexcept {
    return io.room(fields_size - wire::max_size<entry_answer> - wire::max_size<hilscher::entry_unit>);
}

} // namespace jauscat::ethercat
