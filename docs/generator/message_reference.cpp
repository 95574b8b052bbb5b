// Writes docs/messages: every message of RA 3.3 and of SAE JAUS with its bytes, fields and place in the translation
// tables, from the schemas.
#include "describe.hpp"
#include "diagram.hpp"
#include "page.hpp"
#include "sae_pages.hpp"
#include "words.hpp"
#include <jauscat/catalogue/ra_3_3.hpp>
#include <jauscat/catalogue/sae.hpp>
#include <jauscat/schema/translation/index_bases.hpp>
#include <jauscat/schema/translation/sae_ranks.hpp>
#include <jauscat/schema/translation/seed_table.hpp>
#include <jauscat/translate/translator.hpp>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <span>

namespace {

using namespace jauscat;
using files = std::map<std::filesystem::path, std::string>; // what is to be in the folder, by name in it

reference::sae_set described(const std::string& file, const std::string& title, const std::string& folder,
                             const std::string& prefix, const std::vector<catalogue::entry>& entries,
                             const std::filesystem::path& schemas) {
    std::string scope = "jauscat::" + folder;
    if (const auto slash = scope.find('/'); slash != std::string::npos) scope.replace(slash, 1, "::");
    reference::sae_set set{.file = file,
                           .title = title,
                           .scope = std::move(scope),
                           .schemas = "schema/" + folder,
                           .from = reference::remarks{schemas / "jauscat/schema" / folder}};
    for (const catalogue::entry& entry : entries) {
        const std::uint16_t code = entry.command_code();
        auto remark = set.from.of_sae_message(std::string{entry.name()}, reference::code_digits(code));
        const unsigned segment = translation::sae_segments::find(code).segment;
        set.messages.push_back({reference::described_sae(entry, remark.name, prefix), remark,
                                static_cast<unsigned>(translation::manufacturer_index_base) + 0x100 * segment});
    }
    return set;
}

/// Messages of version 1.0 with other bytes.
std::vector<catalogue::entry> of_mobility_1_0_alone() {
    std::vector<catalogue::entry> made;
    for (const catalogue::entry& entry : catalogue::sae_mobility_1_0())
        if (*catalogue::sae_mobility_1_1().find(entry.command_code()) != entry) made.push_back(entry);
    return made;
}

void add_sae(files& made, const std::filesystem::path& schemas) {
    const auto all = [](const catalogue::list& list) { return std::vector(list.begin(), list.end()); };
    const std::filesystem::path folder{"sae"};
    std::vector<reference::sae_set> sets;
    const auto add = [&](const std::string& file, const std::string& title, const std::string& from,
                         const std::string& prefix, const std::vector<catalogue::entry>& entries) {
        sets.push_back(described(file, title, from, prefix, entries, schemas));
    };
    add("core", "Core 1.1", "sae/core", "sae_", all(catalogue::sae_core_1_1()));
    add("mobility", "Mobility 1.1", "sae/mobility", "sae_", all(catalogue::sae_mobility_1_1()));
    add("mobility_1_0", "Mobility 1.0", "sae_1_0/mobility", "sae_1_0_", of_mobility_1_0_alone());
    add("environment_sensing", "Environment sensing 2.0", "sae/environment_sensing", "sae_",
        all(catalogue::sae_environment_sensing_2_0()));
    add("manipulator", "Manipulator 2.0", "sae/manipulator", "sae_", all(catalogue::sae_manipulator_2_0()));
    add("ugv", "Unmanned ground vehicles 1.0", "sae/ugv", "sae_", all(catalogue::sae_ground_vehicle_1_0()));
    for (const auto& set : sets) {
        made[folder / (set.file + ".md")] = reference::sae_page(set);
        for (const auto& one : set.messages) made[folder / one.diagram] = reference::diagram(one.parts, one.name);
    }
    made[folder / "README.md"] = reference::sae_index_page(sets);
}

files made_from(const std::filesystem::path& schemas) {
    using translator = translate::translator<translation::seed_table>;
    const reference::translation table{.index_base = translation::seed_index_base,
                                       .packet = translator::packet_size + translator::rest_size,
                                       .largest_body = translator::max_body};
    const reference::remarks from{schemas / "jauscat/schema/jaus"};
    std::vector<reference::message> messages;
    for (const catalogue::entry& entry : catalogue::ra_3_3()) messages.push_back(reference::described(entry));
    files made;
    std::set<std::string> headers;
    for (const reference::message& one : messages) {
        headers.insert(from.header_of(one.structure));
        if (!one.parts.empty()) made[one.diagram] = reference::diagram(one.parts, one.name);
    }
    for (const std::string& header : headers) made[header + ".md"] = reference::page(header, messages, from, table);
    made["README.md"] = reference::index_page(messages, from, table);
    add_sae(made, schemas);
    return made;
}

std::string content_of(const std::filesystem::path& file) {
    std::ifstream in{file, std::ios::binary};
    return {std::istreambuf_iterator<char>{in}, {}};
}

/// Files of the folder that differ from what is made: missing, changed, or too many.
std::vector<std::filesystem::path> outdated(const files& made, const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> found;
    for (const auto& [name, content] : made)
        if (content_of(folder / name) != content) found.push_back(name);
    if (std::filesystem::exists(folder))
        for (const auto& entry : std::filesystem::recursive_directory_iterator{folder})
            if (const auto name = entry.path().lexically_relative(folder);
                entry.is_regular_file() && !made.contains(name))
                found.push_back(name);
    return found;
}

void update(const files& made, const std::filesystem::path& folder) {
    for (const auto& name : outdated(made, folder)) {
        const auto file = folder / name;
        if (const auto place = made.find(name); place != made.end()) {
            std::filesystem::create_directories(file.parent_path());
            std::ofstream{file, std::ios::binary} << place->second;
        } else {
            std::filesystem::remove(file);
        }
        std::cout << file.string() << '\n';
    }
}

} // namespace

int main(int count, char** words) try {
    const std::vector<std::string_view> arguments(words + 1, words + count);
    const bool check = arguments.size() == 3 && arguments[2] == "--check";
    if (arguments.size() != 2 && !check) {
        std::cerr
            << "usage: message_reference SCHEMAS FOLDER [--check]\n"
               "Writes the message reference to FOLDER, from the catalogue it was compiled with and the comments in\n"
               "SCHEMAS. With --check writes nothing, names the files that are not current, and fails if there "
               "are any.\n";
        return 2;
    }
    const std::filesystem::path folder{arguments[1]};
    const files made = made_from(arguments[0]);
    if (!check) {
        update(made, folder);
        return 0;
    }
    const auto found = outdated(made, folder);
    for (const auto& name : found) std::cerr << (folder / name).string() << " is not current\n";
    if (!found.empty()) std::cerr << "run scripts/message-reference\n";
    return found.empty() ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << "message_reference: " << error.what() << '\n';
    return 1;
}
