// Copies a command's fields into the report with the same fields.
#pragma once
#include <jauscat/wire/layout.hpp>

namespace jauscat::jaus {

/// Copies each optional field that `from` carries into the field of the same name in `to`; the others keep their value.
/// Both messages, or their raws, must have the same fields in the same order, such as Set and Report Wrench Effort.
template <wire::message From, wire::message To> constexpr void copy_present(const From& from, To& to) noexcept {
    [&]<auto... Source, auto... Target>(wire::key_list<Source...>, wire::key_list<Target...>) {
        static_assert(((wire::name_of<Source>() == wire::name_of<Target>()) && ...),
                      "copy_present: the messages do not have the same fields");
        const auto copy = [](const auto& source, auto& target) {
            if (source) target = source;
        };
        (copy(wire::member_of<Source>(from), wire::member_of<Target>(to)), ...);
    }(typename wire::layout_of<From>::keys{}, typename wire::layout_of<To>::keys{});
}

} // namespace jauscat::jaus
