// The page that is built in: tools/web, without the module.
#pragma once
#include <string_view>

namespace jauscat::net::live {

/// page.cpp is made by cmake/live_page.cmake.
[[nodiscard]] std::string_view page() noexcept;

} // namespace jauscat::net::live
