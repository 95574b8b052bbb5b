// Generates the ESI description of an emulated slave from its SII, its standard objects and its JAUS objects.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/bridge/object_list.hpp>
#include <jauscat/esi/device.hpp>
#include <jauscat/ethercat/slave/sii_image.hpp>

#include <span>
#include <string>
#include <string_view>

namespace jauscat::esi {
inline namespace JAUSCAT_WAY {

/// Texts of a device that the slave itself does not report.
struct device_texts {
    std::string vendor_name{}; ///< for display
    std::string group_type{};  ///< key of the device's group
    std::string group_name{};  ///< for display
    std::string type{};        ///< short name, such as an order number
};

/// Properties by which an object of the ESI is read as that of a component.
namespace property_names {
inline constexpr std::string_view component = "JausComponent";      ///< of an object: JAUS component ID
inline constexpr std::string_view command_code = "JausCommandCode"; ///< of an entry
inline constexpr std::string_view exact_size = "ExactSize";         ///< of an object: its entries have one size
} // namespace property_names

/// The content of the SII of the emulated slave of that description: standard_objects and the objects of components
/// describe themselves.
[[nodiscard]] inline ethercat::sii_image make_sii(const ethercat::slave_description& slave) noexcept {
    return ethercat::make_sii_image(slave, {.sdo_information = true, .complete_access = true});
}

/// Describes the emulated slave of that description, with standard_objects and the objects in `components`.
/// `segmented_sdo`: it has memory for segmented transfers (`coe_options::transfer_memory`). Without a mailbox a slave
/// has no objects.
JAUSCAT_DECL device make_device(const ethercat::slave_description& slave, const device_texts& texts,
                                std::span<const bridging::object_description> components, bool segmented_sdo);

} // namespace JAUSCAT_WAY
} // namespace jauscat::esi

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/esi/impl/make_device.ipp>
#endif
