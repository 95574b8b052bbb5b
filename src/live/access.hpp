// Who may see the live view.
#pragma once
#include <string>
#include <string_view>

namespace jauscat::net::live {

/// "localhost", 127.x.x.x or [::1], with or without a port.
[[nodiscard]] bool is_loopback_host(std::string_view host);
/// 8 to 128 letters, digits, '-' and '_'.
[[nodiscard]] bool is_token(std::string_view text);
/// 32 random hex digits.
[[nodiscard]] std::string random_token();

/// What a request says of itself; empty: nothing.
struct request_source {
    std::string_view host{}, origin{}, token{};
};
/// Why the request is refused, in a sentence; empty where it is not. `token`: what a viewer must give; empty: nothing.
[[nodiscard]] std::string_view why_refused(const request_source& from, std::string_view token);

/// Path and value of `token` in the target of a request.
struct request_target {
    std::string_view path{}, token{};
};
[[nodiscard]] request_target split_target(std::string_view target);

} // namespace jauscat::net::live
