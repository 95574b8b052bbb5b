#include "access.hpp"

#include <algorithm>
#include <cctype>
#include <random>

namespace jauscat::net::live {

namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }
bool is_same(std::string_view a, std::string_view b) { return std::ranges::equal(a, b, {}, lower, lower); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Takes as long for every wrong token of the same size.
bool is_right(std::string_view given, std::string_view wanted) {
    if (given.size() != wanted.size()) return false;
    unsigned difference = 0;
    for (std::size_t i = 0; i != given.size(); ++i) difference |= static_cast<unsigned char>(given[i] ^ wanted[i]);
    return difference == 0;
}

} // namespace

bool is_loopback_host(std::string_view host) {
    const auto port = host.find(':', host.starts_with('[') ? host.find(']') : 0);
    const auto name = host.substr(0, port);
    if (port != host.npos && !std::ranges::all_of(host.substr(port + 1), is_digit)) return false;
    if (is_same(name, "localhost") || name == "[::1]") return true;
    // A name such as 127.example.org is none.
    return name.starts_with("127.") && std::ranges::all_of(name, [](char c) { return is_digit(c) || c == '.'; });
}

bool is_token(std::string_view text) {
    return text.size() >= 8 && text.size() <= 128 && std::ranges::all_of(text, [](char c) {
               return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
           });
}

std::string random_token() {
    std::random_device random;
    std::string token;
    for (int i = 0; i != 4; ++i)
        for (unsigned bits = random(), digit = 0; digit != 8; ++digit, bits >>= 4U)
            token += "0123456789abcdef"[bits & 15U];
    return token;
}

std::string_view why_refused(const request_source& from, std::string_view token) {
    if (!token.empty()) {
        if (from.token.empty()) return "This live view asks for a token: open the link that the program has printed.\n";
        return is_right(from.token, token) ? "" : "The token is wrong: open the link that the program has printed.\n";
    }
    if (!is_loopback_host(from.host)) return "This live view is for this machine alone: open it at 127.0.0.1.\n";
    constexpr std::string_view scheme = "http://";
    if (!from.origin.empty() &&
        !(from.origin.starts_with(scheme) && is_same(from.origin.substr(scheme.size()), from.host)))
        return "A page of another origin may see this live view only with --web-token.\n";
    return {};
}

request_target split_target(std::string_view target) {
    const auto query = std::min(target.find('?'), target.size());
    request_target made{.path = target.substr(0, query)};
    for (auto rest = target.substr(std::min(query + 1, target.size())); !rest.empty();) {
        const auto end = std::min(rest.find('&'), rest.size());
        if (rest.starts_with("token=")) made.token = rest.substr(6, end - 6);
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return made;
}

} // namespace jauscat::net::live
