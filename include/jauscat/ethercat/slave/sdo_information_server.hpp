// SDO information, slave side: object list, object description, entry description. Responses larger than the mailbox
// are sent in fragments.
#pragma once

#include <jauscat/ethercat/slave/object_dictionary.hpp>
#include <jauscat/schema/ethercat/sdo_information.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace jauscat::ethercat {

/// Answers the part of messages that follows the CoE header. `Objects` models described_object_source.
template <class Objects> class sdo_information_server {
  public:
    static constexpr std::size_t max_name = 64; ///< characters of a name that are sent

    /// The fragments that are still to come, if any, are forgotten.
    void forget() noexcept { left_ = 0; }
    /// Whether fragments of the answer are left.
    [[nodiscard]] bool has_more() const noexcept { return left_ != 0; }

    /// Writes the answer, or its first fragment, to the front of `out`, which has at least 16 bytes. Returns its size;
    /// 0 for a request that is too short.
    [[nodiscard]] std::size_t answer(const Objects& objects, std::span<const std::byte> message,
                                     std::span<std::byte> out) noexcept {
        forget();
        sdo_information_header request{};
        const auto used = wire::decode_prefix(request, message);
        if (!used) return 0;
        const auto body = message.subspan(*used);
        const auto with = [&](auto question, auto&& f) -> std::size_t {
            return wire::decode_prefix(question, body) ? f(question) : 0;
        };
        switch (request.opcode) {
        case sdo_information_opcode::list_request:
            return with(object_list{}, [&](const object_list& asked) { return answer_list(objects, asked, out); });
        case sdo_information_opcode::object_request:
            return with(object_query{}, [&](const object_query& asked) { return answer_object(objects, asked, out); });
        case sdo_information_opcode::entry_request:
            return with(entry_query{}, [&](const entry_query& asked) { return answer_entry(objects, asked, out); });
        default: return refuse(abort_code::command_specifier, out);
        }
    }

    /// The next fragment. Only if `has_more`.
    [[nodiscard]] std::size_t next(const Objects& objects, std::span<std::byte> out) noexcept {
        --left_;
        const auto room = put_header({.opcode = opcode_, .incomplete = left_ != 0, .fragments_left = left_}, out);
        const auto size =
            opcode_ == sdo_information_opcode::list_response ? put_indices(objects, room) : put_text(room);
        return out.size() - room.size() + size;
    }

  private:
    static std::span<std::byte> put_header(const sdo_information_header& header, std::span<std::byte> out) noexcept {
        return out.subspan(wire::encode(header, out)->size());
    }
    static std::size_t refuse(abort_code code, std::span<std::byte> out) noexcept {
        const auto room = put_header({.opcode = sdo_information_opcode::error}, out);
        return out.size() - room.size() + wire::encode(sdo_information_error{code}, room)->size();
    }

    // The first of as many fragments as `size` bytes need, in units of `unit` bytes.
    std::size_t begin(const Objects& objects, sdo_information_opcode opcode, std::size_t size, std::size_t unit,
                      std::span<std::byte> out) noexcept {
        const auto room = (out.size() - wire::max_size<sdo_information_header>) / unit * unit;
        opcode_ = opcode;
        done_ = 0;
        left_ = static_cast<std::uint16_t>(std::max<std::size_t>((size + room - 1) / room, 1));
        return next(objects, out);
    }

    std::size_t answer_list(const Objects& objects, const object_list& asked, std::span<std::byte> out) noexcept {
        if (asked.type > object_list_type::settings) return refuse(abort_code::unsupported_access, out);
        list_ = asked.type;
        after_ = 0;
        const auto count = list_ == object_list_type::lengths ? list_count : count_of(objects, list_);
        return begin(objects, sdo_information_opcode::list_response, (1 + count) * 2, 2, out);
    }

    std::size_t answer_object(const Objects& objects, const object_query& asked, std::span<std::byte> out) noexcept {
        const auto found = objects.describe(asked.index);
        if (!found) return refuse(abort_code::no_object, out);
        size_ = wire::encode(object_answer{.index = asked.index,
                                           .data_type = found->data_type,
                                           .highest_subindex = found->highest_subindex,
                                           .code = found->code},
                             text_)
                    ->size();
        add_name(found->name);
        return begin(objects, sdo_information_opcode::object_response, size_, 1, out);
    }

    std::size_t answer_entry(const Objects& objects, const entry_query& asked, std::span<std::byte> out) noexcept {
        if (!objects.describe(asked.index)) return refuse(abort_code::no_object, out);
        const auto found = objects.describe(asked.index, asked.subindex);
        if (!found) return refuse(abort_code::no_subindex, out);
        constexpr std::uint8_t always_present = 0x07; // access, category and mapping: the access word has them
        size_ = wire::encode(entry_answer{.index = asked.index,
                                          .subindex = asked.subindex,
                                          .value_info = static_cast<std::uint8_t>(asked.value_info & always_present),
                                          .data_type = found->data_type,
                                          .bits = found->bits,
                                          .access = found->access},
                             text_)
                    ->size();
        add_name(found->name);
        return begin(objects, sdo_information_opcode::entry_response, size_, 1, out);
    }

    void add_name(std::string_view name) noexcept {
        for (const char c : name.substr(0, max_name)) text_[size_++] = static_cast<std::byte>(c);
    }
    std::size_t put_text(std::span<std::byte> room) noexcept {
        const auto count = std::min(room.size(), size_ - done_);
        std::ranges::copy(std::span{text_}.subspan(done_, count), room.begin());
        done_ += count;
        return count;
    }

    // A list is not stored: each fragment continues after the last index of the previous one.
    std::size_t put_indices(const Objects& objects, std::span<std::byte> room) noexcept {
        std::size_t size = 0;
        const auto put = [&](std::size_t number) {
            size += wire::encode(object_query{static_cast<std::uint16_t>(number)}, room.subspan(size))->size();
        };
        if (done_++ == 0) put(static_cast<std::size_t>(list_));
        if (list_ == object_list_type::lengths) {
            for (std::size_t type = 1; type <= list_count; ++type)
                put(count_of(objects, static_cast<object_list_type>(type)));
            return size;
        }
        while (room.size() - size >= 2) {
            after_ = next_of(objects, list_, after_);
            if (after_ == 0) break;
            put(after_);
        }
        return size;
    }

    static std::uint16_t next_of(const Objects& objects, object_list_type list, std::uint16_t after) noexcept {
        do after = objects.next_index(after);
        while (after != 0 && !is_in(objects, list, after));
        return after;
    }
    static std::size_t count_of(const Objects& objects, object_list_type list) noexcept {
        std::size_t count = 0;
        for (std::uint16_t at = next_of(objects, list, 0); at != 0; at = next_of(objects, list, at)) ++count;
        return count;
    }
    static bool is_in(const Objects& objects, object_list_type list, std::uint16_t index) noexcept {
        if (list == object_list_type::all) return true;
        const auto object = objects.describe(index);
        for (unsigned subindex = 0; object && subindex <= object->highest_subindex; ++subindex) {
            const auto entry = objects.describe(index, static_cast<std::uint8_t>(subindex));
            if (!entry) continue;
            const auto& access = entry->access;
            if (list == object_list_type::rx_pdo   ? access.rx_pdo
                : list == object_list_type::tx_pdo ? access.tx_pdo
                : list == object_list_type::backup ? access.backup
                                                   : access.setting)
                return true;
        }
        return false;
    }

    static constexpr std::size_t list_count = 5;

    sdo_information_opcode opcode_{};
    std::uint16_t left_{}; // fragments
    std::size_t done_{};   // fragments of a list, bytes of a description
    object_list_type list_{};
    std::uint16_t after_{};
    std::array<std::byte, wire::max_size<entry_answer> + max_name> text_{}; // a description
    std::size_t size_{};
};

} // namespace jauscat::ethercat
