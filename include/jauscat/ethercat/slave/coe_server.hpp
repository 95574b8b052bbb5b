// The CoE server of an emulated slave: one request in, one response or abort out. Objects larger than a message go in
// segments.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/sdo_segment.hpp>
#include <jauscat/ethercat/slave/coe_options.hpp>
#include <jauscat/ethercat/slave/object_dictionary.hpp>
#include <jauscat/ethercat/slave/sdo_information_server.hpp>
#include <jauscat/ethercat/slave/slave_objects.hpp>
#include <jauscat/schema/ethercat/mailbox.hpp>

#include <array>
#include <utility>

namespace jauscat::ethercat {

/// Result of a CoE message: size of the response, or a mailbox error.
struct coe_answer {
    mailbox_error_code error{};
    std::size_t size{};
};

/// Answers CoE messages. An object is written when all of it has come, and read before the first byte goes.
class coe_server {
  public:
    /// `objects` must outlive this object.
    explicit coe_server(object_dictionary objects, const coe_options& options = {}) noexcept
        : objects_{objects, options}, options_{options} {}

    /// Drops a running transfer.
    JAUSCAT_FUNCTION void forget_transfer() noexcept;
    /// As after power-on.
    JAUSCAT_FUNCTION void power_on() noexcept;
    /// Sets the AL state for state-dependent access rights; initially PRE-OP.
    void set_state(al_state state) noexcept { objects_.set_state(state); }

    /// Answers the CoE message `message` (CoE header on) with one in `out`, which has at least 18 bytes and does not
    /// overlap it.
    [[nodiscard]] JAUSCAT_FUNCTION coe_answer answer(std::span<const std::byte> message,
                                                     std::span<std::byte> out) noexcept;

    /// The response has another fragment; see `next`.
    [[nodiscard]] bool has_more() const noexcept { return information_.has_more(); }
    [[nodiscard]] JAUSCAT_FUNCTION coe_answer next(std::span<std::byte> out) noexcept;

  private:
    enum class segments : std::uint8_t { none, download, upload };

    static constexpr std::size_t sdo_offset = wire::max_size<coe_header>;
    static constexpr std::size_t data_offset = sdo_offset + wire::max_size<sdo_normal>;

    JAUSCAT_FUNCTION static std::span<std::byte> put_header(coe_service service, std::span<std::byte> out) noexcept;
    JAUSCAT_FUNCTION coe_answer inform(std::span<const std::byte> question, std::span<std::byte> out) noexcept;

    /// CoE header and SDO message to the front of `out`.
    template <class T> static coe_answer put_sdo(std::span<std::byte> out, coe_service service, const T& sdo) noexcept {
        static_cast<void>(wire::encode(sdo, put_header(service, out)));
        return {.size = data_offset};
    }
    JAUSCAT_FUNCTION static coe_answer put_segment(std::span<std::byte> out, const sdo_segment_header& header,
                                                   std::span<const std::byte> data) noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION sdo_header response(sdo_specifier specifier) const noexcept;
    JAUSCAT_FUNCTION coe_answer put_abort(std::span<std::byte> out, abort_code code) noexcept;

    JAUSCAT_FUNCTION coe_answer upload(std::span<std::byte> out) noexcept;

    JAUSCAT_FUNCTION coe_answer download(const sdo_normal& request, std::span<const std::byte> sdo,
                                         std::span<std::byte> out) noexcept;

    // All of a download in one message.
    JAUSCAT_FUNCTION coe_answer store(std::span<const std::byte> data, std::span<std::byte> out) noexcept;

    JAUSCAT_FUNCTION coe_answer take_segment(const sdo_segment_header& segment, std::span<const std::byte> sdo,
                                             std::span<std::byte> out) noexcept;

    JAUSCAT_FUNCTION coe_answer give_segment(const sdo_segment_header& request, std::span<std::byte> out) noexcept;

    JAUSCAT_FUNCTION void begin(segments direction, std::size_t size) noexcept;
    JAUSCAT_FUNCTION void keep(std::span<const std::byte> data) noexcept;

    slave_objects objects_;
    coe_options options_;
    sdo_information_server<slave_objects> information_{};

    transfer_object object_{}; // of the transfer
    segments segments_{};
    std::size_t size_{}, done_{}; // bytes of the transfer in segments: all, and those that have come or gone
    bool toggle_{};               // of the next segment
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/slave/impl/coe_server.ipp>
#endif
