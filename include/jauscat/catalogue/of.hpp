// Makes a catalogue of a list of message types. The only header of catalogue/ that is compiled for each message.
#pragma once
#include <jauscat/catalogue/list.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/jaus/message/presence_bits.hpp>
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/text/describe.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/diagnose.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <concepts>
#include <initializer_list>

namespace jauscat::catalogue {

/// A message of SAE JAUS: its schema has a message ID, which is also the first field of its layout.
template <class T>
concept identified_message = wire::message<T> && requires {
    { wire::schema<T>::message_id } -> std::convertible_to<std::uint16_t>;
};

/// What a catalogue can have.
template <class T> concept catalogued_message = jaus::coded_message<T> || identified_message<T>;

namespace detail {

template <catalogued_message T> consteval std::uint16_t code_of() {
    if constexpr (identified_message<T>)
        return wire::schema<T>::message_id;
    else
        return jaus::command_code_of<T>;
}

/// Of RA 3.3, the schema names query and report; of SAE JAUS, the IDs do, where the list has both.
template <class T> consteval std::uint16_t query_code(std::initializer_list<std::uint16_t> codes) {
    if constexpr (jaus::report_message<T>) {
        return jaus::command_code_of<jaus::query_of<T>>;
    } else if constexpr (identified_message<T>) {
        const auto* const query = std::ranges::find(codes, code_of<T>(), &jaus::report_code_of);
        return query != codes.end() ? *query : std::uint16_t{};
    } else {
        return 0;
    }
}
template <class T> consteval std::uint16_t report_code(std::initializer_list<std::uint16_t> codes) {
    if constexpr (jaus::query_message<T>) {
        return jaus::command_code_of<jaus::report_of<T>>;
    } else if constexpr (identified_message<T>) {
        const std::uint16_t report = jaus::report_code_of(code_of<T>());
        return std::ranges::find(codes, report) != codes.end() ? report : 0;
    } else {
        return 0;
    }
}

template <class T, std::uint16_t Query, std::uint16_t Report>
inline constexpr entry_data data_of{
    .command_code = code_of<T>(),
    .query = Query,
    .report = Report,
    .name = wire::type_name<T>(),
    .min_size = wire::min_size<T>,
    .max_size = wire::max_size<T>,
    .presence_bits = jaus::presence_bits_of<T>,
    .has_lists = wire::needs_memory<T>,
    .takes_rest = wire::layout_of<T>::to_the_end,
    .fields = &text::describe<T>,
    .make = []() -> void* { return new T{}; },
    .destroy = [](void* object) { delete static_cast<T*>(object); },
    .decode = [](void* object, std::span<const std::byte> body,
                 wire::arena& memory) { return wire::decode(*static_cast<T*>(object), body, memory); },
    .check_values = [](const void* object) { return wire::check_values(*static_cast<const T*>(object)); },
    .encode = [](const void* object) -> result<std::vector<std::byte>, wire::errc> {
        const T& message = *static_cast<const T*>(object);
        std::vector<std::byte> body(wire::encoded_size(message));
        if (const auto written = wire::encode(message, body, wire::tolerate_values); !written) return written.error();
        return body;
    },
    .diagnose = [](std::span<const std::byte> body, wire::errc error) { return wire::diagnose<T>(body, error); }};

template <template <class...> class List, catalogued_message... Messages> list made_of(List<Messages...>) {
    return list{std::vector<entry>{entry{data_of<Messages, query_code<Messages>({code_of<Messages>()...}),
                                                 report_code<Messages>({code_of<Messages>()...})>}...}};
}

} // namespace detail

/// The catalogue of a jaus::message_list, or of any other template of message types.
template <class Messages> [[nodiscard]] const list& of() {
    static const list made = detail::made_of(Messages{});
    return made;
}

} // namespace jauscat::catalogue
