// Position and cause of a failed encode or decode.
#pragma once
#include <jauscat/wire/errc.hpp>
#include <jauscat/wire/item.hpp>

#include <array>
#include <string_view>

namespace jauscat::wire {

/// A structure or list around a field.
struct diagnosis_step {
    /// Not a list.
    static constexpr std::size_t no_element = unbounded;
    std::string_view name{};
    std::size_t element = no_element; ///< place in a list, from 0

    friend constexpr bool operator==(const diagnosis_step&, const diagnosis_step&) = default;
};

/// Position and cause of a failure.
struct diagnosis {
    errc error{};
    std::string_view
        field{}; ///< the member's name, "presence_vector", a count's name, or empty where no field is at fault
    std::array<diagnosis_step, 6> path{}; ///< the structures and lists around it, outermost first
    std::size_t depth{};                  ///< how many of them
    std::size_t offset{}; ///< byte of the message at which the field starts (trailing_bytes: the first byte too many)
    std::size_t needed{}; ///< bytes the field needs there (no_space: bytes the message needs)
    std::size_t available{}; ///< bytes that are left there (no_space: bytes of the buffer)

    [[nodiscard]] constexpr explicit operator bool() const noexcept { return error == errc::ok; }
    /// The structure or list that holds the field; empty for the message itself.
    [[nodiscard]] constexpr diagnosis_step parent() const noexcept {
        return depth == 0 ? diagnosis_step{} : path[depth - 1];
    }

    friend constexpr bool operator==(const diagnosis&, const diagnosis&) = default;
};

} // namespace jauscat::wire
