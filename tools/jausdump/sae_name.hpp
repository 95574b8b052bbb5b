// Names of the messages of SAE JAUS.
#pragma once
#include <jauscat/catalogue/entry.hpp>

#include <cctype>
#include <string>

namespace jausdump {

/// The name in the service definitions: "RequestControl".
inline std::string sae_name(const jauscat::catalogue::entry& message) {
    std::string name;
    bool begins = true;
    for (const char c : message.name()) {
        if (c != '_') name += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        begins = c == '_';
    }
    // The one abbreviation in the names of the sets.
    if (const auto at = name.find("Gps"); at != std::string::npos) name.replace(at, 3, "GPS");
    return name;
}

} // namespace jausdump
