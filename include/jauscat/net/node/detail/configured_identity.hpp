// Identification of a component from the configuration.
#pragma once

#include <jauscat/jaus/component/described_component.hpp>
#include <jauscat/net/config/jaus_config.hpp>

#include <string_view>

namespace jauscat::net::detail {

/// A text, cut to the limit of Report Identification.
inline std::string_view in_report(std::string_view text) noexcept { return text.substr(0, 80); }

/// `unnamed` with the name and the authority of the component in `config`. Refers to `config`.
inline jaus::identity identity_of(const jaus_config& config, const jaus::address& component,
                                  jaus::identity unnamed) noexcept {
    for (const auto& system : config.systems)
        for (const auto& entry : system.components)
            if (entry.id == component) {
                if (!entry.name.empty()) unnamed.identification = in_report(entry.name);
                unnamed.authority_code = entry.authority;
            }
    return unnamed;
}

} // namespace jauscat::net::detail
