// Makes the contents of a slave's SII memory from a short description.
#pragma once

#include <jauscat/schema/ethercat/sii.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace jauscat::ethercat {

/// What an emulated slave says about itself.
struct slave_description {
    std::uint32_t vendor{};
    std::uint32_t product{};
    std::uint32_t revision{1};
    std::uint32_t serial{};
    std::uint16_t station_alias{};
    std::uint16_t mailbox_out_offset{0x1000}; ///< master to slave, SyncManager 0
    std::uint16_t mailbox_out_size{256};      ///< bytes, 24 to 1486
    std::uint16_t mailbox_in_offset{0x1600};  ///< slave to master, SyncManager 1
    std::uint16_t mailbox_in_size{256};       ///< bytes, 24 to 1486
    std::string_view name{"JausCat slave"};   ///< up to 64 characters are kept
    bool eight_byte_sii_reads{};              ///< a read of the SII gives 8 bytes, else 4
};

/// CRC-8 of the SII's first words: polynomial 0x07, start value 0xFF.
[[nodiscard]] constexpr std::uint8_t sii_checksum(std::span<const std::byte> bytes) noexcept {
    unsigned crc = 0xFF;
    for (const std::byte byte : bytes) {
        crc ^= std::to_integer<unsigned>(byte);
        for (int bit = 0; bit != 8; ++bit) crc = ((crc & 0x80) != 0 ? crc << 1 ^ 0x07 : crc << 1) & 0xFF;
    }
    return static_cast<std::uint8_t>(crc);
}

/// A 4-Kibit memory: all of 512 bytes.
using sii_image = std::array<std::byte, 512>;

/// The memory's contents: fixed words with checksum, and the categories strings, general, FMMU and SyncM.
[[nodiscard]] constexpr sii_image make_sii_image(const slave_description& slave) noexcept {
    sii_image image{};
    std::span<std::byte> rest{image};
    const auto put = [&rest](const auto& message) { // the image is large enough for all that is put here
        const auto used = wire::encode(message, rest);
        rest = rest.subspan(used.size());
    };
    const auto put_category = [&](sii_category category, std::size_t bytes) {
        put(sii_category_header{category, static_cast<std::uint16_t>((bytes + 1) / 2)});
    };
    const auto at = [&](std::size_t word) { rest = std::span{image}.subspan(word * 2); };

    sii_configuration configuration{.pdi_control = 0x0080, .station_alias = slave.station_alias};
    put(configuration);
    configuration.checksum = sii_checksum(std::span{image}.first(14));
    at(sii_words::configuration);
    put(configuration);
    put(sii_identity{slave.vendor, slave.product, slave.revision, slave.serial});
    at(sii_words::mailbox);
    put(sii_mailbox{.receive_offset = slave.mailbox_out_offset,
                    .receive_size = slave.mailbox_out_size,
                    .send_offset = slave.mailbox_in_offset,
                    .send_size = slave.mailbox_in_size,
                    .coe = true});
    at(sii_words::size);
    put(sii_size{.kibit = image.size() * 8 / 1024 - 1, .version = 1});

    const auto name = slave.name.substr(0, 64);
    put_category(sii_category::strings, 2 + name.size());
    rest[0] = std::byte{1};
    rest[1] = static_cast<std::byte>(name.size());
    std::ranges::transform(name, rest.begin() + 2, [](char c) { return static_cast<std::byte>(c); });
    rest = rest.subspan((2 + name.size() + 1) / 2 * 2);

    put_category(sii_category::general, 32);
    put(sii_general{.order = 1, .name = 1, .sdo = true, .ports = 0x0011});

    put_category(sii_category::fmmu, 2);
    rest[0] = rest[1] = std::byte{0};
    rest = rest.subspan(2);

    put_category(sii_category::sync_manager, 16);
    put(sii_sync_manager{.start = slave.mailbox_out_offset,
                         .length = slave.mailbox_out_size,
                         .control = 0x26,
                         .enable = 1,
                         .use = sii_sync_manager_use::mailbox_out});
    put(sii_sync_manager{.start = slave.mailbox_in_offset,
                         .length = slave.mailbox_in_size,
                         .control = 0x22,
                         .enable = 1,
                         .use = sii_sync_manager_use::mailbox_in});
    put_category(sii_category::end, 0);
    std::ranges::fill(rest, std::byte{0xFF});
    return image;
}

} // namespace jauscat::ethercat
