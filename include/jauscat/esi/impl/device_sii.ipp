// The writer of a device's SII.
#pragma once
#include <jauscat/esi/device_sii.hpp>
#include <jauscat/esi/text_values.hpp>
#include <jauscat/ethercat/slave/sii_image.hpp>
#include <jauscat/schema/ethercat/sii.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <string>

namespace jauscat::esi {

namespace detail {

class device_sii_writer {
  public:
    explicit device_sii_writer(const device& of) : device_{of} {}

    std::vector<std::byte> write() {
        made_.assign(std::size_t{2} * ethercat::sii_words::categories, std::byte{});
        const auto categories = body();
        put_strings();
        made_.insert(made_.end(), categories.begin(), categories.end());
        put(made_, ethercat::sii_category_header{ethercat::sii_category::end, 0});
        constexpr std::size_t largest = 0x20000; // bytes that words have addresses for
        made_.resize(std::bit_ceil(std::max(made_.size(), std::min<std::size_t>(device_.eeprom.byte_size, largest))),
                     std::byte{0xFF});
        put_fixed_words();
        return std::move(made_);
    }

  private:
    using bytes = std::vector<std::byte>;

    static void put(bytes& into, const auto& message) {
        std::array<std::byte, 64> room{};
        const auto written = *wire::encode(message, room);
        into.insert(into.end(), written.begin(), written.end());
    }
    void put_at(std::size_t word, const auto& message) {
        static_cast<void>(wire::encode(message, std::span{made_}.subspan(word * 2)));
    }
    static void put_category(bytes& into, ethercat::sii_category category, bytes content) {
        if (content.empty()) return;
        if (content.size() % 2 != 0) content.push_back({});
        put(into, ethercat::sii_category_header{category, static_cast<std::uint16_t>(content.size() / 2)});
        into.insert(into.end(), content.begin(), content.end());
    }

    /// The number of a string, from 1; 0: none.
    std::uint8_t string(const std::string& text) {
        constexpr std::size_t most = 255;
        if (text.empty() || text.size() > most) return 0;
        const auto found = std::ranges::find(strings_, text);
        if (found == strings_.end()) {
            if (strings_.size() == most) return 0;
            strings_.push_back(text);
            return static_cast<std::uint8_t>(strings_.size());
        }
        return static_cast<std::uint8_t>(found - strings_.begin() + 1);
    }
    void put_strings() {
        bytes content{static_cast<std::byte>(strings_.size())};
        for (const auto& each : strings_) {
            content.push_back(static_cast<std::byte>(each.size()));
            for (const char c : each) content.push_back(static_cast<std::byte>(c));
        }
        put_category(made_, ethercat::sii_category::strings, std::move(content));
    }

    bytes body() {
        bytes made, content;
        put(content, general());
        put_category(made, ethercat::sii_category::general, std::move(content));
        content.clear();
        for (const auto& each : device_.fmmus) content.push_back(static_cast<std::byte>(fmmu_use(each)));
        put_category(made, ethercat::sii_category::fmmu, std::move(content));
        content.clear();
        for (std::size_t i = 0; i != device_.sync_managers.size(); ++i) put(content, manager(i));
        put_category(made, ethercat::sii_category::sync_manager, std::move(content));
        put_category(made, ethercat::sii_category::tx_pdo, pdos(device_.tx_pdos));
        put_category(made, ethercat::sii_category::rx_pdo, pdos(device_.rx_pdos));
        content.clear();
        for (const auto& each : device_.clock_modes)
            put(content, ethercat::sii_clock_mode{.cycle_time_0 = each.cycle_time_0,
                                                  .shift_time_0 = each.shift_time_0,
                                                  .shift_time_1 = each.shift_time_1,
                                                  .cycle_factor_1 = each.cycle_factor_1,
                                                  .assign_activate = each.assign_activate,
                                                  .cycle_factor_0 = each.cycle_factor_0,
                                                  .name = string(each.name),
                                                  .description = string(each.description)});
        put_category(made, ethercat::sii_category::dc, std::move(content));
        return made;
    }
    bool has_protocol(std::string_view name) const {
        return std::ranges::find(device_.protocols, name) != device_.protocols.end();
    }
    ethercat::sii_general general() {
        std::uint16_t ports = 0;
        for (std::size_t i = 0; i != std::min<std::size_t>(device_.physics.size(), 4); ++i) {
            constexpr std::uint16_t mii = 1, ebus = 3;
            const char kind = device_.physics[i];
            ports = static_cast<std::uint16_t>(ports | (kind == ' ' ? 0 : kind == 'K' ? ebus : mii) << (4 * i));
        }
        constexpr std::uint16_t two_mii = 0x0011;
        return {.group = string(device_.group_type),
                .order = string(device_.type),
                .name = string(device_.name),
                .sdo = device_.has_coe,
                .sdo_information = device_.coe.sdo_information,
                .pdo_assign = device_.coe.pdo_assign,
                .pdo_configuration = device_.coe.pdo_configuration,
                .complete_access = device_.coe.complete_access,
                .foe = static_cast<std::uint8_t>(has_protocol("FoE") ? 1 : 0),
                .eoe = static_cast<std::uint8_t>(has_protocol("EoE") ? 1 : 0),
                .ports = device_.physics.empty() ? two_mii : ports};
    }
    static ethercat::sii_fmmu_use fmmu_use(std::string_view text) {
        if (text.ends_with("Outputs")) return ethercat::sii_fmmu_use::outputs; // DynamicOutputs, too
        if (text.ends_with("Inputs")) return ethercat::sii_fmmu_use::inputs;
        return text == "MBoxState" ? ethercat::sii_fmmu_use::mailbox_state : ethercat::sii_fmmu_use::none;
    }
    ethercat::sii_sync_manager manager(std::size_t i) const {
        const auto& each = device_.sync_managers[i];
        const auto enable = (each.enabled ? ethercat::sii_enable::enabled : 0) |
                            (each.is_virtual ? ethercat::sii_enable::virtual_manager : 0);
        return {.start = each.start,
                .length = static_cast<std::uint16_t>(data_size(device_, i)),
                .control = each.control,
                .enable = static_cast<std::uint8_t>(enable),
                .use = each.use};
    }
    bytes pdos(const std::vector<pdo>& all) {
        bytes made;
        for (const auto& each : all) {
            constexpr std::uint16_t mandatory = 0x0001, fixed = 0x0010;
            put(made, ethercat::sii_pdo{.index = each.index,
                                        .entries = static_cast<std::uint8_t>(each.entries.size()),
                                        .sync_manager = each.sync_manager,
                                        .name = string(each.name),
                                        .flags = static_cast<std::uint16_t>((each.mandatory ? mandatory : 0) |
                                                                            (each.fixed ? fixed : 0))});
            for (const auto& entry : each.entries)
                put(made, ethercat::sii_pdo_entry{.index = entry.index,
                                                  .subindex = entry.subindex,
                                                  .name = string(entry.name),
                                                  .data_type = static_cast<std::uint8_t>(parse_data_type(entry.type)),
                                                  .bits = static_cast<std::uint8_t>(entry.bits)});
        }
        return made;
    }

    void put_fixed_words() {
        put_at(ethercat::sii_words::configuration, configuration_of(device_.eeprom));
        put_at(ethercat::sii_words::identity,
               ethercat::sii_identity{device_.vendor_id, device_.product_code, device_.revision, device_.serial});
        constexpr std::size_t bootstrap_word = 0x14, bootstrap_size = 8;
        std::ranges::copy_n(device_.eeprom.bootstrap.begin(),
                            static_cast<std::ptrdiff_t>(std::min(device_.eeprom.bootstrap.size(), bootstrap_size)),
                            made_.begin() + 2 * bootstrap_word);
        ethercat::sii_mailbox mailbox{.aoe = has_protocol("AoE"),
                                      .eoe = has_protocol("EoE"),
                                      .coe = device_.has_coe,
                                      .foe = has_protocol("FoE"),
                                      .soe = has_protocol("SoE"),
                                      .voe = has_protocol("VoE")};
        for (const auto& each : device_.sync_managers) {
            if (each.use == ethercat::sii_sync_manager_use::mailbox_out) {
                mailbox.receive_offset = each.start;
                mailbox.receive_size = each.default_size;
            } else if (each.use == ethercat::sii_sync_manager_use::mailbox_in) {
                mailbox.send_offset = each.start;
                mailbox.send_size = each.default_size;
            }
        }
        put_at(ethercat::sii_words::mailbox, mailbox);
        put_at(ethercat::sii_words::size,
               ethercat::sii_size{.kibit = static_cast<std::uint16_t>(made_.size() * 8 / 1024 - 1), .version = 1});
    }

    const device& device_;
    std::vector<std::string> strings_{};
    bytes made_{};
};

} // namespace detail

inline namespace JAUSCAT_WAY {

JAUSCAT_DECL ethercat::sii_configuration configuration_of(const eeprom& memory) {
    ethercat::sii_configuration made{.pdi_control = ethercat::sii_pdi_control};
    std::array<std::byte, wire::max_size<ethercat::sii_configuration>> words{};
    const auto checked = std::span{words}.first(ethercat::sii_configuration_checked);
    if (memory.config_data.empty()) {
        static_cast<void>(wire::encode(made, words));
    } else {
        const auto given = std::min(memory.config_data.size(), checked.size());
        std::ranges::copy_n(memory.config_data.begin(), static_cast<std::ptrdiff_t>(given), words.begin());
        static_cast<void>(wire::decode(made, words));
    }
    made.checksum = ethercat::sii_checksum(checked);
    return made;
}

JAUSCAT_DECL std::size_t data_size(const device& of, std::size_t manager) {
    std::size_t bits = 0;
    bool has_pdos = false;
    for (const auto* const all : {&of.rx_pdos, &of.tx_pdos})
        for (const auto& each : *all) {
            if (each.sync_manager != manager) continue;
            has_pdos = true;
            for (const auto& entry : each.entries) bits += entry.bits;
        }
    return has_pdos ? (bits + 7) / 8 : of.sync_managers[manager].default_size;
}

JAUSCAT_DECL std::vector<std::byte> device_sii(const device& of) {
    if (!of.eeprom.image.empty()) return of.eeprom.image;
    return detail::device_sii_writer{of}.write();
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::esi
