// The objects of the communication area that every CoE slave has (ETG.1000.6): device type, name, identity, use of the
// SyncManagers. Configuration tools read them to see whether a device is the one that its description speaks of.
#pragma once

#include <jauscat/ethercat/object_dictionary.hpp>
#include <jauscat/ethercat/slave_description.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/schema/ethercat/pdo.hpp>
#include <jauscat/schema/ethercat/sii.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// Indices of the standard objects.
namespace standard_indices {
inline constexpr std::uint16_t device_type = 0x1000;
inline constexpr std::uint16_t device_name = 0x1008;
inline constexpr std::uint16_t identity = 0x1018;
inline constexpr std::uint16_t sync_manager_types = 0x1C00;
inline constexpr std::uint16_t output_assignment = 0x1C12;
inline constexpr std::uint16_t input_assignment = 0x1C13;
} // namespace standard_indices

/// The standard objects of an emulated slave, all read only, in front of the objects of its application: with process
/// data also their mapping (1600h, 1A00h) and assignment (1C12h, 1C13h). Models object_source.
class standard_objects {
  public:
    /// What `description` and `application` refer to must outlive this.
    constexpr standard_objects(const slave_description& description, object_dictionary application) noexcept
        : description_{description}, application_{application} {}

    /// Aborts: no_subindex and exceeds_mailbox, those of the application.
    object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
        value found{};
        const auto error = find(index, subindex, found);
        if (error == abort_code::no_object) return application_.read(index, subindex, out);
        if (error != abort_code::none) return {.error = error};
        if (found.size > out.size()) return {.error = abort_code::exceeds_mailbox};
        std::ranges::copy(std::span{found.bytes}.first(found.size), out.begin());
        return {.size = found.size};
    }

    /// Aborts: no_subindex, read_only, those of the application.
    abort_code write(std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data) noexcept {
        value found{};
        const auto error = find(index, subindex, found);
        if (error == abort_code::no_object) return application_.write(index, subindex, data);
        return error == abort_code::none ? abort_code::read_only : error;
    }

  private:
    struct value {
        std::array<std::byte, 64> bytes{};
        std::size_t size{};

        void put(std::size_t byte) noexcept { bytes[size++] = static_cast<std::byte>(byte); }
        void put_message(const auto& message) noexcept {
            size += wire::encode(message, std::span{bytes}.subspan(size)).size();
        }
    };

    // Error no_object: it is none of the standard ones.
    [[nodiscard]] abort_code find(std::uint16_t index, std::uint8_t subindex, value& out) const noexcept {
        const bool process_data = description_.has_process_data();
        // An object whose subindices 1 to `count` are put by `put_entry`.
        const auto entries = [&](std::size_t count, auto&& put_entry) {
            if (subindex > count) return abort_code::no_subindex;
            if (subindex == 0) {
                out.put(count);
            } else {
                put_entry(subindex - 1u);
            }
            return abort_code::none;
        };
        const auto mapping = [&](std::span<const pdo_entry> all) {
            if (all.empty()) return abort_code::no_object;
            const auto mapped = pdo_contents(all);
            return entries(mapped.size(), [&](std::size_t i) {
                out.put_message(pdo_mapping{mapped[i].bits, mapped[i].subindex, mapped[i].index});
            });
        };
        const auto assignment = [&](std::span<const pdo_entry> all, std::uint16_t pdo) {
            if (!process_data) return abort_code::no_object;
            return entries(all.empty() ? 0 : 1, [&](std::size_t) { out.put_message(esc_word{pdo}); });
        };
        switch (index) {
        case standard_indices::device_type: // 4 bytes of 0: no device profile
            if (subindex != 0) return abort_code::no_subindex;
            out.size = 4;
            return abort_code::none;
        case standard_indices::device_name:
            if (subindex != 0) return abort_code::no_subindex;
            for (const char c : description_.name.substr(0, out.bytes.size())) out.put(static_cast<unsigned char>(c));
            return abort_code::none;
        case standard_indices::identity: // subindices 1 to 4: what the SII says, too
            return entries(4, [&](std::size_t i) {
                std::array<std::byte, wire::max_size<sii_identity>> words{};
                static_cast<void>(wire::encode(
                    sii_identity{description_.vendor, description_.product, description_.revision, description_.serial},
                    words));
                std::ranges::copy(std::span{words}.subspan(i * 4, 4), out.bytes.begin());
                out.size = 4;
            });
        case standard_indices::sync_manager_types: {
            using enum sii_sync_manager_use;
            constexpr std::array uses{mailbox_out, mailbox_in, outputs, inputs};
            return entries(process_data ? 4 : 2, [&](std::size_t i) { out.put(static_cast<std::size_t>(uses[i])); });
        }
        case pdo_indices::outputs: return mapping(description_.outputs);
        case pdo_indices::inputs: return mapping(description_.inputs);
        case standard_indices::output_assignment: return assignment(description_.outputs, pdo_indices::outputs);
        case standard_indices::input_assignment: return assignment(description_.inputs, pdo_indices::inputs);
        default: return abort_code::no_object;
        }
    }

    slave_description description_;
    object_dictionary application_;
};

} // namespace jauscat::ethercat
