#include "top_table.hpp"

#include "number_text.hpp"

#include <algorithm>

namespace jausdump {

namespace {

constexpr std::size_t most_bytes = 256;              // kept of a body
constexpr std::size_t most_bytes_without_width = 32; // shown
constexpr std::size_t most_recent = 17;              // times: 16 intervals
constexpr std::chrono::nanoseconds mark_time = std::chrono::seconds{2};
constexpr std::size_t longest_name = 38, shortest_name = 12, longest_source = 16, shortest_source = 7;
constexpr std::size_t other_columns = 7 + 1 + 8 + 8 + 8 + 6 + 2; // all but name, source and bytes

double seconds(std::chrono::nanoseconds time) { return std::chrono::duration<double>{time}.count(); }

/// Filled up with spaces, and cut.
std::string fitted(std::string text, std::size_t width, bool right = false) {
    if (text.size() > width) text = text.substr(0, width - 1) + "~";
    text.insert(right ? 0 : text.size(), width - text.size(), ' ');
    return text;
}

std::string columns(const std::array<std::string, 7>& cells, std::size_t name_width, std::size_t source_width) {
    const auto& [code, name, source, count, rate, age, size] = cells;
    return fitted(code, 7) + fitted(name, name_width) + " " + fitted(source, source_width) + fitted(count, 8, true) +
           fitted(rate, 8, true) + fitted(age, 8, true) + fitted(size, 6, true) + "  ";
}

std::array<std::uint16_t, 4> id_of(const record& message) {
    if (message.head) {
        const auto& id = message.head->source;
        return {id.subsystem, id.node, id.component, id.instance};
    }
    if (!message.sae || !message.sae->header) return {};
    const auto& id = message.sae->header->source;
    return {id.subsystem, id.node, id.component, 0};
}

std::string source_of(const record& message) {
    if (message.head) return text::to_text(message.head->source);
    if (message.sae && message.sae->header) return std::string{sae::jaus_id_text{message.sae->header->source}.view()};
    return {};
}

std::string name_of(const record& message) {
    if (!message.is_message()) return "not a message";
    if (message.refusal) return message.name + " (refused)";
    return message.kind == kind::part ? message.name + " (packets)" : message.name;
}

} // namespace

void top_table::add(const record& message) {
    ++messages_;
    const auto code = message.code();
    const std::array<std::string, 3> key{code ? text::hex_number(*code, 4) : "-", name_of(message), source_of(message)};
    row& one = rows_[key];
    one.code = key[0];
    one.name = key[1];
    one.source = key[2];
    one.id = id_of(message);
    one.is_sae = message.sae.has_value();
    const auto at = message.origin.time;
    if (at) {
        newest_ = std::max(newest_, *at);
        if (!one.first) one.first = at;
        one.last = at;
        one.recent.push_back(*at);
        if (one.recent.size() > most_recent) one.recent.pop_front();
    }
    const auto body = message.is_message() ? message.body() : std::span<const std::byte>{message.bytes};
    const auto begin = body.first(std::min(body.size(), most_bytes));
    const std::size_t before = one.bytes.size();
    one.changed_at.resize(begin.size());
    for (std::size_t i = 0; one.count != 0 && i != begin.size(); ++i)
        if (i >= before || one.bytes[i] != begin[i]) one.changed_at[i] = at.value_or(time{});
    one.bytes.assign(begin.begin(), begin.end());
    one.size = body.size();
    ++one.count;
}

std::optional<double> top_table::rate_of(const row& one, time now) const {
    if (!one.first || one.count < 2) return std::nullopt;
    time span = *one.last - *one.first;
    auto intervals = static_cast<double>(one.count - 1);
    if (live_) {
        intervals = static_cast<double>(one.recent.size() - 1);
        span = *one.last - one.recent.front();
        // The next message is late: the rate falls.
        if (intervals != 0 && seconds(now - *one.last) > 2 * seconds(span) / intervals) span = now - one.recent.front();
    }
    return span.count() > 0 ? std::optional{intervals / seconds(span)} : std::nullopt;
}

bool top_table::is_marked(const row& one, std::size_t byte, time now) const {
    const auto changed = one.changed_at[byte];
    return changed && (!live_ || now - *changed < mark_time);
}

std::vector<const top_table::row*> top_table::sorted(time now, top_order order) const {
    std::vector<const row*> all;
    for (const auto& [key, one] : rows_) all.push_back(&one); // by code, name and source
    const auto by = [&](const auto& value) {
        std::ranges::stable_sort(all, [&](const row* a, const row* b) { return value(*a) < value(*b); });
    };
    switch (order) {
    case top_order::code: break;
    case top_order::message: by([](const row& one) { return one.name; }); break;
    case top_order::source: by([](const row& one) { return one.id; }); break;
    case top_order::count: by([](const row& one) { return SIZE_MAX - one.count; }); break;
    case top_order::rate: by([&](const row& one) { return -rate_of(one, now).value_or(0); }); break;
    case top_order::age: by([&](const row& one) { return now - one.last.value_or(time{}); }); break;
    }
    return all;
}

top_table::widths top_table::widths_for(const std::vector<const row*>& all, const top_style& style) {
    if (style.width == 0) return {.name = longest_name, .source = longest_source};
    std::size_t name = 0, source = 0;
    for (const auto* const one : all) {
        name = std::max(name, one->name.size());
        source = std::max(source, one->source.size() + 1);
    }
    source = std::clamp(source, shortest_source, longest_source);
    const std::size_t left = style.width > other_columns + source ? style.width - other_columns - source : 0;
    name = std::clamp(name, shortest_name, longest_name);
    return {.name = std::clamp(left / 2, shortest_name, name), .source = source};
}

std::string top_table::line_of(const row& one, time now, const top_style& style, const widths& width) const {
    const auto rate = rate_of(one, now);
    std::string line =
        columns({one.code, one.name, one.source, std::to_string(one.count), rate ? fixed_text(*rate, 2) : "-",
                 one.last ? fixed_text(std::max(0.0, seconds(now - *one.last)), 1) : "-", std::to_string(one.size)},
                width.name, width.source);
    std::size_t shown = most_bytes_without_width;
    if (style.width != 0) shown = style.width > line.size() ? (style.width - line.size()) / 3 : 0;
    shown = std::min(shown, one.bytes.size());
    // The last three characters say that there are more.
    const bool is_cut = shown < one.size;
    if (is_cut && style.width != 0 && shown != 0) --shown;
    for (std::size_t i = 0; i != shown; ++i) {
        const auto digits = text::detail::plain_hex(std::span{one.bytes}.subspan(i, 1));
        const bool marked = is_marked(one, i, now);
        if (style.has_colours())
            line += (marked ? "\033[7m" + digits + style.colours.end : digits) + " ";
        else
            line += digits + (marked ? "*" : " ");
    }
    if (is_cut) line += "..";
    if (style.width != 0 && line.size() > style.width && shown == 0) line.resize(style.width);
    while (line.ends_with(' ')) line.pop_back();
    return line;
}

std::vector<std::string> top_table::lines(time now, top_order order, const top_style& style, std::size_t begin,
                                          std::size_t count) const {
    const auto marks = style.has_colours() ? "body, changed bytes in reverse" : "body, * behind changed bytes";
    const auto all = sorted(now, order);
    const auto width = widths_for(all, style);
    auto heading =
        columns({"code", "message", "source", "count", "per s", "age (s)", "size"}, width.name, width.source) + marks;
    if (style.width != 0 && heading.size() > style.width) heading.resize(style.width);
    std::vector<std::string> made{style.colours.bold + heading + style.colours.end};
    for (std::size_t i = begin; i < all.size() && i - begin < count; ++i)
        made.push_back(line_of(*all[i], now, style, width));
    return made;
}

std::string top_table::json_lines(time now, top_order order) const {
    std::string made;
    for (const auto* const one : sorted(now, order)) {
        json changed = json::array();
        for (std::size_t i = 0; i != one->bytes.size(); ++i)
            if (is_marked(*one, i, now)) changed.push_back(i);
        json object{{"message", one->name},
                    {"code", one->code},
                    {"generation", one->is_sae ? "SAE" : "RA"},
                    {"source", one->source},
                    {"count", one->count},
                    {"rate", nullptr},
                    {"age", nullptr},
                    {"size", one->size},
                    {"bytes", text::detail::plain_hex(one->bytes)},
                    {"changed", std::move(changed)}};
        if (const auto rate = rate_of(*one, now)) object["rate"] = *rate;
        if (one->last) object["age"] = seconds(now - *one->last);
        made += object.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
    }
    return made;
}

} // namespace jausdump
