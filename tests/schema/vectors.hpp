// Golden messages: one JSON object a line, with the header's fields, the body's fields under the standard's names, and
// the bytes of the whole message.
#pragma once
#include "support/hex.hpp"
#include "support/paths.hpp"

#include <cctype>
#include <fstream>
#include <nlohmann/json.hpp>

namespace golden {

using json = nlohmann::ordered_json;

struct vector {
    std::string name{};
    std::uint16_t code{};
    json object{};                  ///< the whole line
    std::vector<std::byte> bytes{}; ///< header and body
};

/// All of them, in the order of the file.
inline const std::vector<vector>& vectors() {
    static const auto all = [] {
        std::vector<vector> read;
        std::ifstream file{support::test_data("ra_vectors.jsonl")};
        for (std::string line; std::getline(file, line);) {
            json object = json::parse(line);
            vector one{.name = object.at("message"),
                       .code = static_cast<std::uint16_t>(std::stoi(object.at("code").get<std::string>(), nullptr, 16)),
                       .bytes = jauscat::test::from_hex(object.at("hex").get<std::string>())};
            one.object = std::move(object);
            read.push_back(std::move(one));
        }
        return read;
    }();
    return all;
}

/// "Longitude (WGS 84)" to "longitude", "Parking, Brake and Horn" to "parking_brake_and_horn".
inline std::string snake_case(std::string_view standard_name) {
    std::string name;
    for (const char c : standard_name.substr(0, standard_name.find(" ("))) {
        if (std::isalnum(static_cast<unsigned char>(c)))
            name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (!name.ends_with('_'))
            name += '_';
    }
    return name;
}

} // namespace golden
