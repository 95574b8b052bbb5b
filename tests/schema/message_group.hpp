// What tests need of each message, instantiated for one subgroup at a time: a translation unit for each (see
// message_group.cpp.in) keeps compilers within minutes and memory.
#pragma once
#include "schema/messages.hpp"
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/schema/jaus/messages.hpp>
#include <jauscat/wire/view.hpp>

namespace messages {

namespace detail {

inline std::span<std::byte> scratch() {
    static octets memory(1 << 20);
    return memory;
}

template <wire::message T> octets encode(const T& value) {
    octets bytes(wire::encoded_size(value));
    const auto written = wire::encode(value, bytes);
    if (!written) bytes.clear();
    return bytes;
}

template <wire::message T> wire::errc decode_into(T& value, std::span<const std::byte> body, wire::arena& memory) {
    return wire::decode(value, body, memory).error();
}

/// Whether what a view shows is the decoded member.
template <class Seen, class Value> bool agrees(const Seen& seen, const Value& value);
template <class T, class Outer> bool view_agrees(const wire::view<T, Outer>& seen, const T& value) {
    bool all = true;
    wire::visit(value, [&]<class Item>(Item, const auto& member) {
        all = all && agrees(seen.template get<Item::key>(), member);
    });
    return all;
}
template <class Seen, class Value> bool agrees(const Seen& seen, const Value& value) {
    if constexpr (requires { value.has_value(); })
        return seen.has_value() == value.has_value() && (!value || agrees(*seen, *value));
    else if constexpr (requires { seen.has_value(); })
        return seen && agrees(*seen, value);
    else if constexpr (requires { view_agrees(seen, value); })
        return view_agrees(seen, value);
    else if constexpr (requires { *seen.begin() == *value.begin(); } || !requires { seen == value; })
        return std::ranges::equal(seen, value, [](const auto& a, const auto& b) { return agrees(a, b); });
    else
        return seen == value;
}

template <wire::message T> encoded random(support::generator& g, const support::odds& odds) {
    std::pmr::monotonic_buffer_resource memory;
    const T value = support::random_message<T>(g, memory, odds);
    encoded made;
    made.bytes.resize(wire::encoded_size(value));
    const auto written = wire::encode(value, made.bytes);
    made.error = written.error();
    made.why = wire::diagnose(value);
    T back{};
    wire::arena arena{scratch()};
    made.decodes_to_itself =
        written->size() == made.bytes.size() && decode_into(back, made.bytes, arena) == wire::errc::ok && back == value;
    octets room(2 * (jaus::header_size + jaus::max_body_size) + made.bytes.size()), sent;
    const auto out = [&](std::span<const std::byte> packet) {
        sent.insert(sent.end(), packet.begin() + jaus::header_size, packet.end());
    };
    made.is_put = jaus::put({.source = {1, 1, 1, 1}}, value, room, out).has_value() && sent == made.bytes;
    return made;
}

template <wire::message T> decoded read(std::span<const std::byte> body) {
    decoded made;
    T value{};
    wire::arena memory{scratch()};
    made.error = decode_into(value, body, memory);
    const wire::view<T> view{body};
    made.view_error = view.error();
    made.why = wire::diagnose<T>(body);
    if (made.error == wire::errc::ok) {
        made.again = encode(value);
        made.view_agrees = view && view_agrees(view, value);
    }
    wire::raw<T> raw{};
    memory.reset();
    made.raw_error = decode_into(raw, body, memory);
    if (made.raw_error == wire::errc::ok) made.raw_again = encode(raw);
    wire::arena nothing{{}};
    made.without_memory = decode_into(value, body, nothing);
    return made;
}

template <wire::message T> judged judge(std::span<const std::byte> body) {
    T value{};
    wire::arena memory{scratch()};
    return {.error = decode_into(value, body, memory), .why = wire::diagnose<T>(body)};
}

template <class... Messages>
jaus::dispatched dispatch(const jaus::header& head, std::span<const std::byte> body, std::vector<handled>& seen) {
    jaus::dispatcher all{jaus::on<Messages>([&](const jaus::header& header, const Messages& message) {
        seen.push_back({.code = jaus::command_code_of<Messages>, .header = header, .body = encode(message)});
    })...};
    wire::arena memory{scratch()};
    return all(head, body, memory);
}

template <class... Messages> struct chosen {};
template <unsigned Digit, class... Chosen> auto choose(chosen<Chosen...> list, jaus::message_list<>) { return list; }
template <unsigned Digit, class... Chosen, class First, class... Rest>
auto choose(chosen<Chosen...>, jaus::message_list<First, Rest...>) {
    if constexpr (jaus::command_code_of<First> / 0x100 % 0x10 == Digit)
        return choose<Digit>(chosen<Chosen..., First>{}, jaus::message_list<Rest...>{});
    else
        return choose<Digit>(chosen<Chosen...>{}, jaus::message_list<Rest...>{});
}

template <class... Messages> const group& make_group(chosen<Messages...>) {
    static const std::array<functions, sizeof...(Messages)> all{functions{.code = jaus::command_code_of<Messages>,
                                                                          .object_size = sizeof(Messages),
                                                                          .has_lists = wire::needs_memory<Messages>,
                                                                          .random = &random<Messages>,
                                                                          .read = &read<Messages>,
                                                                          .judge = &judge<Messages>}...};
    static const group made{all, &dispatch<Messages...>};
    return made;
}

} // namespace detail

template <unsigned Digit> const group& group_of() {
    return detail::make_group(detail::choose<Digit>(detail::chosen<>{}, jaus::messages{}));
}

} // namespace messages
