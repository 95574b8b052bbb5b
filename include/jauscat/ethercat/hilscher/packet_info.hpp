// Packets that read a slave's object dictionary by SDO information. The slave's answers are read into the confirmation,
// to where their variable part has its place.
#pragma once

#include <jauscat/ethercat/hilscher/packet_service.hpp>
#include <jauscat/schema/ethercat/hilscher_info.hpp>

namespace jauscat::ethercat {

/// The packet that lists a slave's objects.
class packet_od_list : public packet_coe_service<hilscher::get_od_list_request, hilscher::get_od_list_confirmation, 8> {
  public:
    service_step begin(master& m, const packet_io& io) noexcept {
        if (const auto wrong = check_target(); wrong != hilscher::packet_status::ok) return service_step::done(wrong);
        if (asked.ul_list_type < hilscher::packet_list_type::all ||
            asked.ul_list_type > hilscher::packet_list_type::start_up)
            return service_step::done(hilscher::packet_status::coe_invalid_list_type);
        return service_step::started(
            m.start(list_objects{station(), static_cast<object_list_type>(asked.ul_list_type), io.room(fields_size)}));
    }
    service_answer answer(confirmation& out, const master& m, const packet_io&) const noexcept {
        const auto indices = m.result<list_objects>();
        if (!indices) return {.status = hilscher::status_of(indices.error())};
        out.ul_node_id = asked.ul_node_id;
        out.ul_list_type = asked.ul_list_type;
        out.ul_data_cnt = static_cast<std::uint32_t>(indices->size());
        return {.size = indices->bytes().size()};
    }
};

/// The packet that describes one object.
class packet_object : public packet_coe_service<hilscher::get_object_description_request,
                                                hilscher::get_object_description_confirmation, 8> {
  public:
    service_step begin(master& m, const packet_io& io) noexcept {
        if (const auto wrong = check_target(); wrong != hilscher::packet_status::ok) return service_step::done(wrong);
        return service_step::started(m.start(describe_object{station(), index(), place(io)}));
    }
    service_answer answer(confirmation& out, const master& m, const packet_io&) const noexcept {
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

  private:
    // The name comes to lie where the confirmation has it.
    [[nodiscard]] static std::span<std::byte> place(const packet_io& io) noexcept {
        return io.room(fields_size - wire::max_size<object_answer>);
    }
};

/// The packet that describes one entry of an object.
class packet_entry : public packet_coe_service<hilscher::get_entry_description_request,
                                               hilscher::get_entry_description_confirmation, 12> {
  public:
    service_step begin(master& m, const packet_io& io) noexcept {
        if (const auto wrong = check_target(); wrong != hilscher::packet_status::ok) return service_step::done(wrong);
        if (asked.ul_access_bit_mask > 0x7F)
            return service_step::done(hilscher::packet_status::coe_invalid_access_bit_mask);
        return service_step::started(m.start(describe_entry{
            station(), index(), subindex(), static_cast<std::uint8_t>(asked.ul_access_bit_mask), place(io)}));
    }
    service_answer answer(confirmation& out, const master& m, const packet_io& io) const noexcept {
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

  private:
    static constexpr unsigned unit_bit = 0x08;

    // Where there is a unit, the values behind it come to lie where the confirmation has them; else they move by 4
    // bytes.
    [[nodiscard]] static std::span<std::byte> place(const packet_io& io) noexcept {
        return io.room(fields_size - wire::max_size<entry_answer> - wire::max_size<hilscher::entry_unit>);
    }
};

} // namespace jauscat::ethercat
