#include "sae_pages.hpp"

#include "page.hpp"
#include "table.hpp"
#include "words.hpp"
#include <jauscat/schema/ethercat/hilscher.hpp>
#include <jauscat/wire/item.hpp>

#include <map>

namespace jauscat::reference {

namespace {

/// Of the data of an SDO: header fields and sequence number, without the message ID.
constexpr std::size_t bytes_beside_payload = 7;

std::string heading(const sae_message& one) { return code_text(one.code) + " " + one.name; }
std::string link(const sae_message& one, const std::string& page) {
    return "[" + one.name + "](" + page + "#" + anchor(heading(one)) + ")";
}
std::string page_of(const sae_set& set) { return set.file + ".md"; }
std::string object_of(const sae_message& one) { return code_text(static_cast<std::uint16_t>(one.object)); }

/// By service, its inputs and outputs.
struct service_messages {
    std::vector<const sae_message*> inputs{}, outputs{};
};
std::map<std::string, service_messages> services_of(const sae_set& set) {
    std::map<std::string, service_messages> made;
    for (const auto& one : set.messages)
        for (const auto& service : one.remark.services)
            (service.is_input ? made[service.name].inputs : made[service.name].outputs).push_back(&one);
    return made;
}

/// The services of a set with links to their messages.
std::string service_table(const sae_set& set, const std::string& page) {
    const auto links = [&](const std::vector<const sae_message*>& messages) {
        std::string made;
        for (const auto* const one : messages) made += (made.empty() ? "" : ", ") + link(*one, page);
        return made;
    };
    table services({"Service", "Inputs", "Outputs"});
    for (const auto& [name, messages] : services_of(set))
        services.add({name, links(messages.inputs), links(messages.outputs)});
    return services.text();
}

std::string section(const sae_message& one, const sae_set& set) {
    const std::size_t most = std::min(wire::total_size(one.most, bytes_beside_payload), hilscher::max_sdo_data);
    return "## " + heading(one) + "\n\n" + capitalised(one.remark.role) + ".\n\n**payload: " + body_size(one) +
           "** · object " + object_of(one) + " + component, subindex " + std::to_string(one.rank) +
           " · SDO data: " + amount(one.least + bytes_beside_payload, most) + " bytes · " +
           code(set.scope + "::" + one.structure) + "\n\n![Bytes of " + one.name + "](" + one.diagram + ")\n\n" +
           field_table(one, set.from);
}

} // namespace

std::string sae_page(const sae_set& set) {
    std::string made = std::string{made_by} + "# " + set.title + "\n\nMessages of " + code(set.schemas) +
                       "; [README.md](README.md) explains the pages.\n\n" + service_table(set, "") + "\n";
    for (const auto& one : set.messages) made += section(one, set);
    while (made.ends_with("\n\n")) made.pop_back();
    return made;
}

std::string sae_index_page(const std::vector<sae_set>& sets) {
    table by_id({"ID", "Message", "Payload", "Object", "Subindex", "Set"});
    std::multimap<std::pair<std::uint16_t, std::string>, std::vector<std::string>> ids;
    std::multimap<std::string, std::string> names;
    std::string services;
    for (const auto& set : sets) {
        const std::string page = page_of(set), set_link = "[" + set.title + "](" + page + ")";
        services += "### " + set_link + "\n\n" + service_table(set, page) + "\n";
        for (const auto& one : set.messages) {
            ids.insert({{one.code, set.title},
                        {code_text(one.code), link(one, page), body_size(one), object_of(one), std::to_string(one.rank),
                         set_link}});
            names.insert({one.name, "- " + link(one, page) + ", " + code_text(one.code) + ", " + set.title + "\n"});
        }
    }
    for (const auto& [id, row] : ids) by_id.add(row);
    std::string by_name;
    for (const auto& [name, line] : names) by_name += line;
    return std::string{made_by} + R"(# Messages of SAE JAUS

Every message of the services that this library declares in `schemas/jauscat/schema/sae/`, [by service](#by-set-and-service), [by ID](#by-id)
and [by name](#by-name). [jaus-generations.md](../../jaus-generations.md) compares them with RA 3.3, whose messages are in
[another reference](../README.md).

[How to read the pages](../README.md#how-to-read-the-pages) is the same for both generations, with three differences: a payload begins
with the message ID, from which bytes are counted; a real number travels as an unsigned integer, 0 for its lower limit and all
ones for the upper one; a variant is preceded by the number of the form that follows.

In values, `1, 3 to 5` is a value set: a decoder tells other values apart from bytes that cannot be, and accepts them on request.

An SDO carries the payload without its ID, and 7 bytes of header and sequence number, under the
[table of SAE JAUS](../../translation.md#the-table-of-sae-jaus). *Object* is that of component 0 under the index base 2000h.

## By set and service

)" + services +
           "## By ID\n\n" + by_id.text() + "\n## By name\n\n" + by_name;
}

} // namespace jauscat::reference
