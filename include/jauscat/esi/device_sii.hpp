// The content of the SII of a device, as a configuration tool writes it (ETG.2010).
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/esi/device.hpp>
#include <jauscat/schema/ethercat/sii.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace jauscat::esi {
inline namespace JAUSCAT_WAY {

/// Words 0 to 7 of the SII, by ConfigData; without it an on-chip bus. The checksum is that of the other words.
[[nodiscard]] JAUSCAT_DECL ethercat::sii_configuration configuration_of(const eeprom& memory);

/// Bytes of process data that a SyncManager of a device has at first: its PDOs, or, without any, its default size.
[[nodiscard]] JAUSCAT_DECL std::size_t data_size(const device& of, std::size_t manager);

/// The whole SII of a device: the image in its file, or words 0 to 63 and the categories strings, general, FMMU, SyncM,
/// TxPDO, RxPDO and DC. Names that do not fit are left out. As large as the device's memory, or as what it holds.
[[nodiscard]] JAUSCAT_DECL std::vector<std::byte> device_sii(const device& of);

} // namespace JAUSCAT_WAY
} // namespace jauscat::esi

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/esi/impl/device_sii.ipp>
#endif
