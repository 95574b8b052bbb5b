// Object of a component, with one subobject for each message that it accepts. Generated at compile time from message
// types and table; used for a slave's dictionary, creation packets and ESI files.
#pragma once
#include <jauscat/translate/table.hpp>
#include <jauscat/wire/schema.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace jauscat::bridging {

/// ETG data type of every subobject: OCTET_STRING.
inline constexpr std::uint16_t octet_string_type = 0x000A;

/// One accepted message as a subobject.
struct sub_object {
    std::uint8_t subindex{};      ///< the message's rank, 1 to 254
    std::uint16_t command_code{}; ///< the message; under a table of SAE its message ID
    std::string_view name{};      ///< the message type's name, such as `set_wrench_effort`
    std::uint16_t max_size{};     ///< bytes: the most that an access carries, or all accesses where sizes are exact
    bool readable{};              ///< an upload gives it
    bool writable{};              ///< a download takes it
    friend constexpr bool operator==(const sub_object&, const sub_object&) = default;
};

/// A component's object, as data.
struct object_description {
    std::uint16_t index{};
    std::uint8_t component{}; ///< JAUS component ID
    std::string_view name{};
    bool exact_size{};                     ///< every access carries `max_size` bytes: a table with fixed_length
    std::span<const sub_object> entries{}; ///< by ascending subindex

    [[nodiscard]] constexpr std::uint8_t highest_subindex() const noexcept {
        return entries.empty() ? std::uint8_t{} : entries.back().subindex;
    }
    /// The subobject, or nullptr.
    [[nodiscard]] constexpr const sub_object* find(std::uint8_t subindex) const noexcept {
        const auto found = std::ranges::lower_bound(entries, subindex, {}, &sub_object::subindex);
        return found != entries.end() && found->subindex == subindex ? &*found : nullptr;
    }
};

/// Bytes of the largest of all subobjects: what a slave needs as memory for transfers in segments.
[[nodiscard]] constexpr std::size_t largest_subobject(std::span<const object_description> objects) noexcept {
    std::size_t largest = 0;
    for (const auto& object : objects)
        for (const auto& entry : object.entries) largest = std::max<std::size_t>(largest, entry.max_size);
    return largest;
}

namespace detail {

/// The packet value of a component and a code under a row; 0 (no valid index or rank) if the row has none.
template <class Table, class Row>
constexpr std::uint32_t number_of(std::uint8_t component, std::uint16_t code) noexcept {
    typename Table::header_type header{};
    typename Table::packet_type packet{};
    Table::index_row::from::of(header) = component;
    Table::subindex_row::from::of(header) = code;
    return Row::to_packet(header, packet, {}) == translate::errc::ok ? Row::to::of(packet) : 0;
}
template <class Table> constexpr std::uint16_t index_of(std::uint8_t component, std::uint16_t code) noexcept {
    return static_cast<std::uint16_t>(number_of<Table, typename Table::index_row>(component, code));
}

// RA 3.3 part 2, command codes: below 2000h commands, below 4000h queries, below 6000h informs. A command or query is
// written only. An inform is read after its query, and written where it comes from another component. A message of
// another class is both.
constexpr bool is_readable(std::uint16_t command_code) noexcept { return command_code >= 0x4000; }

// "component 33"
template <std::uint8_t Component>
inline constexpr auto component_name = [] {
    constexpr std::string_view word = "component ";
    constexpr std::size_t digits = Component > 99 ? 3 : Component > 9 ? 2 : 1;
    std::array<char, word.size() + digits> text{};
    std::ranges::copy(word, text.begin());
    unsigned left = Component;
    for (std::size_t i = text.size(); i != word.size(); left /= 10) text[--i] = static_cast<char>('0' + left % 10);
    return text;
}();

template <std::size_t Size> constexpr bool distinct_subindices(const std::array<sub_object, Size>& sorted) noexcept {
    return std::ranges::adjacent_find(sorted, {}, &sub_object::subindex) == sorted.end();
}

} // namespace detail

/// The subobject of a message under `Table`: subindex 0 if the table has no rank for it. `max_body`: most bytes of the
/// message's body; wire::unbounded if it has no limit, or takes what follows it.
template <class Table>
[[nodiscard]] constexpr sub_object sub_object_of(std::uint16_t command_code, std::string_view name,
                                                 std::size_t max_body) noexcept {
    return {
        .subindex = static_cast<std::uint8_t>(detail::number_of<Table, typename Table::subindex_row>(0, command_code)),
        .command_code = command_code,
        .name = name,
        .max_size = static_cast<std::uint16_t>(std::min(wire::total_size(Table::overhead, max_body), Table::max_data)),
        .readable = detail::is_readable(command_code),
        .writable = true};
}
/// The same for a message type.
template <class Table, wire::message T> [[nodiscard]] constexpr sub_object sub_object_of() noexcept {
    return sub_object_of<Table>(translate::code_of<T>, wire::type_name<T>(),
                                translate::largest_body<typename Table::header_type, T>);
}

/// The object of the component `Component` that accepts `Messages`, each with a schema and a command code, under
/// `Table`. `Messages` may also be one list of types, such as jaus::message_list<...>.
template <class Table, std::uint8_t Component, class... Messages> struct object_list {
    static constexpr std::uint16_t index = [] {
        std::uint16_t code{}; // of the first message
        static_cast<void>(((code = translate::code_of<Messages>, true) || ...));
        return detail::index_of<Table>(Component, code);
    }();
    static constexpr std::uint8_t component = Component;
    /// "component 33"
    static constexpr std::string_view name{detail::component_name<Component>.data(),
                                           detail::component_name<Component>.size()};
    /// Every access carries the subobject's `max_size` bytes: the table has fixed lengths.
    static constexpr bool exact_size = translate::has_fixed_length<Table>;
    /// By ascending subindex.
    static constexpr std::array<sub_object, sizeof...(Messages)> entries = [] {
        std::array<sub_object, sizeof...(Messages)> made{sub_object_of<Table, Messages>()...};
        std::ranges::sort(made, {}, &sub_object::subindex);
        return made;
    }();
    static_assert(Table::max_data <= 0xFFFF, "object_list: sizes are of 16 bits");
    static_assert(entries.empty() || entries.front().subindex != 0,
                  "object_list: a message has no rank in the table; append its command code to the table's list");
    static_assert(detail::distinct_subindices(entries), "object_list: a message is listed twice");
    static_assert(((translate::code_of<Messages> == 0 || entries.front().subindex == 0 ||
                    detail::index_of<Table>(Component, translate::code_of<Messages>) == index) &&
                   ...),
                  "object_list: the messages are in several segments, each an object: use object_lists");

    /// The same without a type.
    static constexpr object_description description{index, component, name, exact_size, entries};
};

template <class Table, std::uint8_t Component, template <class...> class List, class... Messages>
requires(!wire::message<List<Messages...>>)
struct object_list<Table, Component, List<Messages...>> : object_list<Table, Component, Messages...> {};

/// The objects of the component under a table with segments: one for each segment that has a message of `Messages`.
template <class Table, std::uint8_t Component, class... Messages> struct object_lists {
  private:
    struct placed {
        std::uint16_t index{};
        sub_object entry{};
        friend constexpr bool operator<(const placed& a, const placed& b) noexcept {
            return a.index != b.index ? a.index < b.index : a.entry.subindex < b.entry.subindex;
        }
    };
    static constexpr auto sorted = [] {
        std::array<placed, sizeof...(Messages)> made{placed{
            detail::index_of<Table>(Component, translate::code_of<Messages>), sub_object_of<Table, Messages>()}...};
        std::sort(made.begin(), made.end());
        return made;
    }();
    static constexpr bool distinct =
        std::ranges::adjacent_find(sorted, [](const auto& a, const auto& b) { return !(a < b); }) == sorted.end();
    static_assert(sorted.empty() || sorted.front().entry.subindex != 0,
                  "object_lists: a message has no rank in the table; append its code to one of the table's lists");
    static_assert(sorted.empty() || sorted.front().entry.subindex == 0 || distinct,
                  "object_lists: a message is listed twice");
    static constexpr std::size_t count = [] {
        std::size_t found = 0;
        for (std::size_t i = 0; i != sorted.size(); ++i)
            found += i == 0 || sorted[i].index != sorted[i - 1].index ? 1u : 0u;
        return found;
    }();

  public:
    /// By ascending index and subindex.
    static constexpr std::array<sub_object, sizeof...(Messages)> entries = [] {
        std::array<sub_object, sizeof...(Messages)> made{};
        for (std::size_t i = 0; i != made.size(); ++i) made[i] = sorted[i].entry;
        return made;
    }();
    /// The objects, by ascending index.
    static constexpr std::array<object_description, count> descriptions = [] {
        using name = object_list<Table, Component>;
        std::array<object_description, count> made{};
        std::size_t first = 0;
        for (auto& object : made) {
            std::size_t end = first;
            while (end != sorted.size() && sorted[end].index == sorted[first].index) ++end;
            object = {sorted[first].index, Component, name::name, name::exact_size,
                      std::span{entries}.subspan(first, end - first)};
            first = end;
        }
        return made;
    }();
};

template <class Table, std::uint8_t Component, template <class...> class List, class... Messages>
requires(!wire::message<List<Messages...>>)
struct object_lists<Table, Component, List<Messages...>> : object_lists<Table, Component, Messages...> {};

} // namespace jauscat::bridging
