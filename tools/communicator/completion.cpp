#include "completion.hpp"

#include "support/known_messages.hpp"
#include <jauscat/text/structure.hpp>

#include <algorithm>
#include <variant>

namespace {

namespace text = jauscat::text;
using words = std::vector<std::string>;

words split_at_spaces(std::string_view line) {
    words all{{}};
    for (const char c : line) {
        if (c != ' ')
            all.back() += c;
        else if (!all.back().empty())
            all.emplace_back();
    }
    return all;
}

/// Calls use(path, form) for the single values of a message: pose[0].pose_time. Elements have the number 0.
void each_value(const text::structure& type, const std::string& before, const auto& use);
void each_value(const text::form& how, const std::string& path, const auto& use) {
    if (const auto* const record = std::get_if<text::structure_form>(&how.is); record != nullptr) {
        each_value(*record->of, path + ".", use);
    } else if (const auto* const list = std::get_if<text::list_form>(&how.is); list != nullptr) {
        each_value(*list->element, path + "[0]" + (list->field.empty() ? "" : "." + std::string{list->field}), use);
    } else if (const auto* const variant = std::get_if<text::variant_form>(&how.is); variant != nullptr) {
        for (const auto& one : variant->alternatives)
            if (one.how != nullptr) each_value(*one.how, path + "." + std::string{one.name}, use);
    } else if (!std::holds_alternative<text::tree_form>(how.is)) { // its nodes nest without end
        use(path, how);
    }
}
void each_value(const text::structure& type, const std::string& before, const auto& use) {
    for (const text::member& one : type.members)
        if (one.what == text::member::role::value && one.how != nullptr)
            each_value(*one.how, before + std::string{one.name}, use);
}

/// The path with the elements' numbers that were typed: `pose[0].pose_time` for `pose[3].po` is `pose[3].pose_time`.
std::string with_numbers_of(std::string_view typed, std::string path) {
    std::size_t at = 0;
    for (auto open = typed.find('['); open != std::string_view::npos; open = typed.find('[', open + 1)) {
        const auto close = typed.find(']', open);
        at = path.find("[0]", at);
        if (close == std::string_view::npos || at == std::string::npos) break;
        path.replace(at, 3, typed.substr(open, close - open + 1));
        at += close - open + 1;
    }
    return path;
}

words fields(const words& line) {
    const auto& typed = line.back();
    const auto known = example::known_messages().find(std::string_view{line[2]});
    if (!known) return {};
    words all;
    const auto is_given = [&](const std::string& path) {
        return std::any_of(line.begin() + 3, line.end() - 1,
                           [&](const auto& word) { return word.starts_with(path + "="); });
    };
    each_value((*known)->fields(), "", [&](const std::string& path, const text::form& how) {
        const auto named = with_numbers_of(typed, path);
        if (!typed.starts_with(named + "=")) {
            if (!is_given(named)) all.push_back(named + "=");
        } else if (const auto* const integer = std::get_if<text::integer_form>(&how.is); integer != nullptr) {
            for (const auto name : integer->names)
                if (!name.empty()) all.push_back(named + "=" + std::string{name} + " ");
        }
    });
    return all;
}

words possible(const words& line, const words& destinations) {
    if (line.size() == 1) return {"acknowledge ", "exit ", "help ", "log ", "peers ", "quit ", "send ", "wait "};
    if (line.front() == "log" || line.front() == "acknowledge")
        return line.size() == 2 ? words{"off ", "on "} : words{};
    words all;
    if (line.front() != "send") return all;
    if (line.size() == 2)
        for (const auto& one : destinations) all.push_back(one + " ");
    else if (line.size() == 3)
        for (const auto& one : example::known_messages()) all.push_back(std::string{one.name()} + " ");
    else
        all = fields(line);
    return all;
}

} // namespace

words completions(std::string_view line, const words& destinations) {
    const auto typed = split_at_spaces(line);
    auto all = possible(typed, destinations);
    std::erase_if(all, [&](const auto& one) { return !one.starts_with(typed.back()); });
    return all;
}
