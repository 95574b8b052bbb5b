// The only source of the tests that contains paths, so that a compiler cache shares all others between two checkouts.
#include "paths.hpp"

namespace support {

std::string test_data(const std::string& name) { return source_file("tests/data/" + name); }
std::string program(const std::string& name) { return JAUSCAT_PROGRAMS "/" + name; }
std::string source_file(const std::string& path) { return JAUSCAT_SOURCE "/" + path; }

} // namespace support
