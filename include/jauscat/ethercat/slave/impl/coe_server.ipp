// The functions of coe_server.
#pragma once
#include <jauscat/ethercat/slave/coe_server.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION void coe_server::forget_transfer() noexcept {
    segments_ = segments::none;
    information_.forget();
}

JAUSCAT_FUNCTION void coe_server::power_on() noexcept {
    forget_transfer();
    objects_.power_on();
}

JAUSCAT_FUNCTION coe_answer coe_server::answer(std::span<const std::byte> message, std::span<std::byte> out) noexcept {
    coe_header coe{};
    const auto used = wire::decode_prefix(coe, message);
    if (!used) return {.error = mailbox_error_code::size_too_short};
    const auto sdo = message.subspan(*used);
    if (coe.service == coe_service::sdo_information && objects_.is_described()) return inform(sdo, out);
    if (coe.service != coe_service::sdo_request) return {.error = mailbox_error_code::service_not_supported};
    sdo_segment_header segment{};
    if (segments_ != segments::none && wire::decode_prefix(segment, sdo)) {
        if (segment.specifier == sdo_specifier::download_segment_request) return take_segment(segment, sdo, out);
        if (segment.specifier == sdo_specifier::upload_segment_request) return give_segment(segment, out);
    }
    sdo_normal request{};
    if (!wire::decode_prefix(request, sdo)) return {.error = mailbox_error_code::size_too_short};
    forget_transfer(); // the master has abandoned it, or begins another one
    const auto& header = request.header;
    object_ = {.index = header.index, .subindex = header.subindex, .complete = header.complete_access};
    if (header.specifier == sdo_specifier::abort) return {};
    if (header.specifier == sdo_specifier::download_request) return download(request, sdo, out);
    if (header.specifier == sdo_specifier::upload_request) return upload(out);
    return put_abort(out, abort_code::command_specifier);
}

JAUSCAT_FUNCTION coe_answer coe_server::next(std::span<std::byte> out) noexcept {
    const auto room = put_header(coe_service::sdo_information, out);
    return {.size = sdo_offset + information_.next(objects_, room)};
}

JAUSCAT_FUNCTION std::span<std::byte> coe_server::put_header(coe_service service, std::span<std::byte> out) noexcept {
    return out.subspan(wire::encode(coe_header{.service = service}, out)->size());
}

JAUSCAT_FUNCTION coe_answer coe_server::inform(std::span<const std::byte> question, std::span<std::byte> out) noexcept {
    forget_transfer();
    const auto size = information_.answer(objects_, question, put_header(coe_service::sdo_information, out));
    if (size == 0) return {.error = mailbox_error_code::size_too_short};
    return {.size = sdo_offset + size};
}

JAUSCAT_FUNCTION coe_answer coe_server::put_segment(std::span<std::byte> out, const sdo_segment_header& header,
                                                    std::span<const std::byte> data) noexcept {
    return {.size = sdo_offset + encode_segment(header, data, put_header(coe_service::sdo_response, out))};
}

JAUSCAT_FUNCTION sdo_header coe_server::response(sdo_specifier specifier) const noexcept {
    return {.complete_access = object_.complete && specifier != sdo_specifier::abort,
            .specifier = specifier,
            .index = object_.index,
            .subindex = object_.subindex};
}

JAUSCAT_FUNCTION coe_answer coe_server::put_abort(std::span<std::byte> out, abort_code code) noexcept {
    forget_transfer();
    // Slaves abort with the service of a request: the standard's own choice, and what masters expect.
    return put_sdo(out, coe_service::sdo_request, sdo_abort{response(sdo_specifier::abort), code});
}

JAUSCAT_FUNCTION coe_answer coe_server::upload(std::span<std::byte> out) noexcept {
    const auto refused = objects_.refusal(object_, false);
    if (refused != abort_code::none) return put_abort(out, refused);
    // Without memory the object is read to where the data of a normal response stand.
    const auto room = out.subspan(data_offset);
    const auto& memory = options_.transfer_memory;
    const auto place = memory.size() > room.size() ? memory : room;
    const auto [error, size] = objects_.read(object_, place);
    if (error != abort_code::none) return put_abort(out, error);
    if (size > place.size()) return put_abort(out, abort_code::exceeds_mailbox);
    auto header = response(sdo_specifier::upload_response);
    header.size_indicated = true;
    std::array<std::byte, 4> small{};
    if (size != 0 && size <= small.size()) {
        std::ranges::copy(place.first(size), small.begin());
        header.expedited = true;
        header.unused = static_cast<std::uint8_t>(small.size() - size);
        return put_sdo(out, coe_service::sdo_response, sdo_expedited{header, small});
    }
    begin(segments::upload, size);
    if (size <= room.size() || !options_.empty_start) done_ = std::min(size, room.size());
    if (done_ == size) forget_transfer();
    if (place.data() != room.data()) std::ranges::copy(place.first(done_), room.begin());
    put_sdo(out, coe_service::sdo_response, sdo_normal{header, static_cast<std::uint32_t>(size)});
    return {.size = data_offset + done_};
}

JAUSCAT_FUNCTION coe_answer coe_server::download(const sdo_normal& request, std::span<const std::byte> sdo,
                                                 std::span<std::byte> out) noexcept {
    const auto refused = objects_.refusal(object_, true);
    if (refused != abort_code::none) return put_abort(out, refused);
    const auto& header = request.header;
    if (header.expedited) {
        sdo_expedited expedited{};
        static_cast<void>(wire::decode_prefix(expedited, sdo));
        return store(std::span{expedited.data}.first(header.size_indicated ? 4u - header.unused : 4u), out);
    }
    const auto data = sdo.subspan(wire::max_size<sdo_normal>);
    if (request.size > data.size()) { // the rest follows, or all of it if this message had no data
        if (request.size > options_.transfer_memory.size()) return put_abort(out, abort_code::exceeds_mailbox);
        begin(segments::download, request.size);
        keep(data);
        return put_sdo(out, coe_service::sdo_response, sdo_normal{response(sdo_specifier::download_response), 0});
    }
    // Some masters leave the size bit clear: all received bytes are then data.
    if (header.size_indicated && request.size < data.size()) return put_abort(out, abort_code::length_mismatch);
    return store(data, out);
}

JAUSCAT_FUNCTION coe_answer coe_server::store(std::span<const std::byte> data, std::span<std::byte> out) noexcept {
    const auto error = objects_.write(object_, data);
    if (error != abort_code::none) return put_abort(out, error);
    return put_sdo(out, coe_service::sdo_response, sdo_normal{response(sdo_specifier::download_response), 0});
}

JAUSCAT_FUNCTION coe_answer coe_server::take_segment(const sdo_segment_header& segment, std::span<const std::byte> sdo,
                                                     std::span<std::byte> out) noexcept {
    if (segments_ != segments::download) return put_abort(out, abort_code::command_specifier);
    if (segment.toggle != toggle_) return put_abort(out, abort_code::toggle_bit);
    const auto data = segment_data(segment, sdo);
    if (data.size() > size_ - done_) return put_abort(out, abort_code::length_too_high);
    keep(data);
    if (segment.last) {
        if (done_ != size_) return put_abort(out, abort_code::length_too_low);
        forget_transfer();
        const auto error = objects_.write(object_, options_.transfer_memory.first(size_));
        if (error != abort_code::none) return put_abort(out, error);
    }
    const bool toggle = std::exchange(toggle_, !toggle_);
    return put_segment(out, {.toggle = toggle, .specifier = sdo_specifier::download_segment_response}, {});
}

JAUSCAT_FUNCTION coe_answer coe_server::give_segment(const sdo_segment_header& request,
                                                     std::span<std::byte> out) noexcept {
    if (segments_ != segments::upload) return put_abort(out, abort_code::command_specifier);
    if (request.toggle != toggle_) return put_abort(out, abort_code::toggle_bit);
    const std::size_t count = std::min(size_ - done_, out.size() - sdo_offset - segment_overhead);
    const auto data = options_.transfer_memory.subspan(done_, count);
    done_ += count;
    const bool last = done_ == size_;
    if (last) forget_transfer();
    const bool toggle = std::exchange(toggle_, !toggle_);
    return put_segment(out, {.last = last, .toggle = toggle, .specifier = sdo_specifier::upload_segment_response},
                       data);
}

JAUSCAT_FUNCTION void coe_server::begin(segments direction, std::size_t size) noexcept {
    segments_ = direction;
    size_ = size;
    done_ = 0;
    toggle_ = false;
}

JAUSCAT_FUNCTION void coe_server::keep(std::span<const std::byte> data) noexcept {
    std::ranges::copy(data, options_.transfer_memory.subspan(done_).begin());
    done_ += data.size();
}

} // namespace jauscat::ethercat
