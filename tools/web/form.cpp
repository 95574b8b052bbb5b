#include "web/form.hpp"

namespace page {

namespace {

namespace text = jauscat::text;

json names_of(std::span<const std::string_view> names) {
    json made = json::array();
    for (const auto name : names) made.push_back(std::string{name});
    return made;
}
json id_of(const void* id) { return reinterpret_cast<std::uintptr_t>(id); }
json reference_to(const text::other_member& other) {
    if (other.owner == nullptr) return nullptr;
    return {{"owner", id_of(other.owner)}, {"name", std::string{other.name}}};
}
json told(const text::form& how);

json told(const text::integer_form& is) {
    constexpr std::array meanings{"number", "enumeration", "flags", "boolean"};
    return {{"kind", meanings[static_cast<std::size_t>(is.what)]},
            {"signed", is.is_signed},
            {"bits", is.bits},
            {"unit", std::string{is.unit}},
            {"names", names_of(is.names)}};
}
json told(const text::real_form& is) { return {{"kind", "real"}, {"bits", is.bits}, {"unit", std::string{is.unit}}}; }
json told(const text::scaled_form& is) {
    return {{"kind", "scaled"}, {"bits", is.bits}, {"unit", std::string{is.unit}}, {"min", is.min}, {"max", is.max}};
}
json told(const text::octets_form& is) {
    return {{"kind", is.characters ? "text" : "bytes"}, {"least", is.least}, {"most", is.most}};
}
json told(const text::structure_form& is) { return {{"kind", "structure"}, {"of", form_of(*is.of)}}; }
json told(const text::packed_form& is) {
    return {{"kind", "packed"}, {"bits", is.bits}, {"has_notation", is.show != nullptr}};
}
json told(const text::encoded_form&) { return {{"kind", "message"}}; }
json told(const text::list_form& is) {
    return {{"kind", "list"},
            {"element", told(*is.element)},
            {"field", std::string{is.field}},
            {"least", is.least},
            {"most", is.most}};
}
json told(const text::tree_form& is) {
    return {{"kind", "tree"},
            {"element", told(*is.nodes.element)},
            {"depth", is.max_depth},
            {"children", reference_to(is.children)}};
}
json told(const text::choice_form& is) {
    json cases = json::array();
    for (const auto& one : is.cases)
        cases.push_back({{"tag", one.tag}, {"form", one.how == nullptr ? json(nullptr) : told(*one.how)}});
    return {{"kind", "choice"}, {"cases", std::move(cases)}};
}
json told(const text::variant_form& is) {
    json alternatives = json::array();
    for (const auto& one : is.alternatives)
        alternatives.push_back(
            {{"name", std::string{one.name}}, {"form", one.how == nullptr ? json(nullptr) : told(*one.how)}});
    return {{"kind", "variant"}, {"alternatives", std::move(alternatives)}};
}

json told(const text::form& how) {
    return std::visit([](const auto& is) { return told(is); }, how.is);
}

} // namespace

json form_of(const text::structure& type) {
    json members = json::array();
    for (const text::member& one : type.members) {
        if (one.what != text::member::role::value) continue;
        json made{{"name", std::string{one.name}}, {"optional", one.optional}, {"form", told(*one.how)}};
        if (one.presence_bit) made["presence_bit"] = *one.presence_bit;
        for (const auto& [name, other] : {std::pair{"gate", &one.gate}, {"counter", &one.counter}, {"tag", &one.tag}})
            if (other->owner != nullptr) made[name] = reference_to(*other);
        members.push_back(std::move(made));
    }
    return {{"id", id_of(type.id)}, {"name", std::string{type.name}}, {"members", std::move(members)}};
}

} // namespace page
