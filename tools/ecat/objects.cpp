// read, write, sdos: objects of one slave.
#include "ecat/arguments.hpp"
#include "ecat/mailbox.hpp"
#include "ecat/object_types.hpp"
#include "ecat/value.hpp"

#include <algorithm>

namespace ecat {

namespace {

using ethercat::master_errc;

bool is_abort(const coe_failure& error) { return error.error.code == master_errc::sdo_abort; }

/// The type of an entry: as given, as the slave states, or by its size.
const object_type& chosen_type(const arguments& given, const std::optional<entry_text>& about, std::size_t size) {
    if (!given.type.empty()) return type_named(given.type);
    const auto* const stated = about ? type_of(about->is.data_type) : nullptr;
    return stated != nullptr ? *stated : guessed_type(size * 8);
}

/// With the value, or the slave's abort code.
record row_of(std::uint16_t position, std::uint16_t index, std::uint8_t subindex) {
    return {{"position", position},
            {"object", place_text(index, subindex)},
            {"index", hex_value(index, 4)},
            {"subindex", subindex}};
}

void append(record& row, const std::string& name, const std::string& type, value v, const bytes& data) {
    row.emplace_back("name", name);
    row.emplace_back("type", type);
    row.emplace_back("value", std::move(v));
    row.emplace_back("bytes", hex_bytes(data));
    row.emplace_back("abort_code", value{});
}
void append_abort(record& row, const std::string& name, const std::string& type, const ethercat::master_error& why) {
    row.emplace_back("name", name);
    row.emplace_back("type", type);
    row.emplace_back("value", value{std::monostate{}, reason_text(why)});
    row.emplace_back("bytes", "");
    row.emplace_back("abort_code", static_cast<std::uint32_t>(why.abort));
}

void print(const arguments& given, const std::vector<record>& rows) {
    if (given.is_json)
        print_json(list{rows.begin(), rows.end()});
    else
        print_table(rows, {"position", "index", "subindex", "bytes", "abort_code"});
}

} // namespace

int read(const arguments& given) {
    std::vector<object_range> ranges;
    for (const auto& each : given.words) ranges.push_back(parse_range(each));
    if (!given.type.empty()) static_cast<void>(type_named(given.type));
    ring on{given.link};
    on.guard();
    const auto position = chosen_slave(given, on);
    std::vector<record> rows;
    bool is_complete = true;
    {
        coe_mailbox mailbox{on, position};
        progress_line progress;
        for (const auto& range : ranges) {
            for (unsigned subindex = range.first; subindex <= range.last; ++subindex) {
                if (stop_requested()) throw failure{"interrupted"};
                const auto sub = static_cast<std::uint8_t>(subindex);
                progress.show("object " + place_text(range.index, sub));
                const auto about = mailbox.try_describe(range.index, sub);
                const auto name = about ? about->name : std::string{};
                auto row = row_of(position, range.index, sub);
                try {
                    const auto data = mailbox.upload(range.index, sub);
                    const auto& type = chosen_type(given, about, data.size());
                    append(row, name, std::string{type.name}, to_value(type, data), data);
                } catch (const coe_failure& error) {
                    if (!is_abort(error)) throw;
                    note(error.what());
                    is_complete = false;
                    append_abort(row, name, about ? type_text(about->is.data_type) : std::string{}, error.error);
                }
                rows.push_back(std::move(row));
            }
        }
    }
    print(given, rows);
    return is_complete ? success : failed;
}

int write(const arguments& given) {
    const auto place = parse_range(given.words.at(0));
    if (place.first != place.last) throw usage_error{"write takes one entry, such as 0x6060:0"};
    const auto& text = given.words.at(1);
    // What is wrong with the value of a given type is wrong without a bus, too.
    if (!given.type.empty()) static_cast<void>(to_bytes(type_named(given.type), text));
    ring on{given.link};
    on.guard();
    const auto position = chosen_slave(given, on);
    coe_mailbox mailbox{on, position};
    const auto about = mailbox.try_describe(place.index, place.first);
    const object_type* type = given.type.empty() ? nullptr : &type_named(given.type);
    if (type == nullptr && about) type = type_of(about->is.data_type);
    if (type == nullptr)
        throw usage_error{"the slave does not state the type of object " + place_text(place.index, place.first) +
                          ": give it by --type"};
    const auto data = to_bytes(*type, text);
    if (about && about->is.data_type == type->code) check_limits(*type, data, about->minimum, about->maximum);
    const auto shown = to_value(*type, data).text();
    confirm(given, "Write " + shown + " (" + std::string{type->name} + ") to object " +
                       place_text(place.index, place.first) +
                       (about && !about->name.empty() ? " " + about->name : std::string{}) + " of " +
                       on.name_of(position) + "?");
    mailbox.download(place.index, place.first, data);
    auto row = row_of(position, place.index, place.first);
    const auto name = about ? about->name : std::string{};
    try {
        const auto now = mailbox.upload(place.index, place.first);
        append(row, name, std::string{type->name}, to_value(*type, now), now);
        if (now != data)
            note(on.name_of(position) + ": object " + place_text(place.index, place.first) +
                 " was written, but has another value when it is read back");
    } catch (const coe_failure& error) {
        if (!is_abort(error)) throw; // it may be write-only
        append_abort(row, name, std::string{type->name}, error.error);
    }
    print(given, {row});
    return success;
}

namespace {

std::string access_text(const ethercat::entry_access& access) {
    const auto one = [](bool read, bool write) { return std::string{read ? "r" : "-"} + (write ? "w" : "-"); };
    return one(access.read_pre_op, access.write_pre_op) + " " + one(access.read_safe_op, access.write_safe_op) + " " +
           one(access.read_op, access.write_op);
}

const char* mapping_text(const ethercat::entry_access& access) {
    if (access.rx_pdo && access.tx_pdo) return "RxPDO TxPDO";
    return access.rx_pdo ? "RxPDO" : access.tx_pdo ? "TxPDO" : "";
}

const char* code_text(ethercat::object_code code) {
    switch (code) {
    case ethercat::object_code::variable: return "variable";
    case ethercat::object_code::array: return "array";
    case ethercat::object_code::record: return "record";
    }
    return "other";
}

/// Entries that `sdos` describes at most: a faulty slave may state 256 for each of 65,536 objects.
constexpr std::size_t max_entries = 16'384;

/// A word such as `0x6000-0x6FFF`; all objects without one.
std::pair<std::uint64_t, std::uint64_t> index_range(const arguments& given) {
    if (given.words.empty()) return {0, 0xFFFF};
    const auto& text = given.words.front();
    const auto dash = text.find('-');
    const auto first = parse_number(std::string_view{text}.substr(0, dash), 0xFFFF);
    const auto last = dash == text.npos ? first : parse_number(std::string_view{text}.substr(dash + 1), 0xFFFF);
    if (!first || !last || *last < *first)
        throw usage_error{"'" + text +
                          "' is no range of objects: expected INDEX or INDEX-INDEX, such as 0x6000-0x6FFF"};
    return {*first, *last};
}

} // namespace

int sdos(const arguments& given) {
    const auto [first, last] = index_range(given);
    ring on{given.link};
    on.guard();
    const auto position = chosen_slave(given, on);
    list objects;
    std::vector<record> rows;
    {
        coe_mailbox mailbox{on, position};
        std::vector<std::uint16_t> indices;
        try {
            indices = mailbox.objects();
        } catch (const coe_failure& error) {
            throw failure{std::string{error.what()} +
                          "; the slave has no SDO information: read its objects by number, or use its ESI file"};
        }
        std::erase_if(indices, [first = first, last = last](std::uint16_t i) { return i < first || i > last; });
        progress_line progress;
        std::size_t entry_count = 0;
        for (std::size_t i = 0; i != indices.size(); ++i) {
            const auto index = indices[i];
            progress.show("object " + hex(index, 4) + ", " + std::to_string(i + 1) + " of " +
                          std::to_string(indices.size()));
            if (stop_requested()) throw failure{"interrupted"};
            object_text object;
            try {
                object = mailbox.describe(index);
            } catch (const coe_failure& error) {
                if (!is_abort(error)) throw;
                note(error.what());
                continue;
            }
            entry_count += object.is.highest_subindex + std::size_t{1};
            if (entry_count > max_entries)
                throw failure{on.name_of(position) + ": object " + hex(index, 4) + ": the slave states more than " +
                              std::to_string(max_entries) +
                              " entries: name fewer objects, such as jauscat-ecat sdos 0x6000-0x6FFF"};
            list entries;
            for (unsigned subindex = 0; subindex <= object.is.highest_subindex; ++subindex) {
                const auto sub = static_cast<std::uint8_t>(subindex);
                const auto about = mailbox.try_describe(index, sub);
                if (!about) continue; // a gap
                record entry{{"subindex", sub},
                             {"name", about->name},
                             {"type", type_text(about->is.data_type)},
                             {"bits", about->is.bits},
                             {"access", access_text(about->is.access)},
                             {"pdo", mapping_text(about->is.access)}};
                if (given.entries) {
                    value content;
                    try {
                        const auto data = mailbox.upload(index, sub);
                        const auto* const type = type_of(about->is.data_type);
                        content = to_value(type != nullptr ? *type : guessed_type(data.size() * 8), data);
                    } catch (const coe_failure& error) {
                        if (!is_abort(error)) throw;
                        content = value{std::monostate{}, reason_text(error.error)};
                    }
                    entry.emplace_back("value", content);
                }
                record row{{"object", place_text(index, sub)}};
                row.insert(row.end(), entry.begin() + 1, entry.end());
                if (sub == 0 && object.is.highest_subindex != 0) row[1].second = object.name;
                if (sub != 0) row[1].second = "  " + about->name;
                rows.push_back(std::move(row));
                entries.emplace_back(std::move(entry));
            }
            objects.emplace_back(record{{"index", index},
                                        {"name", object.name},
                                        {"code", code_text(object.is.code)},
                                        {"highest_subindex", object.is.highest_subindex},
                                        {"entries", entries}});
        }
    }
    if (given.is_json)
        print_json(objects);
    else
        print_table(rows);
    return success;
}

} // namespace ecat
