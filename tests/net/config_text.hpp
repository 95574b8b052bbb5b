// Configurations from text, and the reader's errors.
#pragma once

#include "support/catch.hpp"
#include <jauscat/net/config/read_jaus_config.hpp>

#include <string>

namespace net_test {

inline const std::string system_a =
    "<system><name>a</name><jausip>1.0.0.0</jausip><ip>127.0.0.1</ip><port>39777</port></system>\n";

/// A file with the given lines between <jausconfig> in line 1 and the closing tag.
inline jauscat::net::jaus_config parse(const std::string& lines) {
    return jauscat::net::parse_jaus_config("<jausconfig>\n" + lines + "</jausconfig>\n", "test.xml");
}

/// The reader's error for `text`.
inline std::string complaint(const std::string& text) {
    try {
        static_cast<void>(jauscat::net::parse_jaus_config(text, "test.xml"));
        return "accepted";
    } catch (const jauscat::net::config_error& error) {
        CHECK(std::string{error.what()}.starts_with("test.xml:" + std::to_string(error.line()) + ": "));
        return error.what();
    }
}

/// What it says about a file of system a, in line 2 and `this_line` in line 3.
inline std::string complaint_about(const std::string& this_line) {
    return complaint("<jausconfig thissystem='a'>\n" + system_a + this_line + "\n</jausconfig>\n");
}

} // namespace net_test
