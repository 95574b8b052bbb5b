#include "remarks.hpp"

#include "words.hpp"

#include <fstream>
#include <regex>
#include <stdexcept>

namespace jauscat::reference {

namespace {

const std::string nothing{};

void add_line(std::string& text, const std::string& line) { text += (text.empty() ? "" : " ") + line; }

} // namespace

remarks::remarks(const std::filesystem::path& folder) {
    for (const auto& entry : std::filesystem::directory_iterator{folder})
        if (entry.path().extension() == ".hpp") read(entry.path());
    if (types_.empty()) throw std::runtime_error{folder.string() + " has no commented schemas"};
}

void remarks::read(const std::filesystem::path& header) {
    static const std::regex type{R"(^(?:template <.*> )?(?:struct|enum class) (?:basic_)?(\w+)(?: :.*)? \{.*)"};
    static const std::regex member{R"(^    .*?(\w+?)_?\{[^{}]*\};(?: +///< (.*))?$)"};
    static const std::regex enumerator{R"(^    (\w+?)_? = \w+,(?: +///< (.*))?$)"};
    static const std::regex more{R"(^ +///< (.*)$)"};
    const std::string stem = header.stem();
    std::ifstream file{header};
    std::string above, current;
    std::string* last = nullptr; // a remark that the next line may continue
    bool at_top = true;
    for (std::string line; std::getline(file, line);) {
        std::smatch match;
        if (at_top && line.starts_with("// ")) {
            add_line(headers_[stem], line.substr(3));
        } else if (line.starts_with("/// ")) {
            add_line(above, line.substr(4));
        } else if (std::regex_match(line, match, type)) {
            current = match[1];
            types_.emplace(current, above); // a service of SAE may have the name of a message, and comes behind it
            homes_.emplace(current, stem);
            above.clear();
        } else if (std::regex_match(line, match, more) && last != nullptr) {
            add_line(*last, match[1]);
            continue;
        } else if (!current.empty() &&
                   (std::regex_match(line, match, enumerator) || std::regex_match(line, match, member))) {
            last = &members_[current][match[1]];
            *last = match[2];
            continue;
        } else if (line == "};") {
            current.clear();
        } else if (line.empty()) {
            above.clear();
        }
        at_top = at_top && line.starts_with("//");
        last = nullptr;
    }
}

const std::string& remarks::found(const texts& among, const std::string& key) {
    const auto place = among.find(key);
    if (place == among.end()) throw std::runtime_error{"the schemas' headers do not describe " + key};
    return place->second;
}

const std::string& remarks::of_member(const std::string& type, const std::string& member) const {
    const auto owner = members_.find(type);
    if (owner == members_.end()) return nothing;
    const auto place = owner->second.find(member);
    return place == owner->second.end() ? nothing : place->second;
}

message_remark remarks::of_message(const std::string& type, std::string_view name, std::string_view code) const {
    static const std::regex form{R"(^([^.:]+)(?:: (.*?))?\.? Code (\w{4})h, \w+ class, [^.]*\. ?(.*)$)"};
    std::smatch match;
    const std::string& text = of_type(type);
    if (text.empty()) return {};
    if (!std::regex_match(text, match, form) || match.str(1) != name || match.str(3) != code)
        throw std::runtime_error{"the comment on " + type + " is not 'NAME: meaning. Code " + std::string{code} +
                                 "h, ... class, SIZE.' with the standard's name, " + std::string{name}};
    std::string meaning = capitalised(match[2]);
    if (!meaning.empty()) meaning += ".";
    return {meaning, match[4]};
}

sae_remark remarks::of_sae_message(const std::string& type, std::string_view code) const {
    static const std::regex form{R"(^(\w+): ID (\w{4})h, (.*)\.$)"};
    std::smatch match;
    const std::string& text = of_type(type);
    if (!std::regex_match(text, match, form) || match.str(2) != code)
        throw std::runtime_error{"the comment on " + type + " is not 'NAME: ID " + std::string{code} + "h, ROLE.'"};
    sae_remark made{.name = match[1], .role = match[3]};
    static const std::regex part{R"((?:(input|output) of )?(\w+)(?:, |$))"};
    std::string direction; // the last one counts: "input of A, B, output of C"
    for (std::sregex_iterator at{made.role.begin(), made.role.end(), part}, end; at != end; ++at) {
        if (at->length(1) != 0) direction = (*at)[1];
        if (!direction.empty()) made.services.push_back({(*at)[2], direction == "input"});
    }
    return made;
}

} // namespace jauscat::reference
