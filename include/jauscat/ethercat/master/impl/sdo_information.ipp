// The functions of sdo_information.
#pragma once
#include <jauscat/ethercat/master/sdo_information.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION sdo_information sdo_information::list(object_list_type type, std::span<std::byte> into) noexcept {
    sdo_information question{sdo_information_opcode::list_request, into};
    question.put(object_list{type});
    question.repeated_ = wire::max_size<object_list>;
    return question;
}

JAUSCAT_FUNCTION sdo_information sdo_information::object(std::uint16_t index, std::span<std::byte> into) noexcept {
    sdo_information question{sdo_information_opcode::object_request, into};
    question.put(object_query{index});
    return question;
}

JAUSCAT_FUNCTION sdo_information sdo_information::entry(const entry_query& entry, std::span<std::byte> into) noexcept {
    sdo_information question{sdo_information_opcode::entry_request, into};
    question.put(entry);
    return question;
}

JAUSCAT_FUNCTION std::size_t sdo_information::size() const noexcept {
    return wire::max_size<coe_header> + wire::max_size<sdo_information_header> + size_;
}

JAUSCAT_FUNCTION void sdo_information::encode(std::span<std::byte> out) const noexcept {
    out = out.subspan(wire::encode(coe_header{.service = coe_service::sdo_information}, out)->size());
    out = out.subspan(wire::encode(sdo_information_header{.opcode = request_}, out)->size());
    std::ranges::copy(std::span{question_}.first(size_), out.begin());
}

JAUSCAT_FUNCTION reply_kind sdo_information::take(std::span<const std::byte> message) noexcept {
    coe_header coe{};
    message = message.subspan(*wire::decode_prefix(coe, message));
    sdo_information_header header{};
    const auto used = wire::decode_prefix(header, message);
    if (coe.service != coe_service::sdo_information || !used) return reply_kind::unrelated;
    message = message.subspan(*used);
    if (header.opcode == sdo_information_opcode::error) return refused(message);
    const auto answer = static_cast<sdo_information_opcode>(static_cast<unsigned>(request_) + 1);
    if (header.opcode != answer) return reply_kind::unrelated;
    if (!begun_) {
        // What the question named comes first, and says that this is its answer. A list does not repeat it.
        const auto asked = std::span{question_}.first(std::min<std::size_t>(size_, name_size));
        if (message.size() < asked.size() || !std::ranges::equal(asked, message.first(asked.size())))
            return reply_kind::unrelated;
        message = message.subspan(repeated_);
    }
    if (message.size() > into_.size() - done_)
        return finish(
            master_error{.code = master_errc::data_too_long, .bytes = static_cast<std::uint32_t>(into_.size())});
    if (header.fragments_left > most_fragments())
        return finish(master_error{.code = master_errc::too_many_fragments, .fragments = header.fragments_left});
    if (begun_ && header.fragments_left + 1u != left_)
        return finish(master_error{.code = master_errc::fragment_missing, .fragments = left_ - 1u});
    begun_ = true;
    left_ = header.fragments_left;
    std::ranges::copy(message, into_.subspan(done_).begin());
    done_ += message.size();
    if (left_ != 0 || header.incomplete) return reply_kind::fragment;
    return finish(done_);
}

JAUSCAT_FUNCTION reply_kind sdo_information::refused(std::span<const std::byte> message) noexcept {
    sdo_information_error error{};
    static_cast<void>(wire::decode_prefix(error, message));
    return finish(master_error{.code = master_errc::sdo_abort, .abort = error.code});
}

JAUSCAT_FUNCTION reply_kind sdo_information::finish(const master_result<std::size_t>& result) noexcept {
    result_ = result;
    return reply_kind::complete;
}

} // namespace jauscat::ethercat
