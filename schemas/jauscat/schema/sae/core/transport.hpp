// Transport 1.1, urn:jaus:jss:core:Transport.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/core/shared.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::core {

namespace services {

/// Transport: what it is called, and its messages.
struct transport {
    static constexpr std::string_view name = "Transport";
    static constexpr std::string_view uri = "urn:jaus:jss:core:Transport";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri{};
    static constexpr std::string_view parent_version{};
    using inputs = jaus::message_list<>;
    using outputs = jaus::message_list<>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::core
