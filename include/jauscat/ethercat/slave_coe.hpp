// The SDO server of an emulated slave: one request in, one response or abort out.
#pragma once

#include <jauscat/ethercat/object_dictionary.hpp>
#include <jauscat/schema/ethercat/coe.hpp>
#include <jauscat/schema/ethercat/mailbox.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace jauscat::ethercat {

/// What became of a CoE message: the size of the response, or the mailbox error that answers it.
struct coe_answer {
    mailbox_error_code error{};
    std::size_t size{};
};

namespace detail {

inline constexpr std::size_t sdo_offset = wire::max_size<coe_header>;
inline constexpr std::size_t sdo_data_offset = sdo_offset + wire::max_size<sdo_normal>;

/// CoE header and SDO message to the front of `out`, which a mailbox of at least 24 bytes makes large enough.
template <class T> coe_answer put_sdo(std::span<std::byte> out, coe_service service, const T& sdo) noexcept {
    static_cast<void>(wire::encode(coe_header{.service = service}, out));
    static_cast<void>(wire::encode(sdo, out.subspan(sdo_offset)));
    return {.size = sdo_data_offset};
}

inline coe_answer put_abort(std::span<std::byte> out, const sdo_header& request, abort_code code) noexcept {
    const sdo_header header{.specifier = sdo_specifier::abort, .index = request.index, .subindex = request.subindex};
    // Slaves abort with the service of a request: the standard's own choice, and what masters expect.
    return put_sdo(out, coe_service::sdo_request, sdo_abort{header, code});
}

inline coe_answer answer_upload(object_dictionary& objects, const sdo_header& request,
                                std::span<std::byte> out) noexcept {
    // Read to where the data of a normal response stand; the few bytes of an expedited one then move forward.
    const auto data = out.subspan(sdo_data_offset);
    const auto [error, size] = objects.read(request.index, request.subindex, data);
    if (error != abort_code::none) return put_abort(out, request, error);
    if (size > data.size()) return put_abort(out, request, abort_code::exceeds_mailbox);
    sdo_header header{.size_indicated = true,
                      .specifier = sdo_specifier::upload_response,
                      .index = request.index,
                      .subindex = request.subindex};
    std::array<std::byte, 4> small{};
    if (size == 0 || size > small.size()) {
        put_sdo(out, coe_service::sdo_response, sdo_normal{header, static_cast<std::uint32_t>(size)});
        return {.size = sdo_data_offset + size};
    }
    std::ranges::copy(data.first(size), small.begin());
    header.expedited = true;
    header.unused = static_cast<std::uint8_t>(small.size() - size);
    return put_sdo(out, coe_service::sdo_response, sdo_expedited{header, small});
}

inline coe_answer answer_download(object_dictionary& objects, const sdo_header& request, std::span<const std::byte> sdo,
                                  std::span<std::byte> out) noexcept {
    std::span<const std::byte> data;
    sdo_expedited expedited{};
    if (request.expedited) {
        static_cast<void>(wire::decode_prefix(expedited, sdo));
        data = std::span{expedited.data}.first(request.size_indicated ? 4u - request.unused : 4u);
    } else {
        sdo_normal normal{};
        data = sdo.subspan(wire::decode_prefix(normal, sdo).size());
        // Some masters leave the size bit clear: what came is then all there is.
        if (request.size_indicated && normal.size > data.size())
            return put_abort(out, request, abort_code::exceeds_mailbox);
        if (request.size_indicated && normal.size < data.size())
            return put_abort(out, request, abort_code::length_mismatch);
    }
    const auto error = objects.write(request.index, request.subindex, data);
    if (error != abort_code::none) return put_abort(out, request, error);
    const sdo_header header{
        .specifier = sdo_specifier::download_response, .index = request.index, .subindex = request.subindex};
    return put_sdo(out, coe_service::sdo_response, sdo_normal{header, 0});
}

} // namespace detail

/// Answers the CoE message `message` (CoE header on) with one in `out`, which has at least 18 bytes and does not
/// overlap it. Objects that do not fit one mailbox message are aborted with `exceeds_mailbox`.
[[nodiscard]] inline coe_answer answer_coe(object_dictionary& objects, std::span<const std::byte> message,
                                           std::span<std::byte> out) noexcept {
    coe_header coe{};
    const auto used = wire::decode_prefix(coe, message);
    if (!used) return {.error = mailbox_error_code::size_too_short};
    if (coe.service != coe_service::sdo_request) return {.error = mailbox_error_code::service_not_supported};
    const auto sdo = message.subspan(used.size());
    sdo_normal request{};
    if (!wire::decode_prefix(request, sdo)) return {.error = mailbox_error_code::size_too_short};
    const auto& header = request.header;
    if (header.specifier == sdo_specifier::abort) return {}; // the master gave up; nothing is under way
    if (header.complete_access) return detail::put_abort(out, header, abort_code::complete_access);
    if (header.specifier == sdo_specifier::download_request) return detail::answer_download(objects, header, sdo, out);
    if (header.specifier == sdo_specifier::upload_request) return detail::answer_upload(objects, header, out);
    return detail::put_abort(out, header, abort_code::command_specifier);
}

} // namespace jauscat::ethercat
