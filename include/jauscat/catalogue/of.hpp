// Makes a catalogue of a list of message types. The only header of catalogue/ that is compiled for each message.
#pragma once
#include <jauscat/catalogue/list.hpp>
#include <jauscat/jaus/message/presence_bits.hpp>
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/text/annotate.hpp>
#include <jauscat/text/describe.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/diagnose.hpp>
#include <jauscat/wire/encode.hpp>

namespace jauscat::catalogue {

namespace detail {

template <jaus::coded_message T> constexpr std::uint16_t query_code() {
    if constexpr (jaus::report_message<T>)
        return jaus::command_code_of<jaus::query_of<T>>;
    else
        return 0;
}
template <jaus::coded_message T> constexpr std::uint16_t report_code() {
    if constexpr (jaus::query_message<T>)
        return jaus::command_code_of<jaus::report_of<T>>;
    else
        return 0;
}

template <jaus::coded_message T>
inline constexpr entry_data data_of{
    .command_code = jaus::command_code_of<T>,
    .query = query_code<T>(),
    .report = report_code<T>(),
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
    .encode = [](const void* object) -> result<std::vector<std::byte>, wire::errc> {
        const T& message = *static_cast<const T*>(object);
        std::vector<std::byte> body(wire::encoded_size(message));
        if (const auto written = wire::encode(message, body); !written) return written.error();
        return body;
    },
    .diagnose = [](std::span<const std::byte> body) { return wire::diagnose<T>(body); },
    .annotate = [](std::span<const std::byte> body,
                   std::size_t first_offset) { return text::annotate<T>(body, first_offset); }};

template <template <class...> class List, jaus::coded_message... Messages> list made_of(List<Messages...>) {
    return list{std::vector<entry>{entry{data_of<Messages>}...}};
}

} // namespace detail

/// The catalogue of a jaus::message_list, or of any other template of message types.
template <class Messages> [[nodiscard]] const list& of() {
    static const list made = detail::made_of(Messages{});
    return made;
}

} // namespace jauscat::catalogue
