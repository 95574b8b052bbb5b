// Finds the values of a message that its standard does not define: those outside their value sets.
#pragma once
#include <jauscat/text/structure.hpp>

namespace jauscat::text {

namespace detail {

class value_set_walk {
  public:
    void fields(const structure& type, const void* object, const scope* outer, const std::string& path) {
        const scope here{type.id, object, outer};
        for (std::size_t i = 0; i != type.members.size(); ++i) {
            const member& one = type.members[i];
            const std::string name = path + std::string{one.name};
            if (one.what == member::role::count) {
                const bool is_there = type.members[i + 1].find(object) != nullptr;
                if (is_there && is_outside(std::get<integer_form>(one.how->is), one.number(object)))
                    found_.push_back(name);
            } else if (one.what == member::role::value) {
                const void* const at = one.find(object);
                const bool is_choice = std::holds_alternative<choice_form>(one.how->is);
                if (at == nullptr) continue;
                const held_case held = is_choice ? case_of(one, at, &here) : held_case{one.how, at, true};
                if (held.how != nullptr) value(*held.how, held.at, here, name);
            }
        }
    }
    [[nodiscard]] std::vector<std::string> found() && { return std::move(found_); }

  private:
    void value(const form& how, const void* at, const scope& here, const std::string& name) {
        std::visit(
            [&](const auto& is) {
                if constexpr (requires { held(is, at, here, name); }) held(is, at, here, name);
            },
            how.is);
    }
    void held(const integer_form& is, const void* at, const scope&, const std::string& name) {
        if (is_outside(is, is.get(at))) found_.push_back(name);
    }
    void held(const structure_form& is, const void* at, const scope& here, const std::string& name) {
        fields(*is.of, at, &here, name + ".");
    }
    void held(const packed_form& is, const void* at, const scope& here, const std::string& name) {
        fields(*is.of, at, &here, name + ".");
    }
    void held(const variant_form& is, const void* at, const scope& here, const std::string& name) {
        const alternative& one = is.alternatives[is.index(at)];
        if (one.how != nullptr) value(*one.how, is.get(at), here, name);
    }
    void held(const list_form& is, const void* at, const scope& here, const std::string& name) {
        const auto* element = static_cast<const std::byte*>(is.first(at));
        for (std::size_t i = 0; i != is.size(at); ++i, element += is.stride)
            value(*is.element, element, here, name + "[" + std::to_string(i) + "]");
    }
    void held(const tree_form& is, const void* at, const scope& here, const std::string& name) {
        held(is.nodes, at, here, name);
    }

    std::vector<std::string> found_;
};

} // namespace detail

/// The paths of all such values: `object[2].type`.
[[nodiscard]] inline std::vector<std::string> outside_values(const structure& type, const void* object) {
    detail::value_set_walk walk;
    walk.fields(type, object, nullptr, {});
    return std::move(walk).found();
}

} // namespace jauscat::text
