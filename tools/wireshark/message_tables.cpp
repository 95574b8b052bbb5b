// Writes jauscat.lua: the tables of all messages, as the catalogues describe them, and dissector.lua behind them.
#include "jausdump/sae_name.hpp"
#include <jauscat/catalogue/ra_3_3.hpp>
#include <jauscat/catalogue/sae.hpp>
#include <jauscat/schema/jaus/header.hpp>
#include <jauscat/schema/sae/transport/header.hpp>
#include <jauscat/schema/translation/command_ranks.hpp>
#include <jauscat/schema/translation/sae_ranks.hpp>
#include <jauscat/text/describe.hpp>
#include <jauscat/text/message_name.hpp>

#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>

namespace {

namespace catalogue = jauscat::catalogue;
namespace jaus = jauscat::jaus;
namespace sae = jauscat::sae;
namespace text = jauscat::text;
namespace translation = jauscat::translation;
namespace translate = jauscat::translate;
using role = text::member::role;

constexpr const char* help = R"(message_tables: writes the Wireshark dissector of all JAUS messages.

  message_tables RUNTIME.lua OUTPUT.lua          writes OUTPUT.lua: the tables of the messages, then RUNTIME.lua
  message_tables RUNTIME.lua OUTPUT.lua --check  writes nothing; fails if OUTPUT.lua is not current

Example:
  message_tables tools/wireshark/dissector.lua tools/wireshark/jauscat.lua --check

Exit code: 0 if done, 1 if OUTPUT.lua is not current, 2 for a wrong command line or a file that cannot be read or written.
)";

std::string quoted(std::string_view text) {
    std::string made = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') made += '\\';
        made += c;
    }
    return made + "\"";
}
std::string number(double value) { return text::detail::real_text(value, 17); }

/// Lines of a Lua table, each of them once.
class numbered_lines {
  public:
    std::size_t number_of(const std::string& line) {
        const auto [found, is_new] = numbers_.try_emplace(line, lines_.size() + 1);
        if (is_new) lines_.push_back(line);
        return found->second;
    }
    [[nodiscard]] std::string table(const std::string& name) const {
        std::string made = "local " + name + " = {\n";
        for (const auto& line : lines_) made += line + ",\n";
        return made + "}\n";
    }

  private:
    std::map<std::string, std::size_t> numbers_{};
    std::vector<std::string> lines_{};
};

class table_writer {
  public:
    /// The number of a structure. Its first `skipped` members are read before it is.
    std::size_t structure(const text::structure& type, std::size_t skipped = 0) {
        const auto [found, is_new] = structures_.try_emplace(type.id, structures_.size() + 1);
        if (!is_new) return found->second;
        const std::size_t number = found->second;
        std::string line = "[" + std::to_string(number) + "]={" + quoted(type.name);
        for (const text::member& one : type.members.subspan(skipped))
            if (one.what != role::not_on_wire) line += ",{" + member(one) + "}";
        structure_lines_ += line + "},\n";
        return number;
    }

    [[nodiscard]] std::string tables() const {
        return "-- Names of enumerators and bits.\n" + names_.table("names") + "-- Forms of values.\n" +
               forms_.table("forms") + "-- Structures: name, members in wire order.\nlocal structures = {\n" +
               structure_lines_ + "}\n";
    }

  private:
    std::string names(std::span<const std::string_view> all) {
        std::string line;
        for (std::size_t i = 0; i != all.size(); ++i)
            if (!all[i].empty()) line += (line.empty() ? "[" : ",[") + std::to_string(i) + "]=" + quoted(all[i]);
        return std::to_string(names_.number_of("{" + line + "}"));
    }

    std::size_t form(const text::form& how) {
        return forms_.number_of(std::visit([&](const auto& is) { return "{" + told(is) + "}"; }, how.is));
    }

    static std::string unit(std::string_view text) { return text.empty() ? "" : ",unit=" + quoted(text); }

    std::string told(const text::integer_form& is) {
        using meaning = text::integer_form::meaning;
        std::string line = R"("integer",bits=)" + std::to_string(is.bits) + unit(is.unit);
        if (is.is_signed) line += ",signed=true";
        if (is.what == meaning::boolean) line += ",boolean=true";
        if (is.what == meaning::enumeration) line += ",names=" + names(is.names);
        if (is.what == meaning::flags) line += ",flags=" + names(is.names);
        if (is.values.empty()) return line;
        const auto told = [&](std::uint64_t one) {
            return is.is_signed ? std::to_string(static_cast<std::int64_t>(one)) : std::to_string(one);
        };
        line += ",values={";
        for (const auto [least, most] : is.values) line += "{" + told(least) + "," + told(most) + "},";
        line.back() = '}';
        return line;
    }
    static std::string told(const text::real_form& is) {
        return R"("real",bits=)" + std::to_string(is.bits) + unit(is.unit);
    }
    static std::string told(const text::scaled_form& is) {
        return R"("scaled",bits=)" + std::to_string(is.bits) + ",min=" + number(is.min) + ",max=" + number(is.max) +
               (is.is_signed ? ",signed=true" : "") + unit(is.unit);
    }
    static std::string told(const text::octets_form& is) {
        std::string line = R"("octets")";
        if (is.characters) line += ",text=true";
        if (is.to_the_end)
            line += ",rest=true";
        else if (is.zero_filled || is.least == is.most)
            line += ",size=" + std::to_string(is.most);
        if (is.zero_filled) line += ",filled=true";
        if (is.zero_terminated) line += ",terminated=true";
        return line;
    }
    std::string told(const text::structure_form& is) { return R"("structure",)" + std::to_string(structure(*is.of)); }
    std::string told(const text::packed_form& is) {
        return R"("packed",)" + std::to_string(structure(*is.of)) + ",bits=" + std::to_string(is.bits);
    }
    std::string told(const text::encoded_form& is) {
        return is.of == nullptr ? R"("message")" : R"("message",)" + std::to_string(structure(*is.of));
    }
    std::string told(const text::list_form& is) {
        std::string line = R"("list",)" + std::to_string(form(*is.element));
        if (!is.field.empty()) line += ",field=" + quoted(is.field);
        if (is.least == is.most) line += ",count=" + std::to_string(is.most);
        return line;
    }
    std::string told(const text::tree_form& is) {
        return R"("tree",)" + std::to_string(form(*is.nodes.element)) + ",depth=" + std::to_string(is.max_depth) +
               ",children=" + quoted(is.children.name);
    }
    std::string told(const text::choice_form& is) {
        std::string line = R"("choice",{)";
        for (const text::choice_case& one : is.cases)
            line +=
                "[" + std::to_string(one.tag) + "]=" + std::to_string(one.how == nullptr ? 0 : form(*one.how)) + ",";
        return line + "}";
    }
    std::string told(const text::variant_form& is) {
        std::string line = R"("variant",{)";
        for (const text::alternative& one : is.alternatives)
            line += "{" + quoted(one.name) + (one.how == nullptr ? "" : "," + std::to_string(form(*one.how))) + "},";
        return line + "},bits=" + std::to_string(is.bits);
    }

    std::string reference(const char* name, const text::other_member& other) {
        if (other.name.empty()) return {};
        // A member of a structure that is being written, or a path in the same one.
        const auto owner = other.owner == nullptr ? std::size_t{} : structures_.at(other.owner);
        return std::string{","} + name + "={" + std::to_string(owner) + "," + quoted(other.name) + "}";
    }

    std::string member(const text::member& one) {
        std::string line = quoted(one.name) + "," + std::to_string(form(*one.how));
        if (one.what == role::presence_vector)
            line += ",vector=" + std::to_string(one.used_bits) + (one.tolerant ? ",tolerant=true" : "");
        if (one.what == role::flag) line += ",flag=true";
        if (one.what == role::count) line += ",counts=true";
        if (one.what == role::constant) line += ",constant=" + std::to_string(one.number(nullptr));
        if (one.presence_bit) line += ",bit=" + std::to_string(*one.presence_bit);
        if (one.carrier_bits != 0)
            line += ",first=" + std::to_string(one.first_bit) + ",carrier=" + std::to_string(one.carrier_bits) +
                    (one.ends_carrier ? ",ends=true" : "");
        line += reference("gate", one.gate) + reference("counter", one.counter) + reference("tag", one.tag);
        if (one.counter_excess != 0) line += ",excess=" + std::to_string(one.counter_excess);
        return line;
    }

    numbered_lines names_{}, forms_{};
    std::map<const void*, std::size_t> structures_{};
    std::string structure_lines_{};
};

std::string code_text(std::uint16_t code) { return text::hex_number(code, 4); }

std::string messages(table_writer& tables, const char* name, const catalogue::list& all, bool is_sae) {
    std::string made = std::string{"local "} + name + " = {\n";
    for (const catalogue::entry& one : all) {
        made += "[" + code_text(one.command_code()) + "]={" + quoted(one.name()) + "," +
                quoted(is_sae ? jausdump::sae_name(one) : text::message_name(one.command_code())) + "," +
                std::to_string(tables.structure(one.fields(), is_sae ? 1 : 0)); // the message ID
        if (one.query() != 0) made += ",query=" + code_text(one.query());
        if (one.report() != 0) made += ",report=" + code_text(one.report());
        made += "},\n";
    }
    return made + "}\n";
}

std::string codes(std::span<const std::uint16_t> all) {
    std::string made = "{";
    for (const std::uint16_t code : all) made += (made.size() == 1 ? "" : ",") + code_text(code);
    return made + "}";
}
template <const auto&... Lists> std::string segments(translate::code_segments<Lists...>) {
    std::string made = "{";
    ((made += codes(Lists) + ",\n"), ...);
    return made + "}";
}

std::string read(const std::string& path) {
    std::ifstream file{path, std::ios::binary};
    if (!file) throw std::runtime_error{"cannot read " + path};
    return {std::istreambuf_iterator<char>{file}, {}};
}

std::string dissector(const std::string& runtime) {
    table_writer tables;
    const auto header = tables.structure(text::describe<jaus::header>());
    const auto transport = tables.structure(text::describe<sae::transport_header>());
    const std::string ra = messages(tables, "ra_messages", catalogue::ra_3_3(), false);
    const std::string services = messages(tables, "sae_messages", catalogue::sae(), true);
    std::vector<catalogue::entry> differing;
    for (const catalogue::entry& one : catalogue::sae_mobility_1_0())
        if (*catalogue::sae().find(one.command_code()) != one) differing.push_back(one);
    const std::string services_1_0 = messages(tables, "sae_messages_1_0", catalogue::list{differing}, true);
    std::ostringstream made;
    made << "-- Wireshark dissector of JAUS messages: RA 3.3 and SAE services, over UDP, TCP and EtherCAT.\n"
            "-- Written by message_tables from the schemas: do not edit it, write it again.\n"
            "-- dissector.lua is behind the tables.\n\n"
         << tables.tables() << "-- Messages: name, title, structure.\n"
         << ra << services << "-- Messages of mobility 1.0, which differ.\n"
         << services_1_0 << "local header_structure, transport_structure = " << header << ", " << transport << "\n"
         << "-- Codes by subindex, from 1; of SAE JAUS by segment.\n"
         << "local ra_ranks = " << codes(translation::ra_command_codes) << "\n"
         << "local sae_ranks = " << segments(translation::sae_segments{}) << "\n\n"
         << runtime;
    return made.str();
}

} // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (!words.empty() && (words[0] == "-h" || words[0] == "--help")) return std::cout << help, 0;
    const bool check = words.size() == 3 && words[2] == "--check";
    if (words.size() != 2 && !check) return std::cerr << help, 2;
    try {
        const std::string made = dissector(read(words[0]));
        if (check) {
            if (read(words[1]) == made) return 0;
            std::cerr << words[1] << " is not current: run scripts/message-reference\n";
            return 1;
        }
        std::ofstream file{words[1], std::ios::binary};
        if (!(file << made).flush()) throw std::runtime_error{"cannot write " + words[1]};
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "message_tables: " << error.what() << "\n";
        return 2;
    }
}
