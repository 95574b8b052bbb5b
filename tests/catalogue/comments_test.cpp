// The comments of the schemas: unit and limits behind a member are those of its layout.
#include "support/catch.hpp"
#include "support/paths.hpp"
#include <jauscat/catalogue/ra_3_3.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <regex>
#include <set>

namespace {

namespace catalogue = jauscat::catalogue;
namespace text = jauscat::text;

using place = std::pair<std::string, std::string>; ///< structure and member

/// The scaled members of all messages and of the structures in them.
class scaled_members {
  public:
    scaled_members() {
        for (const auto& message : catalogue::ra_3_3()) take(message.fields());
    }
    std::map<place, text::scaled_form> all{};

  private:
    void take(const text::structure& type) {
        if (!seen_.insert(type.id).second) return;
        for (const text::member& one : type.members)
            if (one.how != nullptr) take(*one.how, {std::string{type.name}, std::string{one.name}});
    }
    void take(const text::form& how, const place& at) {
        if (const auto* scaled = std::get_if<text::scaled_form>(&how.is)) all.emplace(at, *scaled);
        if (const auto* inner = std::get_if<text::structure_form>(&how.is)) take(*inner->of);
        if (const auto* list = std::get_if<text::list_form>(&how.is))
            take(*list->element, list->field.empty() ? at : place{at.first, std::string{list->field}});
        if (const auto* tree = std::get_if<text::tree_form>(&how.is)) take(*tree->nodes.element, at);
        if (const auto* choice = std::get_if<text::choice_form>(&how.is))
            for (const auto& one : choice->cases)
                if (one.how != nullptr) take(*one.how, at);
    }
    std::set<const void*> seen_{};
};

/// The comments behind members.
std::map<place, std::string> comments() {
    static const std::regex begin{R"(^(?:template <.*> )?struct (?:basic_)?(\w+) (?:: .*)?\{.*)"};
    static const std::regex member{R"(^    [\w:<>, ]+ (\w+)\{.*\}; *///< (.*)$)"};
    std::map<place, std::string> found;
    for (const auto& file : std::filesystem::directory_iterator{support::source_file("schemas/jauscat/schema/jaus")}) {
        std::ifstream lines{file.path()};
        std::string type;
        std::smatch parts;
        for (std::string line; std::getline(lines, line);) {
            if (std::regex_match(line, parts, begin)) type = parts[1];
            if (std::regex_match(line, parts, member)) found[{type, parts[1]}] = parts[2];
        }
    }
    return found;
}

double number(const std::string& words) { // 100, -0.5, pi, -8 pi
    if (!words.ends_with("pi")) return std::stod(words);
    const std::string factor = words.substr(0, words.size() - 2);
    return std::numbers::pi * (factor.empty() ? 1 : factor == "-" ? -1 : std::stod(factor));
}

const std::map<std::string_view, std::string_view> unit_words{{"%", "percent"},
                                                              {"deg", "degrees"},
                                                              {"m", "metres"},
                                                              {"m/s", "metres per second"},
                                                              {"rad", "radians"},
                                                              {"rad/s", "radians per second"},
                                                              {"rad/s^2", "radians per second squared"},
                                                              {"N m", "newton metres"},
                                                              {"deg C", "degrees Celsius"},
                                                              {"Hz", "hertz"},
                                                              {"s", "seconds"}};

} // namespace

TEST_CASE("the comment behind each scaled member gives the unit and the limits of its layout") {
    const auto said = comments();
    static const std::regex limits{
        R"(^([a-zA-Z ]*?)(?: \([^)]*\))?(?:, )?(-?[\d.]*(?: ?pi)?) to (-?[\d.]*(?: ?pi)?)(?:[;,. ].*)?$)"};
    const scaled_members members;
    CHECK(members.all.size() > 150);
    for (const auto& [at, scaled] : members.all) {
        INFO(at.first << "::" << at.second);
        const auto comment = said.find(at);
        REQUIRE(comment != said.end());
        INFO(comment->second);
        std::smatch parts;
        CHECKED_IF(std::regex_match(comment->second, parts, limits)) {
            CHECK(parts[1].str() == (scaled.unit.empty() ? std::string_view{} : unit_words.at(scaled.unit)));
            CHECK(number(parts[2]) == Approx(scaled.min));
            CHECK(number(parts[3]) == Approx(scaled.max));
        }
    }
}
