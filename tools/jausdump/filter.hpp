// Selects the messages to show.
#pragma once
#include "record.hpp"

#include <array>

namespace jausdump {

/// A JAUS ID in which parts may be left open.
struct address_pattern {
    std::array<std::optional<std::uint16_t>, 4> part{}; ///< subsystem, node, component, instance

    [[nodiscard]] bool matches(const jaus::address& id) const {
        return matches(std::array<std::uint16_t, 4>{id.subsystem, id.node, id.component, id.instance});
    }
    /// A JAUS ID of SAE has no instance: a pattern with one does not match.
    [[nodiscard]] bool matches(const sae::jaus_id& id) const {
        return !part[3] && matches(std::array<std::uint16_t, 4>{id.subsystem, id.node, id.component, 0});
    }

  private:
    [[nodiscard]] bool matches(const std::array<std::uint16_t, 4>& id) const {
        for (std::size_t i = 0; i != part.size(); ++i)
            if (part[i] && *part[i] != id[i]) return false;
        return true;
    }
};

/// Conditions that must all be met; of those of a kind, one.
struct filter {
    std::vector<std::uint16_t> codes{};
    std::vector<std::string> names{}; ///< parts of names, in snake_case
    std::vector<address_pattern> from{}, to{};

    [[nodiscard]] bool passes(const record& message) const;
};

/// `set_wrench_effort` for "Set Wrench Effort" and for "SetWrenchEffort".
std::string snake_case(std::string_view standard_name);

/// Parses the filter options; throws std::invalid_argument with the error.
std::uint16_t parse_code(const std::string& text);
std::string parse_name(const std::string& text);
address_pattern parse_pattern(const std::string& text);

} // namespace jausdump
