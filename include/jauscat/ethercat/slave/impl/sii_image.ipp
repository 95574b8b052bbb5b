// The functions of sii_image.
#pragma once
#include <jauscat/ethercat/slave/sii_image.hpp>

namespace jauscat::ethercat {

JAUSCAT_CONSTEXPR std::uint8_t sii_checksum(std::span<const std::byte> bytes) noexcept {
    unsigned crc = 0xFF;
    for (const std::byte byte : bytes) {
        crc ^= std::to_integer<unsigned>(byte);
        for (int bit = 0; bit != 8; ++bit) crc = ((crc & 0x80) != 0 ? crc << 1 ^ 0x07 : crc << 1) & 0xFF;
    }
    return static_cast<std::uint8_t>(crc);
}

JAUSCAT_CONSTEXPR void sii_image::fit(std::size_t used) noexcept {
    while (size_ < used) size_ *= 2;
}

} // namespace jauscat::ethercat

namespace jauscat::ethercat::detail {

JAUSCAT_CONSTEXPR sii_writer::sii_writer(const slave_description& slave, const sii_coe_features& coe,
                                         std::span<std::byte> room) noexcept
    : slave_{slave}, coe_{coe}, room_{room}, rest_{room} {}

JAUSCAT_CONSTEXPR std::size_t sii_writer::write() noexcept {
    write_strings();
    put(sii_category_header{sii_category::general, wire::max_size<sii_general> / 2});
    put(sii_general{.order = 1,
                    .name = 1,
                    .sdo = slave_.has_mailbox(),
                    .sdo_information = slave_.has_mailbox() && coe_.sdo_information,
                    .complete_access = slave_.has_mailbox() && coe_.complete_access,
                    .ports = 0x0011});
    put(sii_category_header{sii_category::fmmu, 1});
    const auto outputs = slave_.outputs.empty() ? sii_fmmu_use::none : sii_fmmu_use::outputs;
    const auto inputs = slave_.inputs.empty() ? sii_fmmu_use::none : sii_fmmu_use::inputs;
    put_byte(static_cast<std::size_t>(outputs));
    put_byte(static_cast<std::size_t>(inputs));
    write_sync_managers();
    const auto outs = slave_.output_pdos(), ins = slave_.input_pdos();
    constexpr std::size_t first_pdo = 2; // strings: see write_strings
    const auto first_mode = first_pdo + outs.size() + ins.size();
    const auto first_entry = first_mode + 2 * modes().size();
    write_pdos(sii_category::tx_pdo, slave_.input_manager(), ins, first_pdo + outs.size(),
               first_entry + pdo_contents(slave_.outputs).size());
    write_pdos(sii_category::rx_pdo, slave_.output_manager(), outs, first_pdo, first_entry);
    write_clock_modes(first_mode);
    put(sii_category_header{sii_category::end, 0});
    return room_.size() - rest_.size();
}

JAUSCAT_CONSTEXPR void sii_writer::put_byte(std::size_t value) noexcept {
    rest_.front() = static_cast<std::byte>(value);
    rest_ = rest_.subspan(1);
}

JAUSCAT_CONSTEXPR void sii_writer::put_string(std::string_view text) noexcept {
    put_byte(text.size());
    for (const char c : text) put_byte(static_cast<unsigned char>(c));
}

JAUSCAT_CONSTEXPR std::size_t sii_writer::size_of(const pdo_list& pdos) noexcept {
    std::size_t size = pdos.size() * wire::max_size<sii_pdo>;
    for (std::size_t i = 0; i != pdos.size(); ++i) size += pdos[i].entries.size() * wire::max_size<sii_pdo_entry>;
    return size;
}

JAUSCAT_CONSTEXPR std::span<const clock_mode> sii_writer::modes() const noexcept {
    constexpr std::size_t max_modes = 8;
    return slave_.clock_modes.first(std::min(slave_.clock_modes.size(), max_modes));
}

JAUSCAT_CONSTEXPR void sii_writer::write_strings() noexcept {
    constexpr std::size_t others = 144; // general, FMMU, SyncM, the end, and headers
    const auto outs = slave_.output_pdos(), ins = slave_.input_pdos();
    const auto reserved = others + size_of(outs) + size_of(ins) + modes().size() * wire::max_size<sii_clock_mode>;
    const auto head = rest_.first(wire::max_size<sii_category_header>);
    rest_ = rest_.subspan(head.size());
    const auto count = rest_.first(1);
    const auto start = rest_.size();
    put_byte(0);
    const auto add = [&](std::string_view text) {
        if (names_ == 255 || text.size() > 255 || rest_.size() < reserved + text.size() + 2) return false;
        put_string(text);
        ++names_;
        return true;
    };
    add(slave_.name.substr(0, 64));
    bool room = true; // after one that does not fit none is written: an index is a place
    for (const auto& pdos : {outs, ins})
        for (std::size_t i = 0; i != pdos.size(); ++i) room = room && add(pdos[i].name);
    for (const auto& each : modes()) room = room && add(each.name) && add(each.description);
    for (const auto entries : {pdo_contents(slave_.outputs), pdo_contents(slave_.inputs)})
        for (const auto& each : entries) room = room && add(each.name);
    count.front() = static_cast<std::byte>(names_);
    if ((start - rest_.size()) % 2 != 0) put_byte(0);
    static_cast<void>(wire::encode(
        sii_category_header{sii_category::strings, static_cast<std::uint16_t>((start - rest_.size()) / 2)}, head));
}

JAUSCAT_CONSTEXPR void sii_writer::write_sync_managers() noexcept {
    const bool process_data = slave_.has_process_data();
    const std::size_t count = (slave_.has_mailbox() ? 2 : 0) + (process_data ? 2 : 0);
    put(sii_category_header{sii_category::sync_manager,
                            static_cast<std::uint16_t>(count * wire::max_size<sii_sync_manager> / 2)});
    if (slave_.has_mailbox()) {
        put(sii_sync_manager{.start = slave_.mailbox_out_offset,
                             .length = slave_.mailbox_out_size,
                             .control = manager_controls::mailbox_out,
                             .enable = 1,
                             .use = sii_sync_manager_use::mailbox_out});
        put(sii_sync_manager{.start = slave_.mailbox_in_offset,
                             .length = slave_.mailbox_in_size,
                             .control = manager_controls::mailbox_in,
                             .enable = 1,
                             .use = sii_sync_manager_use::mailbox_in});
    }
    if (!process_data) return;
    const auto put_buffer = [&](std::uint16_t start, std::size_t size, std::uint8_t control, sii_sync_manager_use use) {
        put(sii_sync_manager{.start = start,
                             .length = static_cast<std::uint16_t>(size),
                             .control = control,
                             .enable = static_cast<std::uint8_t>(size != 0 ? 1 : 0),
                             .use = use});
    };
    put_buffer(process_memory::outputs, slave_.output_size(), manager_controls::outputs, sii_sync_manager_use::outputs);
    put_buffer(process_memory::inputs, slave_.input_size(), manager_controls::inputs, sii_sync_manager_use::inputs);
}

JAUSCAT_CONSTEXPR void sii_writer::write_pdos(sii_category category, std::size_t manager, const pdo_list& pdos,
                                              std::size_t name, std::size_t entry_name) noexcept {
    if (pdos.size() == 0) return;
    put(sii_category_header{category, static_cast<std::uint16_t>(size_of(pdos) / 2)});
    for (std::size_t i = 0; i != pdos.size(); ++i) {
        const auto pdo = pdos[i];
        put(sii_pdo{.index = pdo.index,
                    .entries = static_cast<std::uint8_t>(pdo.entries.size()),
                    .sync_manager = static_cast<std::uint8_t>(manager),
                    .name = string_index(name++),
                    .flags = 0x0011}); // mandatory, and its contents are fixed
        for (const auto& each : pdo.entries)
            put(sii_pdo_entry{.index = each.index,
                              .subindex = each.subindex,
                              .name = string_index(entry_name++),
                              .data_type = each.data_type,
                              .bits = each.bits});
    }
}

JAUSCAT_CONSTEXPR void sii_writer::write_clock_modes(std::size_t name) noexcept {
    if (modes().empty()) return;
    put(sii_category_header{sii_category::dc,
                            static_cast<std::uint16_t>(modes().size() * wire::max_size<sii_clock_mode> / 2)});
    for (const auto& each : modes()) {
        put(sii_clock_mode{.cycle_time_0 = each.cycle_time_0,
                           .shift_time_0 = each.shift_time_0,
                           .shift_time_1 = each.shift_time_1,
                           .cycle_factor_1 = each.cycle_factor_1,
                           .assign_activate = each.assign_activate,
                           .cycle_factor_0 = each.cycle_factor_0,
                           .name = string_index(name),
                           .description = string_index(name + 1)});
        name += 2;
    }
}

JAUSCAT_CONSTEXPR std::uint8_t sii_writer::string_index(std::size_t wanted) const noexcept {
    return wanted <= names_ ? static_cast<std::uint8_t>(wanted) : std::uint8_t{};
}

} // namespace jauscat::ethercat::detail

namespace jauscat::ethercat {

JAUSCAT_CONSTEXPR sii_image make_sii_image(const slave_description& slave, const sii_coe_features& coe) noexcept {
    sii_image image{};
    const auto whole = image.whole();
    const std::size_t categories = sii_words::categories * 2;
    const auto used = categories + detail::sii_writer{slave, coe, whole.subspan(categories)}.write();
    image.fit(used);
    std::ranges::fill(whole.subspan(used), std::byte{0xFF});

    const auto put_at = [&](std::size_t word, const auto& message) {
        static_cast<void>(wire::encode(message, whole.subspan(word * 2)));
    };
    sii_configuration configuration{.pdi_control = sii_pdi_control, .station_alias = slave.station_alias};
    put_at(sii_words::configuration, configuration);
    configuration.checksum = sii_checksum(whole.first(sii_configuration_checked));
    put_at(sii_words::configuration, configuration);
    put_at(sii_words::identity, sii_identity{slave.vendor, slave.product, slave.revision, slave.serial});
    if (slave.has_mailbox())
        put_at(sii_words::mailbox, sii_mailbox{.receive_offset = slave.mailbox_out_offset,
                                               .receive_size = slave.mailbox_out_size,
                                               .send_offset = slave.mailbox_in_offset,
                                               .send_size = slave.mailbox_in_size,
                                               .coe = true});
    put_at(sii_words::size, sii_size{.kibit = static_cast<std::uint16_t>(image.size() * 8 / 1024 - 1), .version = 1});
    return image;
}

} // namespace jauscat::ethercat
