// Golden messages: one JSON object a line, with the header's fields, the body's fields under the standard's names, and
// the bytes of the whole message.
#pragma once
#include "support/hex.hpp"

#include <boost/property_tree/json_parser.hpp>

#include <cctype>
#include <fstream>
#include <sstream>

namespace golden {

using json = boost::property_tree::ptree;

struct vector {
    std::string name{};
    std::uint16_t code{};
    json header{};
    json fields{};
    std::vector<std::byte> bytes{}; ///< header and body
};

/// All of them, in the order of the file.
inline const std::vector<vector>& vectors() {
    static const auto all = [] {
        std::vector<vector> read;
        std::ifstream file{JAUSCAT_TEST_DATA "/ra_vectors.jsonl"};
        for (std::string line; std::getline(file, line);) {
            json object;
            std::istringstream text{line};
            boost::property_tree::read_json(text, object);
            read.push_back({.name = object.get<std::string>("message"),
                            .code = static_cast<std::uint16_t>(std::stoi(object.get<std::string>("code"), nullptr, 16)),
                            .header = object.get_child("header"),
                            .fields = object.get_child("fields"),
                            .bytes = jauscat::test::from_hex(object.get<std::string>("hex"))});
        }
        return read;
    }();
    return all;
}

/// "Longitude (WGS 84)" to "longitude".
inline std::string snake_case(std::string_view standard_name) {
    std::string name;
    for (const char c : standard_name.substr(0, standard_name.find(" (")))
        name += std::isalnum(static_cast<unsigned char>(c))
                    ? static_cast<char>(std::tolower(static_cast<unsigned char>(c)))
                    : '_';
    return name;
}

/// The number in a JSON value; integers of 64 bits keep all their bits.
template <class Number> Number number(const json& value) {
    const auto text = value.get_value<std::string>();
    if constexpr (std::is_floating_point_v<Number>)
        return static_cast<Number>(std::stod(text));
    else if constexpr (std::is_signed_v<Number>)
        return static_cast<Number>(std::stoll(text));
    else
        return static_cast<Number>(std::stoull(text));
}

} // namespace golden
