// Reads a capture file of the classic pcap format, little-endian, microseconds, Ethernet.
#pragma once

#include "support/paths.hpp"
#include <jauscat/wire/wire.hpp>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace jauscat::test {

struct pcap_file_header {
    std::uint32_t magic{};
    std::uint16_t major{};
    std::uint16_t minor{};
    std::uint64_t zone_and_accuracy{};
    std::uint32_t longest{};
    std::uint32_t link_type{};
};
struct pcap_record_header {
    std::uint32_t seconds{};
    std::uint32_t microseconds{};
    std::uint32_t captured{};
    std::uint32_t original{};
};

} // namespace jauscat::test

namespace jauscat {

template <> struct wire::schema<test::pcap_file_header> {
    using T = test::pcap_file_header;
    using type = layout<field<&T::magic, u32le>, field<&T::major, u16le>, field<&T::minor, u16le>,
                        field<&T::zone_and_accuracy, u64le>, field<&T::longest, u32le>, field<&T::link_type, u32le>>;
};
template <> struct wire::schema<test::pcap_record_header> {
    using T = test::pcap_record_header;
    using type = layout<field<&T::seconds, u32le>, field<&T::microseconds, u32le>, field<&T::captured, u32le>,
                        field<&T::original, u32le>>;
};

} // namespace jauscat

namespace jauscat::test {

/// The frames of a capture in the test data folder, complete and in order. Throws when the file is not what it should
/// be.
inline std::vector<std::vector<std::byte>> read_pcap(const std::string& name) {
    std::ifstream file{support::test_data(name), std::ios::binary};
    if (!file) throw std::runtime_error{"no such capture: " + name};
    std::vector<std::byte> bytes;
    for (std::istreambuf_iterator<char> at{file}, end; at != end; ++at) bytes.push_back(static_cast<std::byte>(*at));

    std::span<const std::byte> rest{bytes};
    pcap_file_header header{};
    const auto used = wire::decode_prefix(header, rest);
    if (!used || header.magic != 0xA1B2C3D4 || header.link_type != 1) throw std::runtime_error{"not pcap: " + name};
    std::vector<std::vector<std::byte>> frames;
    for (rest = rest.subspan(*used); !rest.empty();) {
        pcap_record_header record{};
        const auto size = wire::decode_prefix(record, rest);
        if (!size || rest.size() - *size < record.captured || record.captured != record.original)
            throw std::runtime_error{"incomplete capture: " + name};
        const auto frame = rest.subspan(*size, record.captured);
        frames.emplace_back(frame.begin(), frame.end());
        rest = rest.subspan(*size + record.captured);
    }
    return frames;
}

} // namespace jauscat::test
