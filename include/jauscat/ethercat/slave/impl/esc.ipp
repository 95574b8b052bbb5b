// The functions of esc.
#pragma once
#include <jauscat/ethercat/slave/esc.hpp>

namespace jauscat::ethercat {

JAUSCAT_CONSTEXPR void esc::pass(std::span<std::byte> frame) noexcept {
    mutable_frame_view view;
    if (!view.parse_datagrams(frame)) return;
    ethernet_header ethernet{};
    static_cast<void>(wire::decode_prefix(ethernet, frame));
    ethernet.source[0] |= std::byte{0x02};
    static_cast<void>(wire::encode(ethernet, frame));
    for (const auto datagram : view) execute(datagram);
}

JAUSCAT_CONSTEXPR void esc::pass(std::span<std::byte> frame, time_point now) noexcept {
    begin_frame(now);
    pass(frame);
}

JAUSCAT_CONSTEXPR void esc::execute(const basic_datagram<std::byte>& d) noexcept {
    auto header = d.header;
    bool hit = false, reads = false, writes = false;
    const bool by_position = header.adp == 0;
    switch (header.cmd) {
    case command::aprd: hit = by_position, reads = true; break;
    case command::apwr: hit = by_position, writes = true; break;
    case command::aprw: hit = by_position, reads = writes = true; break;
    case command::fprd: hit = is_station(header.adp), reads = true; break;
    case command::fpwr: hit = is_station(header.adp), writes = true; break;
    case command::fprw: hit = is_station(header.adp), reads = writes = true; break;
    case command::brd: hit = reads = true; break;
    case command::bwr: hit = writes = true; break;
    case command::brw: hit = reads = writes = true; break;
    case command::armw: hit = true, reads = by_position, writes = !reads; break;
    case command::frmw: hit = true, reads = is_station(header.adp), writes = !reads; break;
    case command::lrd: return execute_logical(d, true, false);
    case command::lwr: return execute_logical(d, false, true);
    case command::lrw: return execute_logical(d, true, true);
    case command::nop:
    default: return;
    }
    const bool broadcast = header.cmd == command::brd || header.cmd == command::bwr || header.cmd == command::brw;
    if (broadcast || header.cmd == command::armw || header.cmd <= command::aprw) ++header.adp;

    unsigned counter = d.working_counter;
    if (hit && reads && writes) { // the data are exchanged: what is written has to be kept while it is read over
        std::array<std::byte, max_datagram_data> sent{};
        std::ranges::copy(d.data, sent.begin());
        if (read(header.ado, d.data, broadcast)) counter += 1;
        if (write(header.ado, std::span{sent}.first(d.data.size()))) counter += 2;
    } else if (hit && reads) {
        if (read(header.ado, d.data, broadcast)) counter += 1;
    } else if (hit) {
        if (write(header.ado, d.data)) counter += 1;
    }
    static_cast<void>(wire::encode(header, d.bytes));
    count(d, counter);
}

JAUSCAT_CONSTEXPR void esc::count(const basic_datagram<std::byte>& d, unsigned counter) noexcept {
    static_cast<void>(wire::encode(datagram_trailer{static_cast<std::uint16_t>(counter)},
                                   d.bytes.last(wire::max_size<datagram_trailer>)));
}

JAUSCAT_CONSTEXPR void esc::execute_logical(const basic_datagram<std::byte>& d, bool reads, bool writes) noexcept {
    const auto address = logical_address(d.header);
    std::array<std::byte, max_datagram_data> copy;
    std::span<const std::byte> sent = d.data;
    if (reads && writes) { // a mapping for both directions reads over what it writes
        std::ranges::copy(d.data, copy.begin());
        sent = std::span{copy}.first(d.data.size());
    }
    bool read_any = false, written_any = false;
    for (std::size_t n = 0; n != fmmu_count; ++n) {
        const auto map = mapping(n);
        const auto overlap = overlap_of(map, address, d.data.size());
        if (overlap.bits == 0) continue;
        if (reads && map.read && read_mapped(overlap, d.data)) read_any = true;
        if (writes && map.write && write_mapped(overlap, sent)) written_any = true;
    }
    const unsigned write_count = reads ? 2 : 1;
    if (read_any || written_any) count(d, d.working_counter + (read_any ? 1u : 0u) + (written_any ? write_count : 0u));
}

JAUSCAT_CONSTEXPR bool esc::read_mapped(const fmmu_overlap& overlap, std::span<std::byte> data) noexcept {
    if (overlap.is_bytes())
        return read(overlap.memory_start(), data.subspan(overlap.data_start(), overlap.memory_size()));
    std::array<std::byte, max_datagram_data + 1> bytes{}; // bits may begin and end within a byte
    const auto touched = std::span{bytes}.first(overlap.memory_size());
    if (!read(overlap.memory_start(), touched)) return false;
    copy_bits(touched, overlap.bit_in_memory(), data, overlap.data_bit, overlap.bits);
    return true;
}

JAUSCAT_CONSTEXPR bool esc::write_mapped(const fmmu_overlap& overlap, std::span<const std::byte> data) noexcept {
    if (overlap.is_bytes())
        return write(overlap.memory_start(), data.subspan(overlap.data_start(), overlap.memory_size()));
    if (overlap.memory_start() + overlap.memory_size() > memory_size) return false;
    std::array<std::byte, max_datagram_data + 1> merged{};
    const auto touched = std::span{merged}.first(overlap.memory_size());
    std::ranges::copy(bytes(overlap.memory_start(), touched.size()), touched.begin());
    copy_bits(data, overlap.data_bit, touched, overlap.bit_in_memory(), overlap.bits);
    return write(overlap.memory_start(), touched);
}

JAUSCAT_CONSTEXPR std::uint32_t esc::logical_address(const datagram_header& header) noexcept {
    return std::uint32_t{header.ado} << 16 | header.adp;
}

JAUSCAT_CONSTEXPR bool esc::is_station(std::uint16_t address) const noexcept {
    if (address == load(esc_registers::station_address).value) return true;
    constexpr esc_register_of<esc_word> high_half{{esc_registers::dl_control.address + 2, 2}};
    const bool alias_enabled = (load<esc_word>(high_half).value & 0x0100) != 0;
    return alias_enabled && address == load(esc_registers::station_alias).value;
}

} // namespace jauscat::ethercat
