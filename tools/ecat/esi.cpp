// esi: a slave compared with the device of an ESI file.
#include "ecat/arguments.hpp"
#include "ecat/mailbox.hpp"
#include "ecat/object_types.hpp"
#include "ecat/process_objects.hpp"
#include "ecat/sii.hpp"
#include "ecat/value.hpp"
#include <jauscat/esi/read_esi.hpp>
#include <jauscat/esi/text_values.hpp>

#include <algorithm>
#include <iostream>
#include <set>

namespace ecat {

namespace {

namespace files = jauscat::esi;

class comparison {
  public:
    void add(const std::string& what, const std::string& file, const std::string& slave) {
        const bool is_same = file == slave;
        if (!is_same) ++differences_;
        rows_.push_back({{"what", what}, {"same", is_same}, {"file", file}, {"slave", slave}});
    }
    /// One line where both are the same, two where they differ.
    void print() const {
        constexpr std::size_t width = 16, longest = 90;
        for (const auto& row : rows_) {
            const auto what =
                row[0].second.text() + std::string(width - std::min(width, row[0].second.text().size()), ' ');
            const auto file = row[2].second.text();
            if (std::get<bool>(row[1].second.data()))
                std::cout << "same     " << what << file.substr(0, longest) << (file.size() > longest ? " ..." : "")
                          << "\n";
            else
                std::cout << "DIFFERS  " << what << "file:  " << file << "\n"
                          << std::string(9 + width, ' ') << "slave: " << row[3].second.text() << "\n";
        }
    }
    [[nodiscard]] const std::vector<record>& rows() const noexcept { return rows_; }
    [[nodiscard]] std::size_t differences() const noexcept { return differences_; }

  private:
    std::vector<record> rows_{};
    std::size_t differences_{};
};

constexpr const char* absent = "none";

const char* use_text(ethercat::sii_sync_manager_use use) {
    switch (use) {
    case ethercat::sii_sync_manager_use::none: return "none";
    case ethercat::sii_sync_manager_use::mailbox_out: return "MBoxOut";
    case ethercat::sii_sync_manager_use::mailbox_in: return "MBoxIn";
    case ethercat::sii_sync_manager_use::outputs: return "Outputs";
    case ethercat::sii_sync_manager_use::inputs: return "Inputs";
    }
    return "other";
}
std::string use_text(ethercat::sii_fmmu_use use) {
    switch (use) {
    case ethercat::sii_fmmu_use::none: return absent;
    case ethercat::sii_fmmu_use::outputs: return "Outputs";
    case ethercat::sii_fmmu_use::inputs: return "Inputs";
    case ethercat::sii_fmmu_use::mailbox_state: return "MBoxState";
    }
    return "other";
}
std::string manager_text(ethercat::sii_sync_manager_use use, std::uint16_t start, std::uint16_t size,
                         std::uint8_t control) {
    return std::string{use_text(use)} + ", start " + hex(start, 4) + ", " + std::to_string(size) + " bytes, control " +
           hex(control, 2);
}

void compare_sii(comparison& to, const files::device& file, const sii_content& sii) {
    to.add("vendor", hex(file.vendor_id, 8), hex(sii.identity.vendor, 8));
    to.add("product", hex(file.product_code, 8), hex(sii.identity.product, 8));
    to.add("revision", hex(file.revision, 8), hex(sii.identity.revision, 8));
    if (file.serial != 0) to.add("serial", std::to_string(file.serial), std::to_string(sii.identity.serial));
    const auto at = [](const auto& all, std::size_t i) { return i < all.size() ? &all[i] : nullptr; };
    for (std::size_t i = 0; i != std::max(file.sync_managers.size(), sii.sync_managers.size()); ++i) {
        const auto* const ours = at(file.sync_managers, i);
        const auto* const theirs = at(sii.sync_managers, i);
        to.add("SyncManager " + std::to_string(i),
               ours != nullptr ? manager_text(ours->use, ours->start, ours->default_size, ours->control) : absent,
               theirs != nullptr ? manager_text(theirs->use, theirs->start, theirs->length, theirs->control) : absent);
    }
    std::string ours, theirs; // FMMUs without a use need not stand in the file
    for (const auto& each : file.fmmus) ours += (ours.empty() ? "" : ", ") + each;
    for (const auto each : sii.fmmus)
        if (const auto use = use_text(each); use != absent) theirs += (theirs.empty() ? "" : ", ") + use;
    to.add("FMMUs", ours.empty() ? absent : ours, theirs.empty() ? absent : theirs);
}

template <class Entries> std::string entries_text(std::uint8_t manager, const Entries& entries) {
    std::string text = manager == 255 ? "not assigned" : "SyncManager " + std::to_string(manager);
    for (const auto& each : entries)
        text += (&each == &entries.front() ? ": " : ", ") +
                (each.index != 0 ? place_text(each.index, each.subindex) : std::string{"gap"}) + "/" +
                std::to_string(each.bits);
    return text;
}

void compare_pdos(comparison& to, const files::device& file, const process_objects& slave) {
    std::set<std::uint16_t> seen;
    for (const auto* const all : {&file.rx_pdos, &file.tx_pdos})
        for (const auto& pdo : *all) {
            seen.insert(pdo.index);
            const auto found = std::ranges::find(slave.pdos, pdo.index, &assigned_pdo::index);
            to.add("PDO " + hex(pdo.index, 4), entries_text(pdo.sync_manager, pdo.entries),
                   found != slave.pdos.end() ? entries_text(found->sync_manager, found->entries) : absent);
        }
    for (const auto& pdo : slave.pdos)
        if (!seen.contains(pdo.index))
            to.add("PDO " + hex(pdo.index, 4), absent, entries_text(pdo.sync_manager, pdo.entries));
}

void compare_object(comparison& to, const files::object& file, coe_mailbox& mailbox) {
    std::string ours, theirs;
    for (const auto& entry : file.entries) {
        const auto about = mailbox.try_describe(file.index, entry.subindex);
        // A text has a largest size in the file, and its own at the slave.
        const auto fits = about && files::is_string_type(entry.type) && about->is.bits <= entry.bit_size;
        const auto place = (ours.empty() ? "" : ", ") + hex(entry.subindex, 2).substr(2) + "/";
        const auto size = std::to_string(entry.bit_size);
        ours += place + size;
        theirs += place + (!about ? absent : fits ? size : std::to_string(about->is.bits));
    }
    to.add("object " + hex(file.index, 4), ours, theirs);
}

void compare_objects(comparison& to, ring& on, std::uint16_t position, const files::device& file) {
    coe_mailbox mailbox{on, position};
    std::vector<std::uint16_t> indices;
    try {
        indices = mailbox.objects();
    } catch (const coe_failure& error) {
        note(std::string{error.what()} + "; objects are not compared");
        return;
    }
    const std::set<std::uint16_t> theirs{indices.begin(), indices.end()};
    std::set<std::uint16_t> ours;
    progress_line progress;
    for (const auto& object : file.objects) {
        if (stop_requested()) throw failure{"interrupted"};
        progress.show("object " + hex(object.index, 4));
        ours.insert(object.index);
        if (theirs.contains(object.index))
            compare_object(to, object, mailbox);
        else
            to.add("object " + hex(object.index, 4), object.name, absent);
    }
    for (const auto index : theirs)
        if (!ours.contains(index)) to.add("object " + hex(index, 4), absent, "there");
}

/// The device of the file that the slave is; the only one that there is also describes another slave, to be compared.
files::device described(const files::esi_file& file, const ethercat::sii_identity& slave) {
    auto read =
        file.devices().size() == 1 ? file.read() : file.read({.product = slave.product, .revision = slave.revision});
    if (!read) throw failure{read.error().message};
    for (const auto& each : read->slips) note("left out: " + each.message);
    return *std::move(read);
}

} // namespace

int esi(const arguments& given) {
    const auto& path = given.words.front();
    const auto all_devices = files::esi_file::open(path);
    if (!all_devices) throw failure{all_devices.error().message};
    ring on{given.link};
    on.guard();
    const auto position = chosen_slave(given, on);
    comparison all;
    sii_content sii;
    {
        sii_reader reader{on, position};
        sii = read_sii(reader, sii_depth::all);
    }
    for (const auto& each : sii.problems) note(on.name_of(position) + ": SII: " + each);
    const auto file = described(*all_devices, sii.identity);
    compare_sii(all, file, sii);
    compare_pdos(all, file, read_process_objects(on, position, true));
    if (sii.mailbox.coe) compare_objects(all, on, position, file);
    if (given.is_json) {
        print_json(list{all.rows().begin(), all.rows().end()});
    } else {
        all.print();
        std::cout << on.name_of(position) << " and " << path << ": " << all.rows().size() - all.differences() << " of "
                  << all.rows().size() << " are the same\n";
    }
    return all.differences() == 0 ? success : failed;
}

} // namespace ecat
