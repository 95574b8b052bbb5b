// SDO information, master side: object list, object description, entry description. The response may have several
// fragments; mailbox_exchange handles the mailbox.
#pragma once

#include <jauscat/ethercat/master/reply_kind.hpp>
#include <jauscat/schema/ethercat/coe.hpp>
#include <jauscat/schema/ethercat/sdo_information.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::ethercat {

/// One request and the fragments of its response, whose data are put together in a buffer of the caller's.
class sdo_information {
  public:
    sdo_information() noexcept = default;

    /// The indices of the objects in a list, 2 bytes each.
    static sdo_information list(object_list_type type, std::span<std::byte> into) noexcept {
        sdo_information question{sdo_information_opcode::list_request, into};
        question.put(object_list{type});
        question.repeated_ = wire::max_size<object_list>;
        return question;
    }
    /// An object's object_answer and name.
    static sdo_information object(std::uint16_t index, std::span<std::byte> into) noexcept {
        sdo_information question{sdo_information_opcode::object_request, into};
        question.put(object_query{index});
        return question;
    }
    /// An entry's entry_answer, values and name.
    static sdo_information entry(const entry_query& entry, std::span<std::byte> into) noexcept {
        sdo_information question{sdo_information_opcode::entry_request, into};
        question.put(entry);
        return question;
    }

    /// Bytes received.
    [[nodiscard]] const master_result<std::size_t>& result() const noexcept { return result_; }
    [[nodiscard]] static constexpr bool expects_answer() noexcept { return true; }
    /// Nothing here is kept track of: other answers are passed over.
    [[nodiscard]] static constexpr std::optional<sdo_specifier> unexpected() noexcept { return {}; }
    /// Bytes that `encode` writes.
    [[nodiscard]] std::size_t size() const noexcept {
        return wire::max_size<coe_header> + wire::max_size<sdo_information_header> + size_;
    }
    /// Writes the request, CoE header on, to the front of `out`, which holds at least `size()` bytes.
    void encode(std::span<std::byte> out) const noexcept {
        out = out.subspan(wire::encode(coe_header{.service = coe_service::sdo_information}, out)->size());
        out = out.subspan(wire::encode(sdo_information_header{.opcode = request_}, out)->size());
        std::ranges::copy(std::span{question_}.first(size_), out.begin());
    }

    /// Takes a CoE message, CoE header on.
    reply_kind take(std::span<const std::byte> message) noexcept {
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
        if (begun_ && header.fragments_left + 1u != left_)
            return finish(master_error{.code = master_errc::fragment_missing, .fragments = left_ - 1u});
        begun_ = true;
        left_ = header.fragments_left;
        std::ranges::copy(message, into_.subspan(done_).begin());
        done_ += message.size();
        if (left_ != 0 || header.incomplete) return reply_kind::fragment;
        return finish(done_);
    }

  private:
    static constexpr std::size_t name_size = 3; // index and subindex

    sdo_information(sdo_information_opcode request, std::span<std::byte> into) noexcept
        : request_{request}, into_{into} {}

    template <wire::message T> void put(const T& question) noexcept {
        size_ = wire::encode(question, question_)->size();
    }

    reply_kind refused(std::span<const std::byte> message) noexcept {
        sdo_information_error error{};
        static_cast<void>(wire::decode_prefix(error, message));
        return finish(master_error{.code = master_errc::sdo_abort, .abort = error.code});
    }
    reply_kind finish(const master_result<std::size_t>& result) noexcept {
        result_ = result;
        return reply_kind::complete;
    }

    sdo_information_opcode request_{};
    std::array<std::byte, wire::max_size<entry_query>> question_{};
    std::size_t size_{};     // of the question
    std::size_t repeated_{}; // bytes of the question that the first fragment repeats and the caller does not want
    std::span<std::byte> into_{};
    std::size_t done_{};   // bytes that have come
    std::uint32_t left_{}; // fragments
    bool begun_{};
    master_result<std::size_t> result_{std::size_t{0}};
};

} // namespace jauscat::ethercat
