// The objects of the communication area that every CoE slave has (ETG.1000.6): device type, name, identity, use of the
// SyncManagers. Configuration tools read them to see whether a device is the one that its description speaks of.
#pragma once

#include <jauscat/ethercat/object_dictionary.hpp>
#include <jauscat/ethercat/sii_image.hpp>
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
} // namespace standard_indices

/// The standard objects of an emulated slave, all read only, in front of the objects of its application. Models
/// object_source.
class standard_objects {
  public:
    /// What `description` and `application` refer to must outlive this.
    constexpr standard_objects(const slave_description& description, object_dictionary application) noexcept
        : description_{description}, application_{application} {}

    /// Aborts: no_subindex and exceeds_mailbox, those of the application.
    object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
        std::array<std::byte, 64> value{};
        std::size_t size = 0;
        const auto put = [&](std::size_t byte) { value[size++] = static_cast<std::byte>(byte); };
        switch (index) {
        case standard_indices::device_type: // 4 bytes of 0: no device profile
            if (subindex != 0) return {.error = abort_code::no_subindex};
            size = 4;
            break;
        case standard_indices::device_name:
            if (subindex != 0) return {.error = abort_code::no_subindex};
            for (const char c : description_.name.substr(0, value.size())) put(static_cast<unsigned char>(c));
            break;
        case standard_indices::identity: // subindices 1 to 4: what the SII says, too
            if (subindex > 4) return {.error = abort_code::no_subindex};
            if (subindex == 0) {
                put(4);
            } else {
                std::array<std::byte, wire::max_size<sii_identity>> words{};
                static_cast<void>(wire::encode(
                    sii_identity{description_.vendor, description_.product, description_.revision, description_.serial},
                    words));
                std::ranges::copy(std::span{words}.subspan((subindex - 1u) * 4, 4), value.begin());
                size = 4;
            }
            break;
        case standard_indices::sync_manager_types: {
            constexpr std::array uses{sii_sync_manager_use::mailbox_out, sii_sync_manager_use::mailbox_in};
            if (subindex > uses.size()) return {.error = abort_code::no_subindex};
            put(subindex == 0 ? uses.size() : static_cast<std::size_t>(uses[subindex - 1u]));
            break;
        }
        default: return application_.read(index, subindex, out);
        }
        if (size > out.size()) return {.error = abort_code::exceeds_mailbox};
        std::ranges::copy(std::span{value}.first(size), out.begin());
        return {.size = size};
    }

    /// Aborts: no_subindex, read_only, those of the application.
    abort_code write(std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data) noexcept {
        switch (index) {
        case standard_indices::device_type:
        case standard_indices::device_name:
        case standard_indices::identity:
        case standard_indices::sync_manager_types: {
            std::array<std::byte, 64> value{};
            const auto there = read(index, subindex, value);
            return there.error == abort_code::none ? abort_code::read_only : there.error;
        }
        default: return application_.write(index, subindex, data);
        }
    }

  private:
    slave_description description_;
    object_dictionary application_;
};

} // namespace jauscat::ethercat
