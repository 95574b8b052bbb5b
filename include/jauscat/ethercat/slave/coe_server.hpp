// The CoE server of an emulated slave: one request in, one response or abort out. Objects larger than a message go in
// segments.
#pragma once

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
    void forget_transfer() noexcept {
        segments_ = segments::none;
        information_.forget();
    }
    /// As after power-on.
    void power_on() noexcept {
        forget_transfer();
        objects_.power_on();
    }
    /// Sets the AL state for state-dependent access rights; initially PRE-OP.
    void set_state(al_state state) noexcept { objects_.set_state(state); }

    /// Answers the CoE message `message` (CoE header on) with one in `out`, which has at least 18 bytes and does not
    /// overlap it.
    [[nodiscard]] coe_answer answer(std::span<const std::byte> message, std::span<std::byte> out) noexcept {
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

    /// The response has another fragment; see `next`.
    [[nodiscard]] bool has_more() const noexcept { return information_.has_more(); }
    [[nodiscard]] coe_answer next(std::span<std::byte> out) noexcept {
        const auto room = put_header(coe_service::sdo_information, out);
        return {.size = sdo_offset + information_.next(objects_, room)};
    }

  private:
    enum class segments : std::uint8_t { none, download, upload };

    static constexpr std::size_t sdo_offset = wire::max_size<coe_header>;
    static constexpr std::size_t data_offset = sdo_offset + wire::max_size<sdo_normal>;

    static std::span<std::byte> put_header(coe_service service, std::span<std::byte> out) noexcept {
        return out.subspan(wire::encode(coe_header{.service = service}, out)->size());
    }
    coe_answer inform(std::span<const std::byte> question, std::span<std::byte> out) noexcept {
        forget_transfer();
        const auto size = information_.answer(objects_, question, put_header(coe_service::sdo_information, out));
        if (size == 0) return {.error = mailbox_error_code::size_too_short};
        return {.size = sdo_offset + size};
    }

    /// CoE header and SDO message to the front of `out`.
    template <class T> static coe_answer put_sdo(std::span<std::byte> out, coe_service service, const T& sdo) noexcept {
        static_cast<void>(wire::encode(sdo, put_header(service, out)));
        return {.size = data_offset};
    }
    static coe_answer put_segment(std::span<std::byte> out, const sdo_segment_header& header,
                                  std::span<const std::byte> data) noexcept {
        return {.size = sdo_offset + encode_segment(header, data, put_header(coe_service::sdo_response, out))};
    }
    [[nodiscard]] sdo_header response(sdo_specifier specifier) const noexcept {
        return {.complete_access = object_.complete && specifier != sdo_specifier::abort,
                .specifier = specifier,
                .index = object_.index,
                .subindex = object_.subindex};
    }
    coe_answer put_abort(std::span<std::byte> out, abort_code code) noexcept {
        forget_transfer();
        // Slaves abort with the service of a request: the standard's own choice, and what masters expect.
        return put_sdo(out, coe_service::sdo_request, sdo_abort{response(sdo_specifier::abort), code});
    }

    coe_answer upload(std::span<std::byte> out) noexcept {
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

    coe_answer download(const sdo_normal& request, std::span<const std::byte> sdo, std::span<std::byte> out) noexcept {
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

    // All of a download in one message.
    coe_answer store(std::span<const std::byte> data, std::span<std::byte> out) noexcept {
        const auto error = objects_.write(object_, data);
        if (error != abort_code::none) return put_abort(out, error);
        return put_sdo(out, coe_service::sdo_response, sdo_normal{response(sdo_specifier::download_response), 0});
    }

    coe_answer take_segment(const sdo_segment_header& segment, std::span<const std::byte> sdo,
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

    coe_answer give_segment(const sdo_segment_header& request, std::span<std::byte> out) noexcept {
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

    void begin(segments direction, std::size_t size) noexcept {
        segments_ = direction;
        size_ = size;
        done_ = 0;
        toggle_ = false;
    }
    void keep(std::span<const std::byte> data) noexcept {
        std::ranges::copy(data, options_.transfer_memory.subspan(done_).begin());
        done_ += data.size();
    }

    slave_objects objects_;
    coe_options options_;
    sdo_information_server<slave_objects> information_{};

    transfer_object object_{}; // of the transfer
    segments segments_{};
    std::size_t size_{}, done_{}; // bytes of the transfer in segments: all, and those that have come or gone
    bool toggle_{};               // of the next segment
};

} // namespace jauscat::ethercat
