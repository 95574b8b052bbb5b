// The packets that create an object list in a Hilscher slave: the object, then its subobjects, one packet after the
// other. Each is sent when the one before it has been confirmed.
#pragma once
#include <jauscat/base/compilation.hpp>
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

[[nodiscard]] JAUSCAT_CONSTEXPR std::string_view describe(creation_errc error) noexcept;

/// Makes the packets of one object. These are ODV3's, of the slave stack V4: the layout of the V2/V3 stack's
/// ECAT_OD_CREATE_OBJECT_REQ_T of 2011 is not publicly documented.
///
/// The object is a record whose subindex 0 the stack makes. Its subobjects are octet strings, open to SDOs from PRE-OP
/// on, of variable size unless the table has fixed_length; the stack tells the application of every access.
class object_creation {
  public:
    /// `given` is what the caller's packets have in common: ulDest (0x20: the channel in use), ulSrc, ulSrcId, and the
    /// ulId of the first packet, from which the others count up. `object` must outlive this.
    JAUSCAT_CONSTEXPR explicit object_creation(const object_description& object,
                                               const hilscher::packet_header& given = {.ul_dest = 0x20}) noexcept;

    /// Number of packets: one for the object and one for each subobject.
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 1 + object_.entries.size(); }

    /// Writes packet `number`, counted from 0, to the front of `out` and returns it. Error: no_space.
    [[nodiscard]] JAUSCAT_CONSTEXPR result<std::span<std::byte>, wire::errc>
    packet(std::size_t number, std::span<std::byte> out) const noexcept;

    /// Evaluates the confirmation `bytes` of packet `number`.
    [[nodiscard]] JAUSCAT_CONSTEXPR creation_answer answer(std::size_t number,
                                                           std::span<const std::byte> bytes) const noexcept;

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

    JAUSCAT_CONSTEXPR result<std::span<std::byte>, wire::errc> object_packet(std::span<std::byte> out) const noexcept;
    JAUSCAT_CONSTEXPR result<std::span<std::byte>, wire::errc>
    subobject_packet(std::size_t number, std::span<std::byte> out) const noexcept;

    [[nodiscard]] JAUSCAT_CONSTEXPR creation_errc confirmed(std::span<const std::byte> bytes) const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR creation_errc confirmed(const sub_object& entry,
                                                            std::span<const std::byte> bytes) const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR std::uint32_t id_of(std::size_t number) const noexcept;

    object_description object_;
    hilscher::packet_header given_;
};

} // namespace jauscat::bridging

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/bridge/impl/object_creation.ipp>
#endif
