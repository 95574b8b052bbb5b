#include "ecat/sii.hpp"

#include "ecat/value.hpp"
#include <jauscat/net/now.hpp>

#include <algorithm>
#include <array>
#include <unistd.h>

namespace ecat {

namespace registers = ethercat::esc_registers;
using ethercat::sii_category;
using std::chrono::milliseconds;

sii_reader::sii_reader(ring& on, std::uint16_t position) : ring_{on}, position_{position} {
    const auto owner = ring_.read(position_, registers::sii_owner.address, 2);
    if ((owner[1] & std::byte{1}) != std::byte{})
        throw failure{ring_.name_of(position_) + ": the SII is being used by the slave's application: try again"};
    static_cast<void>(wait_until_ready());
    was_applications_ = (owner[0] & std::byte{1}) != std::byte{};
    if (was_applications_) ring_.write(position_, registers::sii_owner, {});
}

sii_reader::~sii_reader() {
    if (!was_applications_) return;
    try {
        ring_.write(position_, registers::sii_owner, {.pdi = true});
    } catch (const std::exception& error) {
        note(error.what());
    }
}

ethercat::sii_access sii_reader::wait_until_ready() {
    const auto end = jauscat::net::now() + milliseconds{100};
    for (;;) {
        const auto now = ring_.read(position_, registers::sii_access);
        if (!now.request.busy) return now;
        if (jauscat::net::now() >= end)
            throw failure{ring_.name_of(position_) +
                          ": the SII stays busy: another master uses it, or the slave needs a restart"};
        ::usleep(100);
    }
}

void sii_reader::fetch(std::uint32_t word) {
    if (stop_requested()) throw failure{"interrupted"};
    ring_.write(position_, registers::sii_request, {.cmd = ethercat::sii_command::read, .address = word});
    const auto got = wait_until_ready();
    const auto where = ring_.name_of(position_) + ": SII word " + hex(word, 4) + ": ";
    if (got.request.command_error) throw failure{where + "the memory does not answer: check its EEPROM"};
    if (got.request.address != word) throw failure{where + "another master reads the SII", bus_in_use};
    const std::size_t size = got.request.eight_byte_reads ? 8 : 4;
    for (std::size_t i = 0; i != size; i += 2)
        words_[word + static_cast<std::uint32_t>(i / 2)] = {got.data[i], got.data[i + 1]};
    if (on_access) on_access();
}

bytes sii_reader::read(std::uint32_t word, std::size_t size) {
    bytes made;
    for (; made.size() < size; ++word) {
        if (!words_.contains(word)) fetch(word);
        made.insert(made.end(), words_[word].begin(), words_[word].end());
    }
    made.resize(size);
    return made;
}

const char* category_name(sii_category category) {
    switch (category) {
    case sii_category::device_specific: return "device specific";
    case sii_category::fmmu_extension: return "FMMUX";
    case sii_category::sync_unit: return "SyncUnit";
    case sii_category::strings: return "strings";
    case sii_category::general: return "general";
    case sii_category::fmmu: return "FMMU";
    case sii_category::sync_manager: return "SyncM";
    case sii_category::tx_pdo: return "TxPDO";
    case sii_category::rx_pdo: return "RxPDO";
    case sii_category::dc: return "DC";
    case sii_category::end: return "end";
    }
    return "other";
}

std::string sii_content::string(std::size_t number) const {
    return number == 0 || number > strings.size() ? std::string{} : strings[number - 1];
}

namespace {

template <class T> std::optional<T> take(std::span<const std::byte>& data) {
    constexpr auto size = jauscat::wire::max_size<T>;
    if (data.size() < size) return {};
    const auto made = decoded<T>(data);
    data = data.subspan(size);
    return made;
}

void add_strings(sii_content& to, std::span<const std::byte> data) {
    if (data.empty()) return;
    auto count = std::to_integer<std::size_t>(data.front());
    data = data.subspan(1);
    for (; count != 0; --count) {
        const auto size = data.empty() ? std::size_t{0} : std::to_integer<std::size_t>(data.front());
        if (data.empty() || data.size() - 1 < size) {
            to.problems.emplace_back("strings: a string is longer than the category");
            return;
        }
        std::string text;
        for (const auto each : data.subspan(1, size)) text += static_cast<char>(each);
        to.strings.push_back(printable(text));
        data = data.subspan(1 + size);
    }
}

void add_pdos(sii_content& to, std::span<const std::byte> data, bool is_output) {
    while (const auto pdo = take<ethercat::sii_pdo>(data)) {
        sii_pdo_description made{.pdo = *pdo, .is_output = is_output};
        for (unsigned i = 0; i != pdo->entries; ++i) {
            const auto entry = take<ethercat::sii_pdo_entry>(data);
            if (!entry) {
                to.problems.push_back("PDO " + hex(pdo->index, 4) + ": has fewer entries than it states");
                break;
            }
            made.entries.push_back({.is = *entry});
        }
        to.pdos.push_back(made);
    }
}

void add(sii_content& to, const sii_part& part) {
    std::span<const std::byte> data{part.data};
    switch (part.category) {
    case sii_category::strings: add_strings(to, data); break;
    case sii_category::general:
        // The last bytes are reserved: older memories leave them out.
        {
            auto padded = part.data;
            padded.resize(std::max(padded.size(), jauscat::wire::max_size<ethercat::sii_general>));
            to.general = decoded<ethercat::sii_general>(padded);
        }
        break;
    case sii_category::fmmu:
        for (const auto each : data) to.fmmus.push_back(static_cast<ethercat::sii_fmmu_use>(each));
        break;
    case sii_category::sync_manager:
        while (const auto one = take<ethercat::sii_sync_manager>(data)) to.sync_managers.push_back(*one);
        break;
    case sii_category::tx_pdo: add_pdos(to, data, false); break;
    case sii_category::rx_pdo: add_pdos(to, data, true); break;
    default: break;
    }
}

std::uint8_t checksum(std::span<const std::byte> data) {
    unsigned crc = 0xFF;
    for (const auto each : data) {
        crc ^= std::to_integer<unsigned>(each);
        for (int bit = 0; bit != 8; ++bit) crc = (crc & 0x80) != 0 ? crc << 1 ^ 0x07 : crc << 1;
        crc &= 0xFF;
    }
    return static_cast<std::uint8_t>(crc);
}

} // namespace

sii_content read_sii(sii_reader& reader, sii_depth depth) {
    sii_content made;
    made.identity = reader.read<ethercat::sii_identity>(ethercat::sii_words::identity);
    if (depth == sii_depth::all) {
        const auto head = reader.read(ethercat::sii_words::configuration, 16);
        made.configuration = decoded<ethercat::sii_configuration>(head);
        made.is_checksum_right = checksum(std::span{head}.first(ethercat::sii_configuration_checked)) ==
                                 (made.configuration.checksum & 0xFF);
        made.mailbox = reader.read<ethercat::sii_mailbox>(ethercat::sii_words::mailbox);
        made.size = reader.read<ethercat::sii_size>(ethercat::sii_words::size);
    }
    constexpr std::uint32_t end_of_memory = 0x8000; // words of the largest one
    constexpr unsigned max_categories = 100;        // an erased memory has thousands
    std::uint32_t word = ethercat::sii_words::categories;
    for (unsigned count = 0;; ++count) {
        const auto header = reader.read<ethercat::sii_category_header>(word);
        word += 2;
        if (header.category == sii_category::end) break;
        if (count == max_categories || word + header.words > end_of_memory) {
            made.problems.push_back("the categories have no end: word " + hex(word - 2, 4));
            break;
        }
        const bool is_wanted = depth == sii_depth::all || header.category == sii_category::strings ||
                               header.category == sii_category::general;
        if (is_wanted) {
            made.parts.push_back({header.category, word, reader.read(word, header.words * std::size_t{2})});
            add(made, made.parts.back());
        }
        word += header.words;
        if (depth == sii_depth::name && made.general && !made.strings.empty()) break;
    }
    made.used = word * std::size_t{2};
    for (auto& pdo : made.pdos) { // the strings may stand behind them
        pdo.name = made.string(pdo.pdo.name);
        for (auto& each : pdo.entries) each.name = made.string(each.is.name);
    }
    return made;
}

} // namespace ecat
