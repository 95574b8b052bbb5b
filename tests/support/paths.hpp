// Where the files and programs are that tests use.
#pragma once
#include <string>

namespace support {

/// A file in tests/data.
std::string test_data(const std::string& name);
/// A program of this build.
std::string program(const std::string& name);
/// A file of the checkout.
std::string source_file(const std::string& path);

} // namespace support
