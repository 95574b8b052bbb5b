// CoE options of an emulated slave: features, and rules that it enforces.
#pragma once

#include <jauscat/schema/ethercat/coe.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::ethercat {

/// An object that a slave aborts every transfer of.
struct refused_object {
    std::uint16_t index{};
    std::optional<std::uint8_t> subindex{}; ///< without it: all of them
    abort_code code{};
};

/// Rules that are not set are not enforced.
struct coe_options {
    /// Holds an object while it goes in segments; its size is that of the largest one. Each slave needs its own, which
    /// outlives it. Without it an object has to fit one message: a larger one is aborted with 06010005h.
    std::span<std::byte> transfer_memory{};
    /// Subindex 0 of mapping and assignment objects is kept here, and their entries are aborted with 06010003h while it
    /// is not 0: see subindex_0_rule. Objects described as read-only are not affected.
    bool subindex_0_rule{};
    /// An upload in segments starts without data, as some slaves do, in place of as much as fits.
    bool empty_start{};
    /// An entry is accessed only in states that its description allows, else aborted with 08000022h; those of mapping
    /// and assignment objects are written in PRE-OP only, whatever their description.
    bool state_rule{};
    /// Frames that pass before a request is answered, besides the one that brought it.
    std::uint32_t answer_delay{};
    /// Objects that are there and cannot be accessed. Must outlive the slave.
    std::span<const refused_object> refused{};
};

} // namespace jauscat::ethercat
