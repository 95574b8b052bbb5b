#include "ecat/value.hpp"

#include "support/output.hpp"
#include <jauscat/text/quoted.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

namespace ecat {

namespace {

using json = nlohmann::ordered_json;

json to_json(const value& v) {
    return std::visit(
        [](const auto& data) -> json {
            using T = std::decay_t<decltype(data)>;
            if constexpr (std::is_same_v<T, std::monostate>) {
                return nullptr;
            } else if constexpr (std::is_same_v<T, list>) {
                json made = json::array();
                for (const auto& each : data) made.push_back(to_json(each));
                return made;
            } else if constexpr (std::is_same_v<T, record>) {
                json made = json::object();
                for (const auto& [key, member] : data) made[key] = to_json(member);
                return made;
            } else {
                return data;
            }
        },
        v.data());
}

} // namespace

std::string value::text() const {
    if (!shown_.empty()) return shown_;
    if (const auto* text = std::get_if<std::string>(&data_)) return *text;
    if (std::holds_alternative<std::monostate>(data_)) return "-";
    if (const auto* is = std::get_if<bool>(&data_)) return *is ? "yes" : "no";
    return to_json(*this).dump();
}

std::string hex(std::uint64_t number, int digits) {
    std::array<char, 24> text{};
    std::snprintf(text.data(), text.size(), "0x%0*llX", digits, static_cast<unsigned long long>(number));
    return text.data();
}

std::string hex_bytes(const std::vector<std::byte>& data) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const auto each : data) {
        text += digits[std::to_integer<std::size_t>(each) >> 4];
        text += digits[std::to_integer<std::size_t>(each) & 0xF];
    }
    return text;
}

std::string printable(std::string_view text) {
    auto made = jauscat::text::as_utf8(text.substr(0, text.find('\0')));
    std::ranges::replace_if(made, [](char c) { return (c >= 0 && c < ' ') || c == '\x7F'; }, '?');
    for (std::size_t at = 0; (at = made.find('\xC2', at)) != made.npos; ++at) // control characters of Latin-1
        if (const auto second = static_cast<unsigned char>(made[at + 1]); second < 0xA0) made.replace(at, 2, "?");
    return made;
}

void print_json(const value& v, bool compact) {
    std::cout << to_json(v).dump(compact ? -1 : 2, ' ', false, json::error_handler_t::replace) << "\n";
    example::require_output();
}

std::string table_text(const std::vector<record>& rows, const std::vector<std::string_view>& hidden) {
    if (rows.empty()) return {};
    std::string text;
    const auto columns = rows.front().size();
    std::vector<std::size_t> widths(columns);
    std::vector<bool> is_right(columns);
    const auto is_hidden = [&](std::size_t i) {
        return std::ranges::find(hidden, rows.front()[i].first) != hidden.end();
    };
    for (std::size_t i = 0; i != columns; ++i) {
        widths[i] = rows.front()[i].first.size();
        is_right[i] = std::ranges::all_of(rows, [&](const record& row) {
            return row.at(i).second.is_plain_number() || std::holds_alternative<std::monostate>(row[i].second.data());
        });
        for (const auto& row : rows) widths[i] = std::max(widths[i], row.at(i).second.text().size());
    }
    const auto add = [&](auto&& cell_of) {
        std::string line;
        for (std::size_t i = 0; i != columns; ++i) {
            if (is_hidden(i)) continue;
            const std::string cell = cell_of(i);
            const std::string gap(widths[i] - std::min(widths[i], cell.size()), ' ');
            if (!line.empty()) line += "  ";
            line += is_right[i] ? gap + cell : cell + gap;
        }
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    };
    add([&](std::size_t i) {
        auto heading = rows.front()[i].first;
        std::ranges::replace(heading, '_', ' ');
        return heading;
    });
    for (const auto& row : rows) add([&](std::size_t i) { return row[i].second.text(); });
    return text;
}

void print_table(const std::vector<record>& rows, const std::vector<std::string_view>& hidden) {
    std::cout << table_text(rows, hidden);
    example::require_output();
}

void print_record(const record& members, const std::string& indent) {
    std::size_t width = 0;
    for (const auto& [key, member] : members) width = std::max(width, key.size());
    for (const auto& [key, member] : members) {
        auto heading = key;
        std::ranges::replace(heading, '_', ' ');
        const auto* inner = std::get_if<record>(&member.data());
        const auto* many = std::get_if<list>(&member.data());
        const bool is_rows = many != nullptr && !many->empty() && std::holds_alternative<record>(many->front().data());
        if (inner != nullptr) {
            std::cout << indent << heading << "\n";
            print_record(*inner, indent + "  ");
        } else if (is_rows) {
            std::vector<record> rows;
            for (const auto& each : *many) rows.push_back(std::get<record>(each.data()));
            std::cout << indent << heading << "\n";
            const auto text = table_text(rows);
            for (std::size_t at = 0; at < text.size();) {
                const auto end = text.find('\n', at) + 1;
                std::cout << indent << "  " << text.substr(at, end - at);
                at = end;
            }
        } else {
            std::cout << indent << heading << std::string(width - key.size() + 2, ' ') << member.text() << "\n";
        }
    }
    example::require_output();
}

} // namespace ecat
