// <slave> of an <ethercat> of a configuration file.
#pragma once

#include <jauscat/net/config/detail/config_values.hpp>
#include <jauscat/net/config/slave_entry.hpp>

#include <array>
#include <bit>
#include <charconv>
#include <concepts>
#include <limits>
#include <string>
#include <vector>

namespace jauscat::net::detail {

/// A number in decimal, or in hexadecimal after 0x.
template <class T>
T config_any_number(const config_source& source, const config_value& value, T first, std::string_view what) {
    constexpr T last = std::numeric_limits<T>::max();
    const bool is_hex = value.text.starts_with("0x") || value.text.starts_with("0X");
    const auto digits = value.text.substr(is_hex ? 2 : 0);
    T number{};
    const auto* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, number, is_hex ? 16 : 10);
    if (error == std::errc{} && stop == end && number >= first) return number;
    source.note(config_errc::invalid_value, value,
                std::string{value.name} + ' ' + quoted(value.text) + " is not " + std::string{what} + ", " +
                    std::to_string(first) + " to " + std::to_string(last) + ", decimal or hexadecimal (0x10)");
    return first;
}
template <class T>
std::optional<T> config_optional_number(const config_source& source, const config_value& value, T first,
                                        std::string_view what) {
    if (!value.given) return std::nullopt;
    return config_any_number<T>(source, value, first, what);
}

/// The value of an object: its bytes, by the name of its type in ETG.1020.
class object_text {
  public:
    object_text(const config_source& source, const config_value& type, const config_value& value)
        : source_{source}, type_{type}, value_{value} {}

    [[nodiscard]] std::vector<std::byte> bytes() const {
        const auto is = [&](std::string_view name) { return type_.text == name; };
        if (is("BOOL")) return boolean();
        if (is("SINT")) return number<std::int8_t>();
        if (is("INT")) return number<std::int16_t>();
        if (is("DINT")) return number<std::int32_t>();
        if (is("LINT")) return number<std::int64_t>();
        if (is("USINT")) return number<std::uint8_t>();
        if (is("UINT")) return number<std::uint16_t>();
        if (is("UDINT")) return number<std::uint32_t>();
        if (is("ULINT")) return number<std::uint64_t>();
        if (is("REAL")) return real<float, std::uint32_t>();
        if (is("LREAL")) return real<double, std::uint64_t>();
        if (is("STRING")) return string();
        if (is("OCTET_STRING")) return octets();
        source_.fail(config_errc::invalid_value, type_,
                     "type " + quoted(type_.text) +
                         " is unknown; use BOOL, SINT, INT, DINT, LINT, USINT, UINT, UDINT, ULINT, REAL, LREAL, STRING "
                         "or OCTET_STRING");
    }

  private:
    [[noreturn]] void refuse(const std::string& what) const {
        source_.fail(config_errc::invalid_value, value_, "value " + quoted(value_.text) + " is not " + what);
    }
    template <std::unsigned_integral T> static std::vector<std::byte> little_endian(T number) {
        std::vector<std::byte> made;
        for (std::size_t i = 0; i != sizeof number; ++i) made.push_back(static_cast<std::byte>(number >> 8 * i & 0xFF));
        return made;
    }
    [[nodiscard]] std::vector<std::byte> boolean() const {
        if (value_.text != "0" && value_.text != "1") refuse("a BOOL, 0 or 1");
        return {static_cast<std::byte>(value_.text == "1")};
    }
    template <class T> [[nodiscard]] std::vector<std::byte> number() const {
        const bool is_hex = value_.text.starts_with("0x") || value_.text.starts_with("0X");
        const auto digits = value_.text.substr(is_hex ? 2 : 0);
        T value{};
        const auto* const end = digits.data() + digits.size();
        const auto [stop, error] = std::from_chars(digits.data(), end, value, is_hex ? 16 : 10);
        if (error != std::errc{} || stop != end)
            refuse("of the type " + std::string{type_.text} + ", " + std::to_string(std::numeric_limits<T>::min()) +
                   " to " + std::to_string(std::numeric_limits<T>::max()) + ", decimal or hexadecimal (0x10)");
        return little_endian(static_cast<std::make_unsigned_t<T>>(value));
    }
    template <class T, class Bits> [[nodiscard]] std::vector<std::byte> real() const {
        T value{};
        const auto* const end = value_.text.data() + value_.text.size();
        const auto [stop, error] = std::from_chars(value_.text.data(), end, value);
        if (error != std::errc{} || stop != end) refuse("a number of the type " + std::string{type_.text});
        return little_endian(std::bit_cast<Bits>(value));
    }
    [[nodiscard]] std::vector<std::byte> string() const {
        const auto* const data = reinterpret_cast<const std::byte*>(value_.text.data());
        return {data, data + value_.text.size()};
    }
    [[nodiscard]] std::vector<std::byte> octets() const {
        std::vector<std::byte> made;
        for (std::size_t at = 0; at < value_.text.size(); at += 2) {
            std::uint8_t octet{};
            const auto digits = value_.text.substr(at, 2);
            const auto* const end = digits.data() + digits.size();
            const auto [stop, error] = std::from_chars(digits.data(), end, octet, 16);
            if (error != std::errc{} || stop != end || digits.size() != 2) refuse("pairs of hexadecimal digits");
            made.push_back(static_cast<std::byte>(octet));
        }
        return made;
    }

    const config_source& source_;
    const config_value& type_;
    const config_value& value_;
};

inline start_up_sdo config_start_up_sdo(const config_source& source, pugi::xml_node node) {
    std::array values{config_value{"index"}, config_value{"subindex"}, config_value{"type"}, config_value{"value"}};
    source.collect(node, values);
    const auto& [index, subindex, type, value] = values;
    source.need(node, {index, type, value});
    return {.index = config_any_number<std::uint16_t>(source, index, 1, "an object's index"),
            .subindex = config_optional_number<std::uint8_t>(source, subindex, 0, "a subindex").value_or(0),
            .data = object_text{source, type, value}.bytes(),
            .line = source.line_of(node)};
}

/// Either a mode of the ESI file or the numbers.
inline void config_sync(const config_source& source, pugi::xml_node node, slave_entry& made) {
    std::array values{config_value{"mode"}, config_value{"assign_activate"}, config_value{"cycle"},
                      config_value{"sync1_delay"}, config_value{"shift"}};
    source.collect(node, values);
    const auto& [mode, assign_activate, cycle, sync1_delay, shift] = values;
    const bool has_numbers = assign_activate.given || cycle.given || sync1_delay.given || shift.given;
    if (mode.given && has_numbers)
        source.fail(config_errc::invalid_value, mode, "a <sync> has a mode or numbers; leave one of the two out");
    if (mode.given && made.esi.empty())
        source.fail(config_errc::missing, mode,
                    "the mode " + quoted(mode.text) + " is one of an ESI file; give the slave's esi");
    made.sync_mode = std::string{mode.text};
    if (mode.given) return;
    constexpr sync_entry made_default{};
    std::int32_t later{};
    const auto* const end = shift.text.data() + shift.text.size();
    if (shift.given) {
        const auto [stop, error] = std::from_chars(shift.text.data(), end, later);
        if (error != std::errc{} || stop != end || later < -1'000'000'000 || later > 1'000'000'000)
            source.fail(config_errc::invalid_value, shift,
                        "shift " + quoted(shift.text) + " is not in ns, -1000000000 to 1000000000");
    }
    made.sync = sync_entry{
        .assign_activate = config_optional_number<std::uint16_t>(source, assign_activate, 1, "an AssignActivate")
                               .value_or(made_default.assign_activate),
        .cycle = config_optional_number<std::uint32_t>(source, cycle, 1, "a cycle in ns").value_or(0),
        .sync1_delay = config_optional_number<std::uint32_t>(source, sync1_delay, 0, "a delay in ns").value_or(0),
        .shift = later};
}

inline timeout_entry config_timeouts(const config_source& source, pugi::xml_node node) {
    std::array values{config_value{"pre_op"}, config_value{"safe_op_op"}, config_value{"back_to_init"},
                      config_value{"back_to_safe_op"}, config_value{"mailbox"}};
    source.collect(node, values);
    const auto time = [&](const config_value& value) -> std::optional<timeout_entry::milliseconds> {
        const auto count = config_optional_number<std::uint16_t>(source, value, 1, "a time in ms");
        if (!count) return {};
        return timeout_entry::milliseconds{*count};
    };
    return {time(values[0]), time(values[1]), time(values[2]), time(values[3]), time(values[4])};
}

inline slave_entry config_slave(const config_source& source, pugi::xml_node node) {
    std::array values{config_value{"name"},           config_value{"position"}, config_value{"alias"},
                      config_value{"identification"}, config_value{"vendor"},   config_value{"product"},
                      config_value{"revision"},       config_value{"serial"},   config_value{"esi"},
                      config_value{"optional"}};
    source.collect(node, values, {"sdo", "sync", "timeouts"});
    const auto& [name, position, alias, identification, vendor, product, revision, serial, esi, is_optional] = values;
    source.need(node, {name});
    if (name.text.find_first_of(" \t\r\n") != name.text.npos)
        source.note(config_errc::invalid_value, name,
                    "the name " + quoted(name.text) + " of a slave has no blanks; write it as one word");
    slave_entry made{.name = std::string{name.text},
                     .position = config_optional_number<std::uint16_t>(source, position, 0, "a position in the ring"),
                     .alias = config_optional_number<std::uint16_t>(source, alias, 1, "a station alias"),
                     .identification =
                         config_optional_number<std::uint16_t>(source, identification, 1, "a device identification"),
                     .vendor = config_optional_number<std::uint32_t>(source, vendor, 0, "a vendor ID"),
                     .product = config_optional_number<std::uint32_t>(source, product, 0, "a product code"),
                     .revision = config_optional_number<std::uint32_t>(source, revision, 0, "a revision number"),
                     .serial = config_optional_number<std::uint32_t>(source, serial, 0, "a serial number"),
                     .esi = std::string{esi.text},
                     .is_optional = config_choice(source, is_optional, "no", "yes"),
                     .line = source.line_of(node)};
    if (!made.position && !made.alias && !made.identification && !made.vendor && !made.product && !made.serial &&
        made.esi.empty())
        source.note(config_errc::missing, "slave", made.line,
                    "nothing identifies the slave " + quoted(std::string_view{made.name}) +
                        "; give its position, alias, identification, vendor, product, serial or esi");
    for (const auto child : node.children("sync")) {
        if (made.sync || !made.sync_mode.empty())
            source.fail(config_errc::duplicate, "sync", source.line_of(child),
                        "the slave " + quoted(std::string_view{made.name}) + " has two <sync>; leave one");
        source.attempt([&] { config_sync(source, child, made); });
    }
    for (const auto child : node.children("timeouts")) {
        if (made.timeouts != timeout_entry{})
            source.fail(config_errc::duplicate, "timeouts", source.line_of(child),
                        "the slave " + quoted(std::string_view{made.name}) + " has two <timeouts>; leave one");
        source.attempt([&] { made.timeouts = config_timeouts(source, child); });
    }
    for (const auto child : node.children("sdo"))
        source.attempt([&] { made.start_up.push_back(config_start_up_sdo(source, child)); });
    return made;
}

/// All slaves of a bus: two have neither the same name, nor the same position, alias or identification.
inline std::vector<slave_entry> config_slaves(const config_source& source, pugi::xml_node node) {
    std::vector<slave_entry> made;
    for (const auto child : node.children("slave")) {
        slave_entry next;
        if (!source.attempt([&] { next = config_slave(source, child); })) continue;
        for (const auto& other : made) {
            const auto differ = [&](const char* what, const auto& a, const auto& b) {
                if (a != b) return;
                source.note(config_errc::duplicate, what, next.line,
                            "the slave " + quoted(std::string_view{next.name}) + " has the " + what +
                                " of the <slave> in line " + std::to_string(other.line) + "; give each its own");
            };
            differ("name", next.name, other.name);
            if (next.position) differ("position", next.position, other.position);
            if (next.alias) differ("alias", next.alias, other.alias);
            if (next.identification) differ("identification", next.identification, other.identification);
        }
        made.push_back(std::move(next));
    }
    return made;
}

} // namespace jauscat::net::detail
