// The reader of JausConfig.xml.
//
//   <jausconfig>
//     <thissystem>a</thissystem>
//     <system><name>a</name><jausip>1.0.0.0</jausip><ip>127.0.0.1</ip><port>39777</port></system>
//     ...
//   </jausconfig>
//
// Each value may be an attribute instead: <system name="a" jausip="1.0.0.0" ip="127.0.0.1" port="39777"/>.
// docs/configuration.md describes the other elements of a <system>.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/net/config/jaus_config.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

/// Reads a configuration from text; `source` is the file's name in messages. Throws `config_error`.
[[nodiscard]] JAUSCAT_DECL jaus_config parse_jaus_config(std::string_view text, std::string source);
/// Reads a configuration file. Throws `config_error`.
[[nodiscard]] JAUSCAT_DECL jaus_config read_jaus_config(const std::filesystem::path& path);

} // namespace JAUSCAT_WAY
} // namespace jauscat::net

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/net/config/impl/read_jaus_config.ipp>
#endif
