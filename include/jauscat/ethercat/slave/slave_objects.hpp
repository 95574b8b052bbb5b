// The objects of an emulated slave under the rules that its options switch on.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/slave/coe_options.hpp>
#include <jauscat/ethercat/slave/complete_object.hpp>
#include <jauscat/ethercat/slave/object_dictionary.hpp>
#include <jauscat/ethercat/slave/subindex_0_rule.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::ethercat {

/// Object of an SDO transfer.
struct transfer_object {
    std::uint16_t index{};
    std::uint8_t subindex{};
    bool complete{}; ///< the object from `subindex` on
};

/// Models described_object_source for single entries, and takes whole objects apart.
class slave_objects {
  public:
    /// In front of the application's objects, which must outlive it, with the rules of `options`.
    slave_objects(object_dictionary objects, const coe_options& options) noexcept
        : objects_{objects}, options_{options} {}

    void power_on() noexcept { rule_ = {}; }
    void set_state(al_state state) noexcept { state_ = state; }

    /// Reason for refusing a transfer before it begins: a rule, or complete access is not possible; `none` if allowed.
    [[nodiscard]] JAUSCAT_FUNCTION abort_code refusal(const transfer_object& object, bool writes) noexcept;

    /// Reads the entry or the whole object.
    JAUSCAT_FUNCTION object_read read(const transfer_object& object, std::span<std::byte> out) noexcept;
    /// Writes the entry or the whole object.
    [[nodiscard]] JAUSCAT_FUNCTION abort_code write(const transfer_object& object,
                                                    std::span<const std::byte> data) noexcept;

    /// Reads one entry.
    JAUSCAT_FUNCTION object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept;
    /// Writes one entry.
    [[nodiscard]] JAUSCAT_FUNCTION abort_code write(std::uint16_t index, std::uint8_t subindex,
                                                    std::span<const std::byte> data) noexcept;

    /// Whether the application describes its objects, for SDO information.
    [[nodiscard]] bool is_described() const noexcept { return objects_.is_described(); }
    [[nodiscard]] std::uint16_t next_index(std::uint16_t after) const noexcept { return objects_.next_index(after); }
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<object_info> describe(std::uint16_t index) const noexcept;
    /// With the access that the rules leave.
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<entry_info> describe(std::uint16_t index,
                                                                      std::uint8_t subindex) const noexcept;

  private:
    [[nodiscard]] JAUSCAT_FUNCTION abort_code refusal(std::uint16_t index, std::uint8_t subindex,
                                                      bool writes) const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION abort_code chosen_refusal(std::uint16_t index, std::uint8_t subindex) const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION abort_code count_refusal(std::uint16_t index, std::uint8_t subindex) const noexcept;

    // Refuses access in states that do not permit it. The object refuses what no state permits.
    [[nodiscard]] JAUSCAT_FUNCTION abort_code state_refusal(std::uint16_t index, std::uint8_t subindex,
                                                            bool writes) const noexcept;

    /// Whether the rule is about an object, and not about one that cannot be written anyway.
    [[nodiscard]] JAUSCAT_FUNCTION bool keeps_count(std::uint16_t index) const noexcept;

    object_dictionary objects_;
    coe_options options_;
    subindex_0_rule rule_{};
    al_state state_{al_state::pre_op};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/slave/impl/slave_objects.ipp>
#endif
