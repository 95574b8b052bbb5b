// Makes the contents of a slave's SII memory from a short description.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/slave/slave_description.hpp>
#include <jauscat/schema/ethercat/sii.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace jauscat::ethercat {

/// PDI control of an emulated slave controller: on-chip bus.
inline constexpr std::uint16_t sii_pdi_control = 0x0080;

/// CRC-8 of the SII's first words: polynomial 0x07, start value 0xFF.
[[nodiscard]] JAUSCAT_CONSTEXPR std::uint8_t sii_checksum(std::span<const std::byte> bytes) noexcept;

/// A memory of 4, 8, 16 or 32 Kibit: the smallest that holds what a slave has to say. 512 bytes without process data.
class sii_image {
  public:
    static constexpr std::size_t max_size = 4096; ///< bytes

    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
    [[nodiscard]] constexpr const std::byte* data() const noexcept { return bytes_.data(); }
    [[nodiscard]] constexpr const std::byte* begin() const noexcept { return data(); }
    [[nodiscard]] constexpr const std::byte* end() const noexcept { return data() + size_; }
    /// The byte at a place below `size()`.
    [[nodiscard]] constexpr std::byte operator[](std::size_t at) const noexcept { return bytes_[at]; }
    /// All of the largest memory, to be written.
    [[nodiscard]] constexpr std::span<std::byte> whole() noexcept { return bytes_; }
    /// As many bytes as a memory needs that holds `used` of them.
    JAUSCAT_CONSTEXPR void fit(std::size_t used) noexcept;

  private:
    std::array<std::byte, max_size> bytes_{};
    std::size_t size_{512};
};

/// CoE features besides SDO transfers.
struct sii_coe_features {
    bool sdo_information{}; ///< the slave answers SDO information
    bool complete_access{}; ///< the slave takes whole objects
};

namespace detail {

/// Writes the categories of one slave. They fit for any description: names that do not fit are omitted.
class sii_writer {
  public:
    JAUSCAT_CONSTEXPR sii_writer(const slave_description& slave, const sii_coe_features& coe,
                                 std::span<std::byte> room) noexcept;

    /// Returns how many bytes they take.
    JAUSCAT_CONSTEXPR std::size_t write() noexcept;

  private:
    constexpr void put(const auto& message) noexcept { rest_ = rest_.subspan(wire::encode(message, rest_)->size()); }
    JAUSCAT_CONSTEXPR void put_byte(std::size_t value) noexcept;
    JAUSCAT_CONSTEXPR void put_string(std::string_view text) noexcept;

    // Bytes of the PDOs' category without its header.
    JAUSCAT_CONSTEXPR static std::size_t size_of(const pdo_list& pdos) noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR std::span<const clock_mode> modes() const noexcept;

    // String 1: the slave; then one for each PDO, outputs first, two for each clock mode, and one for each entry,
    // outputs first, while they fit.
    JAUSCAT_CONSTEXPR void write_strings() noexcept;

    JAUSCAT_CONSTEXPR void write_sync_managers() noexcept;

    JAUSCAT_CONSTEXPR void write_pdos(sii_category category, std::size_t manager, const pdo_list& pdos,
                                      std::size_t name, std::size_t entry_name) noexcept;

    JAUSCAT_CONSTEXPR void write_clock_modes(std::size_t name) noexcept;

    [[nodiscard]] JAUSCAT_CONSTEXPR std::uint8_t string_index(std::size_t wanted) const noexcept;

    const slave_description& slave_;
    const sii_coe_features& coe_;
    std::span<std::byte> room_;
    std::span<std::byte> rest_;
    std::size_t names_{};
};

} // namespace detail

/// The memory's contents: fixed words with checksum, and the categories strings, general, FMMU, SyncM; with process
/// data TxPDO and RxPDO, with clock modes DC.
[[nodiscard]] JAUSCAT_CONSTEXPR sii_image make_sii_image(const slave_description& slave,
                                                         const sii_coe_features& coe = {}) noexcept;

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/slave/impl/sii_image.ipp>
#endif
