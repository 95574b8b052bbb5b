// The picture of the README.
#pragma once

#include <string>

namespace jauscat::reference {

/// One command on its way from an operator to an arm, with its bytes as the library makes them: SVG.
std::string data_path_picture();

} // namespace jauscat::reference
