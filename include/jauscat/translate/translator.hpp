// The translator that a table makes: whole messages to whole packets, and back by the same rows.
#pragma once
#include <jauscat/translate/fixed_length.hpp>
#include <jauscat/translate/table.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace jauscat::translate {

/// Translates by the rows of `Table`. Works on bytes: the body is carried, not understood, so every message translates.
template <class Table> struct translator {
    using header_type = typename Table::header_type;
    using packet_type = typename Table::packet_type;
    static constexpr std::size_t header_size = wire::max_size<header_type>;
    static constexpr std::size_t packet_size = wire::max_size<packet_type>;    ///< without its data
    static constexpr std::size_t rest_size = Table::rest.bytes;                ///< header bytes that travel in the data
    static constexpr std::size_t max_body = Table::max_data - Table::overhead; ///< largest body one packet carries
    static constexpr std::size_t max_packet_size = packet_size + Table::max_data;
    static constexpr std::size_t max_message_size = header_size + max_body;

    /// Translates one JAUS message (header and body) into a packet, and returns that.
    /// Errors: truncated, wrong_size, too_large, no_space, unknown_command_code, reserved_value.
    [[nodiscard, gnu::always_inline]] static constexpr result<std::span<std::byte>, errc>
    to_packet(std::span<const std::byte> message, std::span<std::byte> packet) noexcept {
        return fill_packet(message, packet).of(packet);
    }

    /// The same with the fields set by the caller, such as a packet number, from `given`.
    [[nodiscard, gnu::always_inline]] static constexpr result<std::span<std::byte>, errc>
    to_packet(std::span<const std::byte> message, std::span<std::byte> packet, const packet_type& given) noexcept {
        return fill_packet(message, packet, given).of(packet);
    }

    /// Translates a packet back into the JAUS message it was made of, and returns that.
    /// Errors: truncated, wrong_size, too_large, no_space, unknown_index, unknown_subindex, reserved_value,
    /// out_of_range, wrong_packet.
    [[nodiscard, gnu::always_inline]] static constexpr result<std::span<std::byte>, errc>
    from_packet(std::span<const std::byte> packet, std::span<std::byte> message) noexcept {
        return fill_message(packet, message).of(message);
    }

    /// The same for a packet with separate fields and data.
    [[nodiscard, gnu::always_inline]] static constexpr result<std::span<std::byte>, errc>
    from_packet(const packet_type& fields, std::span<const std::byte> data, std::span<std::byte> message) noexcept {
        return fill_message(fields, data, message).of(message);
    }

  private:
    static constexpr bool fixed = has_fixed_length<Table>;
    using packed_size = wire::packed_size<errc>;

    // Whole translations. GCC may keep them out of line: the size fits a register. Clang inlines them, also into a
    // caller whose flatten attribute reaches only the functions above.
    JAUSCAT_FLATTEN JAUSCAT_INLINE static constexpr packed_size fill_packet(std::span<const std::byte> message,
                                                                            std::span<std::byte> packet) noexcept {
        return fill(message, packet, {});
    }
    JAUSCAT_FLATTEN JAUSCAT_INLINE static constexpr packed_size
    fill_packet(std::span<const std::byte> message, std::span<std::byte> packet, const packet_type& given) noexcept {
        return fill(message, packet, given);
    }
    JAUSCAT_FLATTEN JAUSCAT_INLINE static constexpr packed_size fill_message(std::span<const std::byte> packet,
                                                                             std::span<std::byte> message) noexcept {
        packet_type fields{};
        if (!wire::decode_prefix(fields, packet)) return errc::truncated;
        const std::size_t data_size = Table::data_count_row::counts_data::of(fields);
        if (data_size > packet.size() - packet_size) return errc::truncated;
        return restore(fields, packet.subspan(packet_size, data_size), message);
    }

    JAUSCAT_FLATTEN JAUSCAT_INLINE static constexpr packed_size
    fill_message(const packet_type& fields, std::span<const std::byte> data, std::span<std::byte> message) noexcept {
        return restore(fields, data, message);
    }

    // Both directions are inlined into their callers, so that a packet's fields stay in registers.
    [[gnu::always_inline]] static constexpr packed_size fill(std::span<const std::byte> message,
                                                             std::span<std::byte> packet, packet_type fields) noexcept {
        header_type header{};
        if (!wire::decode_prefix(header, message)) return errc::truncated;
        const std::size_t body = message.size() - header_size;
        const std::size_t filled = body + Table::overhead;
        std::size_t object = filled; // bytes of data
        if constexpr (fixed) {
            object = Table::object_size(header);
            if (object == 0) return errc::unknown_command_code;
        }
        if (filled > object || object > Table::max_data) return errc::too_large;
        if (packet.size() < packet_size + object) return errc::no_space;

        if (const errc error = Table::to_packet(header, fields, {body, object}); error != errc::ok) return error;
        if (wire::detail::put_message(fields, packet.data()).error != wire::errc::ok) return errc::out_of_range;
        std::byte* data = packet.data() + packet_size;
        if constexpr (fixed) {
            const data_length length{static_cast<std::uint16_t>(rest_size + body)};
            data = wire::detail::put_message(length, data).at;
        }
        each_rest(
            [&](std::size_t offset, std::size_t size) { data = copy_range(message.data() + offset, size, data); });
        copy_body(message.data() + header_size, body, data);
        if constexpr (fixed) std::fill_n(data + body, object - filled, std::byte{});
        return packet_size + object;
    }

    [[gnu::always_inline]] static constexpr packed_size
    restore(const packet_type& fields, std::span<const std::byte> data, std::span<std::byte> message) noexcept {
        auto real = data;
        if constexpr (fixed) {
            data_length length{};
            const auto used = wire::decode_prefix(length, data);
            if (!used) return errc::truncated;
            if (length.bytes > data.size() - *used) return errc::wrong_size;
            real = data.subspan(*used, length.bytes);
        }
        if (real.size() < rest_size) return errc::truncated;
        if (data.size() > Table::max_data) return errc::too_large;
        const sizes s{real.size() - rest_size, data.size()};
        if (message.size() < header_size + s.body) return errc::no_space;

        header_type header{};
        if (const errc error = Table::from_packet(fields, header, s); error != errc::ok) return error;
        if constexpr (fixed) {
            const std::size_t object = Table::object_size(header);
            if (object == 0) return errc::unknown_subindex;
            if (object != data.size()) return errc::wrong_size;
        }
        if (wire::detail::put_message(header, message.data()).error != wire::errc::ok) return errc::out_of_range;
        const std::byte* in = real.data();
        each_rest([&](std::size_t offset, std::size_t size) {
            copy_range(in, size, message.data() + offset);
            in += size;
        });
        copy_body(in, s.body, message.data() + header_size);

        if constexpr (Table::checks_rest) {
            // Not get_message, which may be a call: only some fields are needed.
            wire::layout_of<header_type>::get(header, {message.data(), 0},
                                              wire::object_scope{header, wire::plain_root{}});
            if (const errc error = Table::check_rest(header, fields, s); error != errc::ok) return error;
        }
        return header_size + s.body;
    }

    // For GCC a constant size of 6 is a call of memmove, but two moves as memcpy.
    [[gnu::always_inline]] static constexpr std::byte* copy_range(const std::byte* from, std::size_t size,
                                                                  std::byte* to) noexcept {
        if (std::is_constant_evaluated()) return std::copy_n(from, size, to);
        std::memcpy(to, from, size);
        return to + size;
    }

    // Many messages have no body: they are spared the call.
    [[gnu::always_inline]] static constexpr void copy_body(const std::byte* from, std::size_t size,
                                                           std::byte* to) noexcept {
        if (size != 0) copy_range(from, size, to);
    }

    [[gnu::always_inline]] static constexpr void each_rest(auto&& copy) noexcept {
        [&]<std::size_t... I>(std::index_sequence<I...>) {
            (copy(Table::rest.range[I].offset, Table::rest.range[I].size), ...);
        }(std::make_index_sequence<Table::rest.count>{});
    }
};

} // namespace jauscat::translate
