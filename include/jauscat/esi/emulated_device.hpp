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

/// What the emulated slave of an ESI description is made of: the arguments of `ethercat::slave` and `emulated_objects`.
/// Must outlive them.
///
///     const auto described = esi::read_esi("arm.xml");
///     if (!described) return std::cerr << describe(described.error()) << '\n', 1;
///     esi::emulated_device device{*described};
///     esi::emulated_objects objects{device, application};
///     std::vector<std::byte> memory(device.transfer_size());
///     ethercat::slave slave{device.description(), objects, {.transfer_memory = memory}};
///     objects.show(slave);
///
/// An ESI does not state whether a read of the SII returns 4 or 8 bytes: the emulated slave returns 4.
class emulated_device {
  public:
    /// Throws `esi_error` for a device that cannot be emulated: a mailbox that is not the first two SyncManagers, more
    /// SyncManagers, memory or process data than an emulated slave has, PDO entries of more than 255 bits.
    JAUSCAT_DECL explicit emulated_device(device what);
    emulated_device(const emulated_device&) = delete;
    emulated_device& operator=(const emulated_device&) = delete;

    /// Identity, mailbox and process data of the emulated slave.
    [[nodiscard]] const ethercat::slave_description& description() const noexcept { return description_; }
    /// The objects of JAUS components.
    [[nodiscard]] std::span<const bridging::object_description> components() const noexcept { return components_; }
    /// What its SII holds, byte for byte.
    [[nodiscard]] std::span<const std::byte> sii() const& noexcept { return sii_; }
    std::span<const std::byte> sii() const&& = delete; // it would refer to what is gone
    /// Bytes of the largest object, for segmented transfers; 0 for a device without them.
    [[nodiscard]] JAUSCAT_DECL std::size_t transfer_size() const noexcept;
    /// The description that it was made of.
    [[nodiscard]] const device& source() const noexcept { return device_; }
    /// Its description has all of it, as has that of every slave which `make_device` describes.
    [[nodiscard]] bool is_plain() const noexcept { return is_plain_; }

  private:
    [[noreturn]] JAUSCAT_DECL void fail(errc code, const std::string& element, const std::string& what) const;

    // As a slave that `make_device` describes; whether it is one.
    JAUSCAT_DECL bool read_as_plain();
    JAUSCAT_DECL void read_areas();
    JAUSCAT_DECL void read_identity();
    JAUSCAT_DECL static void read_pdos(const std::vector<pdo>& pdos, std::vector<ethercat::pdo_entry>& into,
                                       std::vector<ethercat::pdo_part>& parts);
    [[nodiscard]] JAUSCAT_DECL const object* find_object(std::uint16_t index) const noexcept;
    // The default of a string object, or empty.
    [[nodiscard]] JAUSCAT_DECL std::string text_of(std::uint16_t index) const;

    JAUSCAT_DECL void add_component(const object& what, const std::string& id);

    device device_;
    bool is_plain_{};
    std::vector<ethercat::pdo_entry> outputs_{}, inputs_{};
    std::vector<ethercat::pdo_part> output_parts_{}, input_parts_{};
    std::vector<ethercat::clock_mode> clock_modes_{};
    std::vector<ethercat::data_area> areas_{};
    std::vector<std::byte> sii_{};
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
