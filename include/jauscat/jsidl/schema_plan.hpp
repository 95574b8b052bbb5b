// The types of a set of services: which there are, how they are called, and in which header each one stands.
#pragma once
#include <jauscat/jsidl/check.hpp>
#include <jauscat/jsidl/names.hpp>
#include <jauscat/jsidl/service.hpp>
#include <jauscat/jsidl/source.hpp>
#include <jauscat/text/quoted.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace jauscat::jsidl::detail {

enum class role : std::uint8_t { structure, enumeration };

/// A type that a message has beside its own.
struct part {
    const element* of{};
    detail::role role{};
    std::string base{};                 ///< its name, if no other type has it
    std::vector<std::string> context{}; ///< the service, the message, then the elements around it
    element shape{};                    ///< what makes it the same type as another one
    std::vector<part*> parts{};         ///< the types that it needs
    std::size_t level{};                ///< how much of the context is in the name

    /// Level 1 is the service, for types that several of its messages have; then the message and what is around it.
    [[nodiscard]] std::string name() const {
        if (level == 0) return base;
        if (level == 1) return context.front() + '_' + base;
        std::string made;
        for (std::size_t i = 1; i != level; ++i) made += context[i] + '_';
        return made + base;
    }
};

struct planned_message {
    const message* of{};
    std::string name{};
    std::vector<const service*> inputs{};  ///< the services that receive it
    std::vector<const service*> outputs{}; ///< the services that send it
    std::vector<part*> parts{};
    std::string file{};
};

/// A member's name. `owner` is the structure that it is in.
inline std::string member_name(const element& of, std::string_view owner = {}) {
    auto name = identifier(of.name, "field");
    return name == "schema" || name == owner ? name + "_field" : name;
}

/// The smallest unsigned type for a number of bits.
constexpr scalar unsigned_of(std::size_t bits) noexcept {
    return bits <= 8 ? scalar::u8 : bits <= 16 ? scalar::u16 : bits <= 32 ? scalar::u32 : scalar::u64;
}
constexpr std::size_t width_of(const element& bit_part) noexcept {
    return bit_part.last_bit - bit_part.first_bit + std::size_t{1};
}

/// The services of one set.
class schema_plan {
  public:
    static constexpr std::string_view shared_file = "shared";

    schema_plan(std::string set_name, std::vector<const service*> of)
        : set{std::move(set_name)}, services{std::move(of)} {
        for (const auto* const one : services) {
            const auto stem = file_of(*one);
            if (stem == shared_file || !files_.insert(stem).second)
                fail(errc::duplicate, one->source, one->line, "service_def",
                     "the name " + text::quoted(one->name) + " makes the header " + stem +
                         ".hpp, which there is already");
            for (const auto& each : one->inputs) add(each).inputs.push_back(one);
            for (const auto& each : one->outputs) add(each).outputs.push_back(one);
        }
        for (auto& each : messages) {
            each.file = file_of(each);
            if (each.of->body) collect(*each.of->body, each.parts, {each.file, each.name}, true);
        }
        separate_names();
        for (const auto& each : messages)
            for (auto* const one : each.parts) place(*one, each.file);
    }
    schema_plan(const schema_plan&) = delete;
    schema_plan& operator=(const schema_plan&) = delete;

    static std::string file_of(const service& one) { return identifier(one.name, "service"); }

    /// The type of an element. All elements of one type have the same part.
    [[nodiscard]] const part& type_of(const element& of, role as) const {
        return *first_.at(by_element_.at({&of, as})->name());
    }
    /// The header of a type.
    [[nodiscard]] std::string file_of(const part& one) const {
        const auto& users = users_.at(one.name());
        return users.size() == 1 ? *users.begin() : std::string{shared_file};
    }
    [[nodiscard]] bool is_type(const std::string& name) const {
        return first_.contains(name) || std::ranges::find(messages, name, &planned_message::name) != messages.end();
    }
    [[nodiscard]] bool has_shared() const {
        return std::ranges::any_of(messages, [](const auto& each) { return each.file == shared_file; }) ||
               std::ranges::any_of(users_, [](const auto& each) { return each.second.size() != 1; });
    }
    [[nodiscard]] const planned_message& planned(const message& of) const {
        return *std::ranges::find(messages, of.id, [](const auto& each) { return each.of->id; });
    }

    std::string set;
    std::vector<const service*> services;
    std::deque<planned_message> messages{};

  private:
    planned_message& add(const message& each) {
        const auto known = std::ranges::find(messages, each.id, [](const auto& one) { return one.of->id; });
        if (known != messages.end()) return *known;
        return messages.emplace_back(planned_message{.of = &each, .name = identifier(each.name, "message")});
    }
    static std::string file_of(const planned_message& each) {
        const auto* const first = each.inputs.empty() ? each.outputs.front() : each.inputs.front();
        const auto is_other = [&](const service* one) { return one != first; };
        const bool is_shared =
            std::ranges::any_of(each.inputs, is_other) || std::ranges::any_of(each.outputs, is_other);
        return is_shared ? std::string{shared_file} : file_of(*first);
    }

    /// The members of a structure that is made for an element.
    static std::vector<std::string> members_of(const element& of) {
        switch (of.kind) {
        case kind::list: return {"elements"};
        case kind::variant: return {"value"};
        case kind::choice: return {"index", "value"};
        case kind::formatted_blob: return {"format", "data"};
        default: break;
        }
        std::vector<std::string> names;
        for (const auto& each : of.children) names.push_back(identifier(each.name, "field"));
        return names;
    }
    static std::string structure_name(const element& of) {
        auto name = identifier(of.name, "type");
        const auto members = members_of(of);
        if (std::ranges::find(members, name) == members.end()) return name;
        switch (of.kind) {
        case kind::record: return name + "_record";
        case kind::sequence: return name + "_sequence";
        case kind::bits: return name + "_bits";
        default: return name + "_value";
        }
    }

    part& add_part(const element& of, role as, std::string base, element shape, std::vector<part*>& into,
                   const std::vector<std::string>& context) {
        auto& made = parts_.emplace_back(
            part{.of = &of, .role = as, .base = std::move(base), .context = context, .shape = std::move(shape)});
        by_element_.emplace(std::pair{&of, as}, &made);
        into.push_back(&made);
        return made;
    }
    void add_enumeration(const element& of, std::string base, scalar type, std::vector<named_value> values,
                         std::vector<part*>& into, const std::vector<std::string>& context) {
        element shape{.kind = kind::number, .type = type, .names = std::move(values)};
        add_part(of, role::enumeration, std::move(base), std::move(shape), into, context);
    }
    part& add_structure(const element& of, std::vector<part*>& into, const std::vector<std::string>& context) {
        element shape = of;
        shape.optional = false;
        return add_part(of, role::structure, structure_name(of), std::move(shape), into, context);
    }

    /// The types for an element. `is_body`: the message's own structure has its members.
    void collect(const element& of, std::vector<part*>& into, std::vector<std::string> context, bool is_body = false) {
        const auto name = identifier(of.name, "type");
        switch (of.kind) {
        case kind::number:
            if (!of.names.empty()) add_enumeration(of, name, of.type, of.names, into, context);
            return;
        case kind::bit_part:
            if (!of.names.empty()) add_enumeration(of, name, unsigned_of(width_of(of)), of.names, into, context);
            return;
        case kind::bits:
        case kind::choice:
        case kind::formatted_blob: break;
        case kind::variant:
            if (!of.children.empty()) return collect_alternatives(of, into, std::move(context));
            break;
        case kind::record:
        case kind::sequence:
            if (is_body) return collect_children(of, into, context);
            break;
        case kind::list: return collect_element(of, into, std::move(context));
        default: return;
        }
        auto& made = add_structure(of, into, context);
        context.push_back(name);
        if (of.kind == kind::choice)
            add_enumeration(of, name + "_form", scalar::u8, indices(of, &element::name), made.parts, context);
        else if (of.kind == kind::formatted_blob)
            add_enumeration(of, name + "_format", scalar::u8, indices(of, &element::format), made.parts, context);
        else
            collect_children(of, made.parts, context);
    }
    void collect_children(const element& of, std::vector<part*>& into, const std::vector<std::string>& context) {
        for (const auto& each : of.children) collect(each, into, context);
    }
    void collect_element(const element& list, std::vector<part*>& into, std::vector<std::string> context) {
        context.push_back(identifier(list.name, "type"));
        collect_inner(list.children.front(), into, context);
    }
    void collect_alternatives(const element& variant, std::vector<part*>& into, std::vector<std::string> context) {
        context.push_back(identifier(variant.name, "type"));
        for (const auto& each : variant.children) collect_inner(each, into, context);
    }
    /// An element of a list or an alternative: a list or variant needs a structure there.
    void collect_inner(const element& of, std::vector<part*>& into, const std::vector<std::string>& context) {
        if (of.kind == kind::list)
            collect_element(of, add_structure(of, into, context).parts, context);
        else if (of.kind == kind::variant && !of.children.empty())
            collect_alternatives(of, add_structure(of, into, context).parts, context);
        else
            collect(of, into, context);
    }
    static std::vector<named_value> indices(const element& of, std::string element::* name) {
        std::vector<named_value> made;
        for (const auto& each : of.children) made.push_back({each.index, each.*name});
        return made;
    }

    /// A name for each type: with more of the context where types that differ would have the same.
    void separate_names() {
        for (bool again = true; again;) {
            again = false;
            std::map<std::string, std::vector<part*>> by_name;
            for (auto& each : parts_) by_name[each.name()].push_back(&each);
            for (const auto& named : by_name) {
                const auto& name = named.first;
                const auto& same = named.second;
                const bool is_message =
                    std::ranges::find(messages, name, &planned_message::name) != messages.end() || name == "services";
                const auto differs = [&](const part* each) {
                    return each->role != same.front()->role || !(each->shape == same.front()->shape);
                };
                if (!is_message && std::ranges::none_of(same, differs)) continue;
                for (auto* const each : same) {
                    if (each->level == each->context.size())
                        fail(errc::duplicate, services.front()->source, each->of->line, name_of(each->of->kind),
                             each->of->name + ": another definition makes the same name, " + name);
                    ++each->level;
                }
                again = true;
            }
        }
        for (auto& each : parts_) first_.emplace(each.name(), &each);
    }
    void place(const part& one, const std::string& file) {
        users_[one.name()].insert(file);
        for (const auto* const inner : first_.at(one.name())->parts) place(*inner, file);
    }

    std::deque<part> parts_{};
    std::map<std::pair<const element*, role>, part*> by_element_{};
    std::map<std::string, const part*> first_{};
    std::map<std::string, std::set<std::string>> users_{};
    std::set<std::string> files_{};
};

} // namespace jauscat::jsidl::detail
