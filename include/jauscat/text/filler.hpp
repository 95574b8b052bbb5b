// Fills a message from parsed input. Missing or invalid fields are errors. Counts and flags are derived from the
// content.
#pragma once
#include <jauscat/text/fill_value.hpp>
#include <jauscat/text/inconsistency.hpp>

namespace jauscat::text::detail {

class filler {
  public:
    explicit filler(wire::arena& memory) : memory_{memory} {}

    /// Fills a value-initialised object.
    [[nodiscard]] result<void, error> fill(const structure& type, void* object, const input& in) {
        static const input empty{.what = input::kind::object};
        if (!fields(type, object, in.what == input::kind::nothing ? empty : in, nullptr)) return wrong_;
        return inconsistency{}.find(type, object);
    }

  private:
    struct frame {
        const structure& type;
        void* object;
        const input& in;
        const frame* outer;
        std::vector<std::string_view>& filled; // counters that follow from lists
    };

    /// Adds the field to an error that names none.
    bool fail(error why) {
        wrong_ = std::move(why);
        wrong_.field = path_;
        if (!path_.empty()) wrong_.message = path_ + " " + wrong_.message;
        return false;
    }
    bool fail(errc code, const std::string& why) { return fail({.code = code, .message = why}); }
    /// Enters the next level of the path that errors name.
    bool inside(const std::string& step, auto&& go) {
        const std::size_t size = path_.size();
        if (!path_.empty() && step.front() != '[') path_ += '.';
        path_ += step;
        const bool done = go();
        path_.resize(size);
        return done;
    }
    bool said(const result<void, error>& done) { return done || fail(done.error()); }

    /// `more` may be in the input beside the fields; the counters `filled` are known without it.
    bool fields(const structure& type, void* object, const input& in, const frame* outer, std::string_view more = {},
                std::vector<std::string_view> filled = {}) {
        if (in.what != input::kind::object) return fail(not_a("is a structure with fields"));
        if (!known_names(type, in, more)) return false;
        const frame here{type, object, in, outer, filled};
        std::optional<std::uint64_t> mask;
        std::size_t bit = 0;
        for (std::size_t i = 0; i != type.members.size(); ++i) {
            const member& one = type.members[i];
            const input* const part = in.find(one.name);
            const auto step = [&](auto&& go) { return inside(std::string{one.name}, go); };
            bool done = true;
            switch (one.what) {
            case member::role::presence_vector:
                if (part != nullptr) done = step([&] { return number(one, *part, mask.emplace()); });
                break;
            case member::role::flag:
                if (part != nullptr)
                    done = step([&] { return value(*one.how, one.make(object), *part, here); });
                else if (mask)
                    std::get<integer_form>(one.how->is).set(one.make(object), *mask >> bit & 1u);
                break;
            case member::role::constant:
            case member::role::not_on_wire: break;
            case member::role::count:
                if (const input* const list = in.find(type.members[i + 1].name); part != nullptr && list == nullptr) {
                    std::uint64_t zero{};
                    done = step([&] {
                        return number(one, *part, zero) &&
                               (zero == 0 ||
                                fail(errc::inconsistent, "is " + std::to_string(zero) + ", but there is no " +
                                                             std::string{type.members[i + 1].name}));
                    });
                    if (done) done = empty_list(type.members[i + 1], here);
                }
                break;
            case member::role::value:
                done = part != nullptr ? step([&] { return given(one, *part, here); }) : absent(one, here);
                break;
            }
            if (!done) return false;
            if (mask && (one.what == member::role::flag || (one.optional && one.gate.owner == nullptr))) ++bit;
        }
        return complete(here) && counted(here) && (!mask || announced(here, *mask));
    }

    bool known_names(const structure& type, const input& in, std::string_view more) {
        std::vector<std::string_view> names;
        for (const member& one : type.members)
            if (one.what != member::role::constant) names.push_back(one.name);
        for (const input& part : in.parts) {
            if (part.what == input::kind::nothing || part.name == more) continue;
            if (std::ranges::find(names, part.name) != names.end()) continue;
            fail(errc::unknown_field, (path_.empty() ? "there is no field '" : "has no field '") + part.name + "'" +
                                          suggestion(part.name, names));
            wrong_.field += (path_.empty() ? "" : ".") + part.name;
            return false;
        }
        return true;
    }

    /// A count or a presence vector.
    bool number(const member& one, const input& part, std::uint64_t& found) {
        if (part.what != input::kind::leaf) return fail(not_single());
        const auto scanned = scan_bits(part.text, false, std::get<integer_form>(one.how->is).bits, {});
        found = scanned.value_or(0);
        return scanned || fail(scanned.error());
    }

    bool given(const member& one, const input& part, const frame& here) {
        void* const at = one.make(here.object);
        if (!(std::holds_alternative<choice_form>(one.how->is) ? choice(one, at, part, here)
                                                               : value(*one.how, at, part, here)))
            return false;
        follow(one, here);
        return true;
    }
    bool absent(const member& one, const frame& here) {
        if (one.optional) return true;
        if (const auto* const list = std::get_if<list_form>(&one.how->is); list != nullptr && list->least == 0)
            return empty_list(one, here);
        const auto* const integer = std::get_if<integer_form>(&one.how->is);
        if (integer != nullptr && integer->what == integer_form::meaning::number) return true; // see complete
        if (std::holds_alternative<choice_form>(one.how->is)) {
            void* const at = one.make(here.object);
            const choice_case* const one_case = selected(one, here);
            if (one_case != nullptr && one_case->how == nullptr) return one_case->make(at) != nullptr;
        }
        return missing(one);
    }
    bool missing(const member& one) {
        return inside(std::string{one.name}, [&] { return fail(errc::missing_field, "is missing"); });
    }
    bool empty_list(const member& one, const frame& here) {
        one.make(here.object);
        follow(one, here);
        return true;
    }
    /// Integers that are there neither in the input nor because a list has so many elements.
    bool complete(const frame& here) {
        for (const member& one : here.type.members) {
            if (one.what != member::role::value || one.optional) continue;
            const auto* const integer = std::get_if<integer_form>(&one.how->is);
            if (integer == nullptr || integer->what != integer_form::meaning::number) continue;
            if (here.in.find(one.name) == nullptr && std::ranges::find(here.filled, one.name) == here.filled.end())
                return missing(one);
        }
        return true;
    }
    /// Counts that were given along with what they count.
    bool counted(const frame& here) {
        for (std::size_t i = 0; i != here.type.members.size(); ++i) {
            const member& one = here.type.members[i];
            const input* const part = here.in.find(one.name);
            if (one.what != member::role::count || part == nullptr) continue;
            std::uint64_t found{};
            if (!inside(std::string{one.name}, [&] {
                    if (!number(one, *part, found)) return false;
                    const std::uint64_t size = one.number(here.object);
                    return found == size || fail(errc::inconsistent, "is " + std::to_string(found) + ", but " +
                                                                         std::string{here.type.members[i + 1].name} +
                                                                         " has " + std::to_string(size));
                }))
                return false;
        }
        return true;
    }
    bool announced(const frame& here, std::uint64_t mask) {
        for (const member& one : here.type.members)
            if (one.what == member::role::presence_vector && one.number(here.object) != mask)
                return inside("presence_vector", [&] {
                    const std::size_t digits = std::get<integer_form>(one.how->is).bits / 4;
                    return fail(errc::inconsistent, "is " + hex_number(mask, digits) +
                                                        ", but the fields that are there make " +
                                                        hex_number(one.number(here.object), digits));
                });
        return true;
    }

    /// The structure around that a member elsewhere belongs to.
    static const frame* owner(const other_member& other, const frame& here) {
        const frame* around = &here;
        while (around != nullptr && around->type.id != other.owner) around = around->outer;
        return around;
    }
    /// Sets what a member that is there implies elsewhere, unless it was given.
    static void follow(const member& one, const frame& here) {
        if (one.gate.owner != nullptr) {
            const frame* const of = owner(one.gate, here);
            if (of != nullptr && of->in.find(one.gate.name) == nullptr && of->in.find("presence_vector") == nullptr)
                one.gate.set(of->object, 1);
        }
        if (one.counter.owner != nullptr) {
            const frame* const of = owner(one.counter, here);
            if (of == nullptr || of->in.find(one.counter.name) != nullptr) return;
            if (std::ranges::find(of->filled, one.counter.name) != of->filled.end()) return;
            one.counter.set(of->object, size_of(*one.how, one.find(here.object)) + one.counter_excess);
            of->filled.push_back(one.counter.name);
        }
    }

    const choice_case* selected(const member& one, const frame& here) {
        const frame* const of = owner(one.tag, here);
        if (of == nullptr) return nullptr;
        const std::uint64_t tag = one.tag.get(of->object);
        const auto cases = std::get<choice_form>(one.how->is).cases;
        const auto found = std::ranges::find(cases, tag, &choice_case::tag);
        return found == cases.end() ? nullptr : &*found;
    }
    bool choice(const member& one, void* at, const input& part, const frame& here) {
        const choice_case* const found = selected(one, here);
        if (found == nullptr) return fail(errc::inconsistent, "has no form for this " + std::string{one.tag.name});
        void* const inner = found->make(at);
        if (found->how == nullptr)
            return (part.what == input::kind::object && part.parts.empty()) ||
                   fail(errc::inconsistent, "has no value for this " + std::string{one.tag.name});
        const input* held = &part;
        if (!std::holds_alternative<structure_form>(found->how->is) && part.what == input::kind::object) {
            held = part.find("value");
            if (held == nullptr || part.parts.size() != 1) return fail(not_single());
        }
        return value(*found->how, inner, *held, here);
    }

    bool value(const form& how, void* at, const input& in, const frame& here) {
        return std::visit(
            [&](const auto& is) {
                if constexpr (requires { fill_value(is, at, in, memory_); })
                    return said(fill_value(is, at, in, memory_));
                else
                    return told(is, at, in, here);
            },
            how.is);
    }
    bool told(const structure_form& is, void* at, const input& in, const frame& here) {
        return fields(*is.of, at, in, &here);
    }
    bool told(const packed_form& is, void* at, const input& in, const frame& here) {
        return in.what == input::kind::object ? fields(*is.of, at, in, &here) : said(fill_value(is, at, in));
    }
    bool told(const list_form& is, void* at, const input& in, const frame& here) {
        if (in.what != input::kind::array) return fail(not_a("is a list"));
        if (in.parts.size() > is.most)
            return fail(errc::wrong_size, "has " + std::to_string(in.parts.size()) + " elements, must have at most " +
                                              std::to_string(is.most));
        if (in.parts.size() < is.least)
            return fail(errc::wrong_size,
                        "has " + std::to_string(in.parts.size()) + " elements, must have " + std::to_string(is.least));
        if (in.parts.empty()) return true;
        auto* const first = static_cast<std::byte*>(is.resize(at, in.parts.size(), memory_));
        if (first == nullptr) return fail(no_capacity());
        for (std::size_t i = 0; i != in.parts.size(); ++i)
            if (!inside("[" + std::to_string(i) + "]",
                        [&] { return element(is, first + i * is.stride, in.parts[i], here); }))
                return false;
        return true;
    }
    bool element(const list_form& is, void* at, const input& in, const frame& here) {
        if (in.what == input::kind::nothing) return fail(errc::missing_field, "is missing");
        if (is.field.empty() || in.what == input::kind::leaf) return value(*is.element, at, in, here);
        const input* const part = in.find(is.field);
        if (part == nullptr || in.parts.size() != 1)
            return fail(errc::wrong_kind, "has one field, " + std::string{is.field});
        return inside(std::string{is.field}, [&] { return value(*is.element, at, *part, here); });
    }
    bool told(const tree_form& is, void* at, const input& in, const frame& here) {
        const std::size_t nodes = nodes_of(in, 1, is.max_depth);
        if (nodes == 0) return fail(errc::too_deep, "has more than " + std::to_string(is.max_depth) + " levels");
        auto* next = static_cast<std::byte*>(is.nodes.resize(at, nodes, memory_));
        if (next == nullptr) return fail(no_capacity());
        return node(is, next, in, here);
    }
    /// How many there are; 0 where they are too deep.
    static std::size_t nodes_of(const input& in, std::size_t depth, std::size_t max_depth) {
        if (depth > max_depth) return 0;
        std::size_t total = 1;
        if (const input* const children = in.find("child"))
            for (const input& child : children->parts) {
                const std::size_t below = nodes_of(child, depth + 1, max_depth);
                if (below == 0) return 0;
                total += below;
            }
        return total;
    }
    bool node(const tree_form& is, std::byte*& next, const input& in, const frame& here) {
        void* const at = next;
        next += is.nodes.stride;
        const input* const children = in.find("child");
        if (children != nullptr && children->what != input::kind::array)
            return inside("child", [&] { return fail(not_a("is a list")); });
        const std::size_t count = children == nullptr ? 0 : children->parts.size();
        is.children.set(at, count);
        const structure& type = *std::get<structure_form>(is.nodes.element->is).of;
        if (!fields(type, at, in, &here, "child", {is.children.name})) return false;
        if (is.children.get(at) != count)
            return inside(std::string{is.children.name}, [&] {
                return fail(errc::inconsistent,
                            "is " + std::to_string(is.children.get(at)) + ", but child has " + std::to_string(count));
            });
        for (std::size_t i = 0; i != count; ++i)
            if (!inside("child[" + std::to_string(i) + "]", [&] { return node(is, next, children->parts[i], here); }))
                return false;
        return true;
    }
    /// An object of one member, which is named after the alternative; its name alone where it has no fields.
    bool told(const variant_form& is, void* at, const input& in, const frame& here) {
        static const input no_fields{.what = input::kind::object};
        const bool named_only = in.what == input::kind::leaf;
        const input* held = nullptr;
        for (const input& part : in.parts)
            if (part.what != input::kind::nothing) {
                if (held != nullptr) return fail(errc::wrong_kind, "has more than one alternative");
                held = &part;
            }
        if (!named_only && (in.what != input::kind::object || held == nullptr))
            return fail(not_a("is one of several structures: an object with the name of one of them"));
        const std::string& name = named_only ? in.text : held->name;
        const auto found = std::ranges::find(is.alternatives, name, &alternative::name);
        if (found == is.alternatives.end()) {
            std::vector<std::string_view> names;
            for (const alternative& one : is.alternatives) names.push_back(one.name);
            return fail(errc::unknown_field, "has no alternative '" + name + "'" + suggestion(name, names));
        }
        void* const made = is.make(at, static_cast<std::size_t>(found - is.alternatives.begin()));
        if (found->how == nullptr) return true;
        return inside(std::string{found->name},
                      [&] { return value(*found->how, made, named_only ? no_fields : *held, here); });
    }
    bool told(const choice_form&, void*, const input&, const frame&) {
        return fail(errc::inconsistent, "has no form");
    } // see choice

    wire::arena& memory_;
    std::string path_;
    error wrong_;
};

} // namespace jauscat::text::detail
