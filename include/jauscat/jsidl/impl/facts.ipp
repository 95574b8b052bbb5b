// Tables of facts, written and read.
#pragma once
#include <jauscat/jsidl/check.hpp>
#include <jauscat/jsidl/facts.hpp>
#include <jauscat/jsidl/source.hpp>
#include <jauscat/text/quoted.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <map>
#include <utility>

namespace jauscat::jsidl {
namespace detail {

inline constexpr std::array<std::pair<std::string_view, scalar>, 10> type_words{{{"u8", scalar::u8},
                                                                                 {"u16", scalar::u16},
                                                                                 {"u32", scalar::u32},
                                                                                 {"u64", scalar::u64},
                                                                                 {"i8", scalar::i8},
                                                                                 {"i16", scalar::i16},
                                                                                 {"i32", scalar::i32},
                                                                                 {"i64", scalar::i64},
                                                                                 {"f32", scalar::f32},
                                                                                 {"f64", scalar::f64}}};
inline constexpr std::array<std::pair<std::string_view, kind>, 15> kind_words{{{"number", kind::number},
                                                                               {"choice", kind::choice},
                                                                               {"choice_form", kind::choice_form},
                                                                               {"bits", kind::bits},
                                                                               {"bit_part", kind::bit_part},
                                                                               {"fixed_string", kind::fixed_string},
                                                                               {"string", kind::string},
                                                                               {"blob", kind::blob},
                                                                               {"formatted_blob", kind::formatted_blob},
                                                                               {"format", kind::format},
                                                                               {"array", kind::array},
                                                                               {"record", kind::record},
                                                                               {"sequence", kind::sequence},
                                                                               {"list", kind::list},
                                                                               {"variant", kind::variant}}};

template <class Words, class Value> constexpr std::string_view word_of(const Words& words, Value value) {
    return std::ranges::find(words, value, [](const auto& each) { return each.second; })->first;
}

/// The shortest decimal form that reads back as the same number.
inline std::string shortest(double value) {
    std::array<char, 32> digits{};
    const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    return {digits.data(), written.ptr};
}

/// A word of a table: as it is, or between quotes.
inline std::string table_word(std::string_view text) {
    const auto plain = [](char c) { return c > ' ' && c != '"' && c != '\\' && c != '#' && c != 0x7F; };
    return !text.empty() && std::ranges::all_of(text, plain) ? std::string{text} : text::quoted(text);
}

inline void write_element(std::string& out, const element& each, std::size_t depth) {
    (out += std::string(depth, ' ')) += word_of(kind_words, each.kind);
    if (each.kind != kind::format) (out += ' ') += table_word(each.name);
    if (each.optional) out += " optional";
    const auto add = [&](std::string_view key, std::string_view value) {
        ((out += ' ') += key) += '=';
        out += value;
    };
    const auto add_count = [&] {
        add("type", word_of(type_words, each.type));
        add("count", std::to_string(each.min_count) + ".." + std::to_string(each.max_count));
    };
    switch (each.kind) {
    case kind::choice_form: add("index", std::to_string(each.index)); [[fallthrough]];
    case kind::number:
        add("type", word_of(type_words, each.type));
        add("unit", table_word(each.unit));
        break;
    case kind::bits: add("type", word_of(type_words, each.type)); break;
    case kind::bit_part: add("bits", std::to_string(each.first_bit) + ".." + std::to_string(each.last_bit)); break;
    case kind::fixed_string: add("length", std::to_string(each.max_count)); break;
    case kind::blob: add("format", table_word(each.format)); [[fallthrough]];
    case kind::string:
    case kind::formatted_blob:
    case kind::list:
    case kind::variant: add_count(); break;
    case kind::format:
        add("index", std::to_string(each.index));
        add("format", table_word(each.format));
        break;
    case kind::array:
        for (const auto size : each.dimensions) add("size", std::to_string(size));
        break;
    case kind::record:
    case kind::sequence:
        if (each.presence) add("presence", word_of(type_words, *each.presence));
        break;
    case kind::choice: break;
    }
    if (each.scale) add("scale", shortest(each.scale->min) + ".." + shortest(each.scale->max));
    for (const auto& named : each.names) add("value", std::to_string(named.value) + ':' + table_word(named.name));
    for (const auto& range : each.ranges)
        add("range", (range.with_min ? "[" : "(") + shortest(range.min) + ".." + shortest(range.max) +
                         (range.with_max ? "]" : ")"));
    out += '\n';
    for (const auto& child : each.children) write_element(out, child, depth + 1);
}

inline void write_reference(std::string& out, std::string_view word, const service_reference& to) {
    ((out += ' ') += word) += ' ';
    (out += table_word(to.name) + ' ') += table_word(to.id) + ' ' + table_word(to.version) + '\n';
}

inline void write_message(std::string& out, std::string_view direction, const message& each) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    ((out += ' ') += direction) += ' ' + table_word(each.name) + ' ';
    for (int shift = 12; shift >= 0; shift -= 4) out += digits[each.id >> shift & 0xF];
    if (each.is_command) out += " command";
    if (each.is_deprecated) out += " deprecated";
    out += '\n';
    if (each.body) write_element(out, *each.body, 2);
}

/// Reads a table line by line.
class facts_reader {
  public:
    facts_reader(std::string_view text, std::string source) : text_{text}, source_{std::move(source)} {}

    std::vector<service> read() {
        std::vector<service> services;
        next();
        while (!words_.empty()) {
            if (depth_ != 0 || words_.front() != "service") fail("expected a service");
            expect_words(4);
            service made{.name = words_[1], .id = words_[2], .version = words_[3], .source = source_, .line = line_};
            for (next(); depth_ == 1 && !words_.empty();) read_part(made);
            services.push_back(std::move(made));
        }
        return services;
    }

  private:
    [[noreturn]] void fail(const std::string& what, errc code = errc::invalid_value) const {
        detail::fail(code, source_, line_, "", what);
    }
    void expect_words(std::size_t count) const {
        if (words_.size() != count)
            fail("has " + std::to_string(words_.size()) + " words, expected " + std::to_string(count));
    }

    /// The next line with words in it; none at the end.
    void next() {
        words_.clear();
        while (words_.empty() && !text_.empty()) {
            ++line_;
            const auto end = std::min(text_.find('\n'), text_.size());
            auto rest = text_.substr(0, end);
            text_.remove_prefix(std::min(end + 1, text_.size()));
            depth_ = std::min(rest.find_first_not_of(' '), rest.size());
            rest.remove_prefix(depth_);
            if (rest.starts_with('#')) continue;
            while (!rest.empty()) take_word(rest);
        }
        if (words_.empty()) depth_ = 0;
    }
    void take_word(std::string_view& rest) {
        std::string word;
        bool in_quotes = false;
        std::size_t at = 0;
        for (; at != rest.size() && (in_quotes || rest[at] != ' '); ++at) {
            if (rest[at] == '"')
                in_quotes = !in_quotes;
            else if (in_quotes && rest[at] == '\\' && at + 1 != rest.size())
                word += rest[++at];
            else
                word += rest[at];
        }
        if (in_quotes) fail("a quotation mark without its second one");
        rest.remove_prefix(std::min(rest.find_first_not_of(' ', at), rest.size()));
        words_.push_back(std::move(word));
    }

    void read_part(service& made) {
        const auto word = words_.front();
        if (word == "inherits" || word == "uses") {
            expect_words(4);
            service_reference to{words_[1], words_[2], words_[3]};
            if (word == "uses")
                made.uses.push_back(std::move(to));
            else
                made.inherits = std::move(to);
            next();
        } else if (word == "input" || word == "output") {
            auto& list = word == "input" ? made.inputs : made.outputs;
            list.push_back(read_message());
        } else {
            fail("\"" + word + "\", expected inherits, uses, input or output");
        }
    }
    message read_message() {
        if (words_.size() < 3) fail("expected a name and an ID");
        message made{.name = words_[1], .id = static_cast<std::uint16_t>(number(words_[2], 16, 0xFFFF)), .line = line_};
        for (std::size_t i = 3; i != words_.size(); ++i) {
            if (words_[i] == "command")
                made.is_command = true;
            else if (words_[i] == "deprecated")
                made.is_deprecated = true;
            else
                fail("\"" + words_[i] + "\", expected command or deprecated");
        }
        next();
        if (depth_ == 2 && !words_.empty()) made.body = read_element(2);
        return made;
    }
    element read_element(std::size_t depth) {
        const auto* const known =
            std::ranges::find(kind_words, words_.front(), [](const auto& each) { return each.first; });
        if (known == kind_words.end()) fail("\"" + words_.front() + "\" is no kind of element");
        element made{.kind = known->second, .line = line_};
        std::size_t i = 1;
        if (made.kind != kind::format) {
            if (words_.size() < 2) fail("expected a name");
            made.name = words_[i++];
        }
        for (; i != words_.size(); ++i) read_fact(made, words_[i]);
        next();
        while (depth_ == depth + 1 && !words_.empty()) made.children.push_back(read_element(depth + 1));
        if (depth_ > depth + 1) fail("is too far to the right");
        const bool needs_one = made.kind == kind::list || made.kind == kind::array;
        if (needs_one && made.children.size() != 1) fail("a list or an array before this line has not one element");
        return made;
    }
    void read_fact(element& made, std::string_view fact) const {
        if (fact == "optional") {
            made.optional = true;
            return;
        }
        const auto equals = fact.find('=');
        const auto key = fact.substr(0, equals);
        const auto value = equals == fact.npos ? std::string_view{} : fact.substr(equals + 1);
        if (key == "type")
            made.type = type(value);
        else if (key == "presence")
            made.presence = type(value);
        else if (key == "unit")
            made.unit = value;
        else if (key == "format")
            made.format = value;
        else if (key == "index")
            made.index = static_cast<std::uint32_t>(number(value, 10, 255));
        else if (key == "length")
            made.max_count = number(value);
        else if (key == "size")
            made.dimensions.push_back(static_cast<std::uint32_t>(number(value, 10, 0xFFFF)));
        else if (key == "count")
            std::tie(made.min_count, made.max_count) = numbers(value);
        else if (key == "bits") {
            const auto [first, last] = numbers(value);
            made.first_bit = static_cast<std::uint32_t>(std::min<std::uint64_t>(first, 64));
            made.last_bit = static_cast<std::uint32_t>(std::min<std::uint64_t>(last, 64));
        } else if (key == "scale") {
            const auto [min, max] = halves(value);
            made.scale = {real(min), real(max)};
            if (!(made.scale->min < made.scale->max)) fail("the lower limit is not below the upper one");
        } else if (key == "value")
            made.names.push_back(named(value));
        else if (key == "range")
            made.ranges.push_back(range(value));
        else
            fail("\"" + std::string{fact} + "\" is no fact of an element");
    }

    std::uint64_t number(std::string_view digits, int base = 10, std::uint64_t most = ~std::uint64_t{}) const {
        std::uint64_t value{};
        const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
        if (error != std::errc{} || stop != digits.data() + digits.size() || value > most)
            fail("\"" + std::string{digits} + "\", expected a number up to " + std::to_string(most));
        return value;
    }
    double real(std::string_view digits) const {
        double value{};
        const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc{} || stop != digits.data() + digits.size())
            fail("\"" + std::string{digits} + "\", expected a number");
        return value;
    }
    std::pair<std::string_view, std::string_view> halves(std::string_view text) const {
        const auto dots = text.find("..");
        if (dots == text.npos) fail("\"" + std::string{text} + "\", expected two limits such as 0..255");
        return {text.substr(0, dots), text.substr(dots + 2)};
    }
    std::pair<std::uint64_t, std::uint64_t> numbers(std::string_view text) const {
        const auto [first, second] = halves(text);
        return {number(first), number(second)};
    }
    scalar type(std::string_view word) const {
        const auto* const known = std::ranges::find(type_words, word, [](const auto& each) { return each.first; });
        if (known == type_words.end()) fail("\"" + std::string{word} + "\" is no type");
        return known->second;
    }
    named_value named(std::string_view text) const {
        const auto colon = text.find(':');
        if (colon == text.npos) fail("\"" + std::string{text} + "\", expected a value and a name such as 0:Off");
        const auto digits = text.substr(0, colon);
        std::int64_t value{};
        const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc{} || stop != digits.data() + digits.size())
            fail("\"" + std::string{digits} + "\", expected a number");
        return {value, std::string{text.substr(colon + 1)}};
    }
    value_range range(std::string_view text) const {
        const bool closed = text.size() > 2 && (text.front() == '[' || text.front() == '(') &&
                            (text.back() == ']' || text.back() == ')');
        if (!closed) fail("\"" + std::string{text} + "\", expected a range such as [0..255]");
        const auto [min, max] = halves(text.substr(1, text.size() - 2));
        return {.min = real(min), .max = real(max), .with_min = text.front() == '[', .with_max = text.back() == ']'};
    }

    std::string_view text_;
    std::string source_;
    std::size_t line_{};
    std::size_t depth_{};
    std::vector<std::string> words_{};
};

} // namespace detail

inline namespace JAUSCAT_WAY {

JAUSCAT_DECL std::string write_facts(std::span<const service> services) {
    std::string out;
    for (const auto& each : services) {
        using detail::table_word;
        out += "service " + table_word(each.name) + ' ' + table_word(each.id) + ' ' + table_word(each.version) + '\n';
        if (each.inherits) detail::write_reference(out, "inherits", *each.inherits);
        for (const auto& used : each.uses) detail::write_reference(out, "uses", used);
        for (const auto& one : each.inputs) detail::write_message(out, "input", one);
        for (const auto& one : each.outputs) detail::write_message(out, "output", one);
    }
    return out;
}

JAUSCAT_DECL result<std::vector<service>, error> parse_facts(std::string_view text, std::string source) {
    return detail::caught([&] {
        auto services = detail::facts_reader{text, std::move(source)}.read();
        std::ranges::sort(services, {}, [](const service& each) { return std::tie(each.id, each.version); });
        check_services(services);
        return services;
    });
}

JAUSCAT_DECL result<std::vector<service>, error> read_facts(const std::filesystem::path& path) {
    const auto text = detail::caught([&] { return std::optional{detail::text_of(path)}; });
    if (!text) return text.error();
    return parse_facts(**text, path.string());
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::jsidl
