// The functions of object_creation.
#pragma once
#include <jauscat/bridge/object_creation.hpp>

namespace jauscat::bridging {

JAUSCAT_CONSTEXPR std::string_view describe(creation_errc error) noexcept {
    switch (error) {
    case creation_errc::ok: return "ok";
    case creation_errc::truncated: return "truncated: the confirmation is shorter than its layout";
    case creation_errc::not_an_answer: return "not an answer: the packet confirms something else";
    case creation_errc::refused: return "refused: the slave did not create the object, see the status";
    }
    return "unknown error";
}

JAUSCAT_CONSTEXPR object_creation::object_creation(const object_description& object,
                                                   const hilscher::packet_header& given) noexcept
    : object_{object}, given_{given} {}

JAUSCAT_CONSTEXPR result<std::span<std::byte>, wire::errc>
object_creation::packet(std::size_t number, std::span<std::byte> out) const noexcept {
    return number == 0 ? object_packet(out) : subobject_packet(number, out);
}

JAUSCAT_CONSTEXPR creation_answer object_creation::answer(std::size_t number,
                                                          std::span<const std::byte> bytes) const noexcept {
    using hilscher::packet_command;
    const auto command = number == 0 ? packet_command::od_create_object_cnf : packet_command::od_create_subobject_cnf;
    hilscher::packet_header head{};
    if (!wire::decode_prefix(head, bytes)) return {creation_errc::truncated};
    if (head.ul_cmd != command || head.ul_id != id_of(number)) return {creation_errc::not_an_answer};
    const auto status = static_cast<hilscher::od_status>(head.ul_sta);
    if (status != hilscher::od_status::ok) return {creation_errc::refused, status};
    return {number == 0 ? confirmed(bytes) : confirmed(object_.entries[number - 1], bytes)};
}

JAUSCAT_CONSTEXPR result<std::span<std::byte>, wire::errc>
object_creation::object_packet(std::span<std::byte> out) const noexcept {
    auto r = request<hilscher::od_create_object_request>(0, object_.name);
    r.b_max_num_of_sub_objs = object_.highest_subindex();
    r.b_object_code = hilscher::od_object_code::record;
    r.us_access_flags = {hilscher::od_object_flag::create_subindex_0};
    return put(r, out);
}

JAUSCAT_CONSTEXPR result<std::span<std::byte>, wire::errc>
object_creation::subobject_packet(std::size_t number, std::span<std::byte> out) const noexcept {
    using enum hilscher::od_access;
    const auto& entry = object_.entries[number - 1];
    auto r = request<hilscher::od_create_subobject_request>(number, entry.name);
    r.b_sub_index = entry.subindex;
    r.variable_size = !object_.exact_size;
    r.b_indication_flags.set(hilscher::od_indication::on_read, entry.readable);
    r.b_indication_flags.set(hilscher::od_indication::on_write, entry.writable);
    for (const auto right : {read_pre_op, read_safe_op, read_operational})
        r.us_access_rights.set(right, entry.readable);
    for (const auto right : {write_pre_op, write_safe_op, write_operational})
        r.us_access_rights.set(right, entry.writable);
    r.us_datatype = hilscher::od_data_type::octet_string;
    r.ul_max_field_units = entry.max_size;
    return put(r, out);
}

JAUSCAT_CONSTEXPR creation_errc object_creation::confirmed(std::span<const std::byte> bytes) const noexcept {
    hilscher::od_create_object_confirmation c{};
    if (!wire::decode_prefix(c, bytes)) return creation_errc::truncated;
    return c.us_index == object_.index ? creation_errc::ok : creation_errc::not_an_answer;
}

JAUSCAT_CONSTEXPR creation_errc object_creation::confirmed(const sub_object& entry,
                                                           std::span<const std::byte> bytes) const noexcept {
    hilscher::od_create_subobject_confirmation c{};
    if (!wire::decode_prefix(c, bytes)) return creation_errc::truncated;
    return c.us_index == object_.index && c.b_sub_index == entry.subindex ? creation_errc::ok
                                                                          : creation_errc::not_an_answer;
}

JAUSCAT_CONSTEXPR std::uint32_t object_creation::id_of(std::size_t number) const noexcept {
    return given_.ul_id + static_cast<std::uint32_t>(number);
}

} // namespace jauscat::bridging
