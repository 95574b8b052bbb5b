// Messages and types that several services of the set core have.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/ranges.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::core {

/// Values of Timeout.
enum class timeout : std::uint8_t {
    timeout_feature_disabled = 0,
};

} // namespace jauscat::sae::core
