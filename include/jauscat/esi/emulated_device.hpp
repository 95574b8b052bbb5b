// Emulated slave built from an ESI description: identity, SII, objects.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/bridge/object_list.hpp>
#include <jauscat/esi/device.hpp>
#include <jauscat/esi/error.hpp>
#include <jauscat/esi/make_device.hpp>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jauscat::esi {
inline namespace JAUSCAT_WAY {

/// Converts an ESI description to the arguments of `ethercat::slave`, `ethercat::standard_objects`,
/// `ethercat::mapped_objects` and `bridging::listed_objects`. Must outlive them.
///
///     const auto described = esi::read_esi("arm.xml");
///     if (!described) return std::cerr << describe(described.error()) << '\n', 1;
///     esi::emulated_device device{*described};
///     bridging::listed_objects listed{device.components(), application};
///     ethercat::mapped_objects mapped{device.description(), listed};
///     ethercat::standard_objects objects{device.description(), mapped};
///     std::vector<std::byte> memory(device.transfer_size());
///     ethercat::slave slave{device.description(), objects, {.transfer_memory = memory}};
///
/// An ESI does not state whether a read of the SII returns 4 or 8 bytes: the emulated slave returns 4.
class emulated_device {
  public:
    /// Throws `esi_error` for a device that cannot be emulated: with PDOs that can be changed, other SyncManagers,
    /// other objects, other CoE features.
    JAUSCAT_DECL explicit emulated_device(device what);
    emulated_device(const emulated_device&) = delete;
    emulated_device& operator=(const emulated_device&) = delete;

    /// Identity, mailbox and process data of the emulated slave.
    [[nodiscard]] const ethercat::slave_description& description() const noexcept { return description_; }
    /// The objects of JAUS components.
    [[nodiscard]] std::span<const bridging::object_description> components() const noexcept { return components_; }
    /// What its SII holds, byte for byte.
    [[nodiscard]] ethercat::sii_image sii() const noexcept { return make_sii(description_); }
    /// Bytes of the largest object, for segmented transfers; 0 for a device without them.
    [[nodiscard]] std::size_t transfer_size() const noexcept {
        return device_.coe.segmented_sdo ? bridging::largest_subobject(components_) : 0;
    }

  private:
    [[noreturn]] JAUSCAT_DECL void fail(errc code, const std::string& element, const std::string& what) const;

    JAUSCAT_DECL void read_description();
    JAUSCAT_DECL static void read_pdos(const std::vector<pdo>& pdos, std::vector<ethercat::pdo_entry>& into,
                                       std::vector<ethercat::pdo_part>& parts);
    [[nodiscard]] JAUSCAT_DECL const object* find_object(std::uint16_t index) const noexcept;
    // The default of a string object, or empty.
    [[nodiscard]] JAUSCAT_DECL std::string text_of(std::uint16_t index) const;

    JAUSCAT_DECL void add_component(const object& what, const std::string& id);

    JAUSCAT_DECL static const property* find(const std::vector<property>& properties, std::string_view name) noexcept;

    device device_;
    std::vector<ethercat::pdo_entry> outputs_{}, inputs_{};
    std::vector<ethercat::pdo_part> output_parts_{}, input_parts_{};
    std::vector<ethercat::clock_mode> clock_modes_{};
    std::string hardware_{}, software_{};
    ethercat::slave_description description_{};
    std::deque<std::vector<bridging::sub_object>> entries_{}; // components_ refers to them
    std::vector<bridging::object_description> components_{};
};

} // namespace JAUSCAT_WAY
} // namespace jauscat::esi

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/esi/impl/emulated_device.ipp>
#endif
