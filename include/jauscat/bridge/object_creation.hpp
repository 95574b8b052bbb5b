// The packets that create an object list in a Hilscher slave: the object, then its subobjects, one packet after the
// other. Each is sent when the one before it has been confirmed.
#pragma once
#include <jauscat/bridge/object_list.hpp>
#include <jauscat/ethercat/hilscher/od_status.hpp>
#include <jauscat/schema/ethercat/hilscher_od.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace jauscat::bridging {

/// Result of a creation packet, from its confirmation.
enum class creation_errc : std::uint8_t {
    ok,
    truncated,     ///< shorter than its own layout
    not_an_answer, ///< answers another packet: wait on
    refused,       ///< the slave did not create it: see ulSta
};

/// Result of a request to create an object.
struct creation_answer {
    creation_errc error{};
    hilscher::od_status status{}; ///< ulSta

    [[nodiscard]] constexpr explicit operator bool() const noexcept { return error == creation_errc::ok; }
};

[[nodiscard]] constexpr std::string_view describe(creation_errc error) noexcept {
    switch (error) {
    case creation_errc::ok: return "ok";
    case creation_errc::truncated: return "truncated: the confirmation is shorter than its layout";
    case creation_errc::not_an_answer: return "not an answer: the packet confirms something else";
    case creation_errc::refused: return "refused: the slave did not create the object, see the status";
    }
    return "unknown error";
}

/// Makes the packets of one object. These are ODV3's, of the slave stack V4: the layout of the V2/V3 stack's
/// ECAT_OD_CREATE_OBJECT_REQ_T of 2011 is not publicly documented.
///
/// The object is a record whose subindex 0 the stack makes. Its subobjects are octet strings, open to SDOs from PRE-OP
/// on, of variable size unless the table has fixed_length; the stack tells the application of every access.
class object_creation {
  public:
    /// `given` is what the caller's packets have in common: ulDest (0x20: the channel in use), ulSrc, ulSrcId, and the
    /// ulId of the first packet, from which the others count up. `object` must outlive this.
    constexpr explicit object_creation(const object_description& object,
                                       const hilscher::packet_header& given = {.ul_dest = 0x20}) noexcept
        : object_{object}, given_{given} {}

    /// Number of packets: one for the object and one for each subobject.
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 1 + object_.entries.size(); }

    /// Writes packet `number`, counted from 0, to the front of `out` and returns it. Error: no_space.
    [[nodiscard]] constexpr result<std::span<std::byte>, wire::errc> packet(std::size_t number,
                                                                            std::span<std::byte> out) const noexcept {
        return number == 0 ? object_packet(out) : subobject_packet(number, out);
    }

    /// Evaluates the confirmation `bytes` of packet `number`.
    [[nodiscard]] constexpr creation_answer answer(std::size_t number,
                                                   std::span<const std::byte> bytes) const noexcept {
        using hilscher::packet_command;
        const auto command =
            number == 0 ? packet_command::od_create_object_cnf : packet_command::od_create_subobject_cnf;
        hilscher::packet_header head{};
        if (!wire::decode_prefix(head, bytes)) return {creation_errc::truncated};
        if (head.ul_cmd != command || head.ul_id != id_of(number)) return {creation_errc::not_an_answer};
        const auto status = static_cast<hilscher::od_status>(head.ul_sta);
        if (status != hilscher::od_status::ok) return {creation_errc::refused, status};
        return {number == 0 ? confirmed(bytes) : confirmed(object_.entries[number - 1], bytes)};
    }

  private:
    template <class Request> constexpr Request request(std::size_t number, std::string_view name) const noexcept {
        Request r{};
        const auto command = r.head.ul_cmd;
        r.head = given_;
        r.head.ul_cmd = command;
        r.head.ul_id = id_of(number);
        r.us_index = object_.index;
        r.has_name = true;
        r.name = name;
        return r;
    }
    // The sizes that a packet states are those of its parts, known once it is complete.
    template <class Request>
    static constexpr result<std::span<std::byte>, wire::errc> put(Request& r, std::span<std::byte> out) noexcept {
        constexpr std::size_t body_of_header = wire::max_size<hilscher::packet_header>;
        const std::size_t size = wire::encoded_size(r);
        r.ul_total_data_bytes = static_cast<std::uint32_t>(size - wire::min_size<Request>);
        r.head.ul_len = static_cast<std::uint32_t>(size - body_of_header);
        return wire::encode(r, out);
    }

    constexpr result<std::span<std::byte>, wire::errc> object_packet(std::span<std::byte> out) const noexcept {
        auto r = request<hilscher::od_create_object_request>(0, object_.name);
        r.b_max_num_of_sub_objs = object_.highest_subindex();
        r.b_object_code = hilscher::od_object_code::record;
        r.us_access_flags = {hilscher::od_object_flag::create_subindex_0};
        return put(r, out);
    }
    constexpr result<std::span<std::byte>, wire::errc> subobject_packet(std::size_t number,
                                                                        std::span<std::byte> out) const noexcept {
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

    [[nodiscard]] constexpr creation_errc confirmed(std::span<const std::byte> bytes) const noexcept {
        hilscher::od_create_object_confirmation c{};
        if (!wire::decode_prefix(c, bytes)) return creation_errc::truncated;
        return c.us_index == object_.index ? creation_errc::ok : creation_errc::not_an_answer;
    }
    [[nodiscard]] constexpr creation_errc confirmed(const sub_object& entry,
                                                    std::span<const std::byte> bytes) const noexcept {
        hilscher::od_create_subobject_confirmation c{};
        if (!wire::decode_prefix(c, bytes)) return creation_errc::truncated;
        return c.us_index == object_.index && c.b_sub_index == entry.subindex ? creation_errc::ok
                                                                              : creation_errc::not_an_answer;
    }
    [[nodiscard]] constexpr std::uint32_t id_of(std::size_t number) const noexcept {
        return given_.ul_id + static_cast<std::uint32_t>(number);
    }

    object_description object_;
    hilscher::packet_header given_;
};

} // namespace jauscat::bridging
