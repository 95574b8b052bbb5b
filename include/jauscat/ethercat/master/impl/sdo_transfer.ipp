// The functions of sdo_transfer.
#pragma once
#include <jauscat/ethercat/master/sdo_transfer.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION sdo_transfer sdo_transfer::download(std::uint16_t index, std::uint8_t subindex,
                                                     std::span<const std::byte> data,
                                                     const download_options& options) noexcept {
    sdo_transfer transfer{sdo_specifier::download_request, index, subindex};
    transfer.data_ = data;
    transfer.empty_start_ = options.empty_start;
    transfer.complete_access_ = options.complete_access;
    if (options.clear_subindex_0 && subindex != 0) transfer.phase_ = phase::clear;
    return transfer;
}

JAUSCAT_FUNCTION sdo_transfer sdo_transfer::upload(std::uint16_t index, std::uint8_t subindex,
                                                   std::span<std::byte> into, const upload_options& options) noexcept {
    sdo_transfer transfer{sdo_specifier::upload_request, index, subindex};
    transfer.into_ = into;
    transfer.complete_access_ = options.complete_access;
    transfer.expected_size_ = options.size;
    return transfer;
}

JAUSCAT_FUNCTION sdo_transfer sdo_transfer::abort(const sdo_abort& message) noexcept {
    sdo_transfer transfer{sdo_specifier::abort, message.header.index, message.header.subindex};
    transfer.code_ = message.code;
    return transfer;
}

JAUSCAT_FUNCTION bool sdo_transfer::is_open() const noexcept {
    const bool may_be_open = is_download() ? initial_data().size() < data_.size() : expects_answer();
    return open_ || (phase_ == phase::initiate && !finished_ && may_be_open);
}

JAUSCAT_FUNCTION sdo_abort sdo_transfer::abort_message() const noexcept {
    const auto code = result_.error().code == master_errc::toggle_bit      ? abort_code::toggle_bit
                      : result_.error().code == master_errc::size_mismatch ? abort_code::length_mismatch
                      : result_.error().code == master_errc::data_too_long ? abort_code::out_of_memory
                                                                           : abort_code::timeout;
    return {{.specifier = sdo_specifier::abort, .index = index_, .subindex = subindex_}, code};
}

JAUSCAT_FUNCTION std::size_t sdo_transfer::size() const noexcept {
    if (phase_ == phase::segments) return wire::max_size<coe_header> + segment_size(next_segment().size());
    return initiate_overhead + (is_expedited() ? 0 : initial_data().size());
}

JAUSCAT_FUNCTION void sdo_transfer::encode(std::span<std::byte> out) const noexcept {
    out = out.subspan(wire::encode(coe_header{.service = coe_service::sdo_request}, out)->size());
    const auto data = initial_data();
    sdo_header header{.specifier = request_, .index = index_, .subindex = subindex()};
    header.size_indicated = is_download();
    header.complete_access = complete_access_ && phase_ == phase::initiate;
    if (phase_ == phase::segments) {
        static_cast<void>(encode_segment(segment_header(), next_segment(), out));
    } else if (!expects_answer()) {
        static_cast<void>(wire::encode(sdo_abort{header, code_}, out));
    } else if (is_expedited()) {
        sdo_expedited sdo{.header = header};
        sdo.header.expedited = true;
        sdo.header.unused = static_cast<std::uint8_t>(sdo.data.size() - data.size());
        std::ranges::copy(data, sdo.data.begin());
        static_cast<void>(wire::encode(sdo, out));
    } else {
        const auto used = wire::encode(sdo_normal{header, static_cast<std::uint32_t>(data_.size())}, out);
        std::ranges::copy(data, out.subspan(used->size()).begin());
    }
}

JAUSCAT_FUNCTION reply_kind sdo_transfer::take(std::span<const std::byte> message) noexcept {
    coe_header coe{};
    const auto sdo = message.subspan(*wire::decode_prefix(coe, message));
    sdo_segment_header segment{}; // its specifier is where the one of any SDO message is
    const bool is_sdo = coe.service == coe_service::sdo_response || coe.service == coe_service::sdo_request;
    if (!expects_answer() || !is_sdo || !wire::decode_prefix(segment, sdo)) return reply_kind::unrelated;
    const bool is_response = coe.service == coe_service::sdo_response && segment.specifier == expected_response();
    if (phase_ == phase::segments && is_response) return take_segment(segment, sdo);

    sdo_header header{};
    const bool names_object = static_cast<bool>(wire::decode_prefix(header, sdo));
    const bool is_ours = header.index == index_ && (header.subindex == subindex() || complete_access_);
    sdo_abort abort{};
    const bool is_whole = static_cast<bool>(wire::decode_prefix(abort, sdo));
    // Slaves abort with the service of a request or of a response, and leave other bits of the command as they are.
    if (segment.specifier == sdo_specifier::abort) {
        // In an answer to a segment, where requests name no object, some slaves' aborts do not name it either.
        if (names_object && !is_ours && phase_ != phase::segments) return reply_kind::unrelated;
        return aborted(is_whole ? abort.code : abort_code::none);
    }
    if (!is_whole || !is_ours) return reply_kind::unrelated;
    if (is_response) return is_download() ? go_on(phase_ == phase::clear) : take_upload(header, sdo);
    unexpected_ = header.specifier;
    return reply_kind::unrelated;
}

JAUSCAT_FUNCTION std::span<const std::byte> sdo_transfer::initial_data() const noexcept {
    if (phase_ == phase::clear) return zero;
    const std::size_t fits = room_ - initiate_overhead;
    if (data_.size() <= fits) return data_;
    return data_.first(empty_start_ ? 0 : fits);
}

JAUSCAT_FUNCTION bool sdo_transfer::is_expedited() const noexcept {
    const auto data = initial_data();
    return is_download() && !data.empty() && data.size() <= wire::max_size<sdo_expedited> - wire::max_size<sdo_header>;
}

JAUSCAT_FUNCTION std::span<const std::byte> sdo_transfer::next_segment() const noexcept {
    const auto left = data_.subspan(std::min(done_, data_.size()));
    return left.first(std::min(left.size(), room_ - wire::max_size<coe_header> - segment_overhead));
}

JAUSCAT_FUNCTION sdo_segment_header sdo_transfer::segment_header() const noexcept {
    if (!is_download()) return {.toggle = toggle_, .specifier = sdo_specifier::upload_segment_request};
    return {.last = done_ + next_segment().size() == data_.size(),
            .toggle = toggle_,
            .specifier = sdo_specifier::download_segment_request};
}

JAUSCAT_FUNCTION sdo_specifier sdo_transfer::expected_response() const noexcept {
    if (phase_ == phase::segments)
        return is_download() ? sdo_specifier::download_segment_response : sdo_specifier::upload_segment_response;
    return is_download() ? sdo_specifier::download_response : sdo_specifier::upload_response;
}

JAUSCAT_FUNCTION reply_kind sdo_transfer::finish(const master_result<std::size_t>& result) noexcept {
    result_ = result;
    finished_ = true;
    return reply_kind::complete;
}

JAUSCAT_FUNCTION reply_kind sdo_transfer::aborted(abort_code code) noexcept {
    open_ = false;
    if (!spoilt_) return finish(spoilt_.error());
    const auto error = phase_ == phase::clear ? master_errc::clear_refused : master_errc::sdo_abort;
    return finish(master_error{.code = error, .abort = code});
}

JAUSCAT_FUNCTION reply_kind sdo_transfer::next_request(phase next) noexcept {
    phase_ = next;
    unexpected_.reset();
    return reply_kind::proceed;
}

JAUSCAT_FUNCTION reply_kind sdo_transfer::go_on(bool cleared) noexcept {
    if (cleared) return next_request(phase::initiate);
    done_ += phase_ == phase::segments ? next_segment().size() : initial_data().size();
    open_ = done_ != data_.size();
    return open_ ? next_request(phase::segments) : finish(std::size_t{0});
}

JAUSCAT_FUNCTION reply_kind sdo_transfer::take_upload(const sdo_header& header,
                                                      std::span<const std::byte> sdo) noexcept {
    if (header.expedited) {
        sdo_expedited expedited{};
        static_cast<void>(wire::decode_prefix(expedited, sdo));
        const std::size_t unused = header.size_indicated ? header.unused : 0u;
        return keep(std::span{expedited.data}.first(expedited.data.size() - unused), false);
    }
    sdo_normal normal{};
    auto data = sdo.subspan(*wire::decode_prefix(normal, sdo));
    announced_ = normal.size;
    // The mailbox length of some slaves covers bytes that fill up the message.
    if (normal.size < data.size() && header.size_indicated) data = data.first(normal.size);
    return keep(data, normal.size > data.size());
}

JAUSCAT_FUNCTION reply_kind sdo_transfer::take_segment(const sdo_segment_header& segment,
                                                       std::span<const std::byte> sdo) noexcept {
    if (segment.toggle != toggle_) return finish(master_error{.code = master_errc::toggle_bit});
    toggle_ = !toggle_;
    if (is_download()) return go_on(false);
    const auto data = segment_data(segment, sdo);
    open_ = !segment.last;
    const std::size_t left = announced_ - done_;
    // Empty segments are refused: a transfer of them would not end.
    if (data.size() > left || (segment.last ? data.size() != left : data.empty())) return mismatch(data.size());
    return keep(data, !segment.last);
}

JAUSCAT_FUNCTION reply_kind sdo_transfer::mismatch(std::size_t last) noexcept {
    return finish(master_error{.code = master_errc::size_mismatch,
                               .bytes = announced_,
                               .found_bytes = static_cast<std::uint32_t>(done_ + last)});
}

JAUSCAT_FUNCTION reply_kind sdo_transfer::keep(std::span<const std::byte> data, bool more) noexcept {
    open_ = more;
    const std::size_t size = std::max<std::size_t>(more ? announced_ : 0, done_ + data.size());
    if (size > into_.size())
        spoilt_ = master_error{.code = master_errc::data_too_long,
                               .bytes = static_cast<std::uint32_t>(into_.size()),
                               .found_bytes = static_cast<std::uint32_t>(size)};
    else if (expected_size_ && size != *expected_size_)
        spoilt_ = master_error{.code = master_errc::size_mismatch,
                               .bytes = static_cast<std::uint32_t>(*expected_size_),
                               .found_bytes = static_cast<std::uint32_t>(size)};
    if (spoilt_) std::ranges::copy(data, into_.subspan(done_).begin());
    done_ += data.size();
    if (more && (spoilt_ || size <= longest_unused)) return next_request(phase::segments);
    if (!spoilt_) return finish(spoilt_.error());
    return finish(done_);
}

} // namespace jauscat::ethercat
