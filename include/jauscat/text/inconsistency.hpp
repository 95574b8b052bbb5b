// Checks members that depend on each other across structures: counts, flags, type codes.
#pragma once
#include <jauscat/text/error.hpp>
#include <jauscat/text/structure.hpp>

namespace jauscat::text::detail {

/// How many elements or octets a value has.
inline std::size_t size_of(const form& how, const void* at) {
    if (const auto* const list = std::get_if<list_form>(&how.is)) return list->size(at);
    if (const auto* const octets = std::get_if<octets_form>(&how.is)) return octets->get(at).size();
    return 0;
}

/// Walks over a message and returns the first contradiction.
class inconsistency {
  public:
    [[nodiscard]] result<void, error> find(const structure& type, const void* object) {
        fields(type, object, nullptr, {});
        return std::move(found_);
    }

  private:
    void blame(const std::string& name, const std::string& why) {
        found_ = {.code = errc::inconsistent, .field = name, .message = name + why};
    }
    void fields(const structure& type, const void* object, const scope* outer, const std::string& path) {
        const scope here{type.id, object, outer};
        for (const member& one : type.members) {
            if (found_.code != errc::ok || one.what != member::role::value) continue;
            const void* const at = one.find(object);
            const std::string name = path + std::string{one.name};
            if (one.gate.owner != nullptr) {
                const bool announced = value_of(one.gate, here) != 0;
                if (announced && at == nullptr)
                    blame(name, " is missing, although " + std::string{one.gate.name} + " is set");
                if (!announced && at != nullptr)
                    blame(name, " is there, although " + std::string{one.gate.name} + " is not set");
            }
            if (at == nullptr || found_.code != errc::ok) continue;
            if (one.counter.owner != nullptr) {
                const std::uint64_t count = value_of(one.counter, here);
                const std::size_t size = size_of(*one.how, at);
                if (size != (count < one.counter_excess ? 0 : count - one.counter_excess))
                    blame(name, " has " + std::to_string(size) + ", but " + std::string{one.counter.name} + " is " +
                                    std::to_string(count));
            }
            value(one, at, here, name);
        }
    }
    void value(const member& one, const void* at, const scope& here, const std::string& name) {
        if (const auto* const inner = std::get_if<structure_form>(&one.how->is))
            fields(*inner->of, at, &here, name + ".");
        else if (const auto* const variant = std::get_if<variant_form>(&one.how->is))
            alternative_of(*variant, at, here, name);
        else if (const auto* const list = std::get_if<list_form>(&one.how->is))
            elements(*list, at, here, name);
        else if (const auto* const tree = std::get_if<tree_form>(&one.how->is))
            elements(tree->nodes, at, here, name);
    }
    void alternative_of(const variant_form& variant, const void* at, const scope& here, const std::string& name) {
        const alternative& held = variant.alternatives[variant.index(at)];
        if (held.how == nullptr) return;
        if (const auto* const inner = std::get_if<structure_form>(&held.how->is))
            fields(*inner->of, variant.get(at), &here, name + "." + std::string{held.name} + ".");
    }
    void elements(const list_form& list, const void* at, const scope& here, const std::string& name) {
        const auto* const inner = std::get_if<structure_form>(&list.element->is);
        if (inner == nullptr) return;
        const auto* element = static_cast<const std::byte*>(list.first(at));
        for (std::size_t i = 0; i != list.size(at); ++i, element += list.stride)
            fields(*inner->of, element, &here,
                   name + "[" + std::to_string(i) + "]." + (list.field.empty() ? "" : std::string{list.field} + "."));
    }
    static std::uint64_t value_of(const other_member& other, const scope& here) {
        const scope* around = &here;
        while (around != nullptr && around->id != other.owner) around = around->outer;
        return around == nullptr ? 0 : other.get(around->object);
    }

    error found_;
};

} // namespace jauscat::text::detail
