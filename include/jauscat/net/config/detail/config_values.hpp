// The values of a configuration file, from text.
#pragma once

#include <jauscat/net/config/detail/config_source.hpp>

#include <boost/asio/ip/address.hpp>

#include <charconv>
#include <string>
#include <string_view>
#include <system_error>

namespace jauscat::net::detail {

/// A number from `first` to `last`; the problem that is noted states that it is not `what`.
template <class T>
T config_number(const config_source& source, const config_value& value, T first, T last, std::string_view what) {
    T number{};
    const auto* const end = value.text.data() + value.text.size();
    const auto [stop, error] = std::from_chars(value.text.data(), end, number);
    if (error == std::errc{} && stop == end && number >= first && number <= last) return number;
    source.note(config_errc::invalid_value, value,
                std::string{value.name} + ' ' + quoted(value.text) + " is not " + std::string{what} + ", " +
                    std::to_string(first) + " to " + std::to_string(last));
    return first;
}

/// As above, or the present value if there is no such element.
template <class T>
T config_number_or(const config_source& source, const config_value& value, T otherwise, T first, T last,
                   std::string_view what) {
    return value.given ? config_number(source, value, first, last, what) : otherwise;
}

inline boost::asio::ip::address config_ip(const config_source& source, const config_value& value,
                                          std::string_view example = "127.0.0.1") {
    boost::system::error_code wrong;
    auto address = boost::asio::ip::make_address(std::string{value.text}, wrong);
    if (wrong)
        source.note(config_errc::invalid_value, value,
                    std::string{value.name} + ' ' + quoted(value.text) + " is not an IP address, such as " +
                        std::string{example});
    return address;
}

/// The position of the value among those that are `possible`; 0 for a value that is not given.
inline std::size_t config_one_of(const config_source& source, const config_value& value,
                                 std::initializer_list<std::string_view> possible) {
    if (!value.given) return 0;
    const auto found = std::ranges::find(possible, value.text);
    if (found == possible.end()) {
        std::string all;
        for (const auto& one : possible)
            all += (all.empty() ? "" : &one == possible.end() - 1 ? " or " : ", ") + std::string{one};
        source.note(config_errc::invalid_value, value,
                    std::string{value.name} + ' ' + quoted(value.text) + " is unknown; use " + all);
        return 0;
    }
    return static_cast<std::size_t>(found - possible.begin());
}

/// True for `yes`, false for `no` and for a value that is not given.
inline bool config_choice(const config_source& source, const config_value& value, std::string_view no,
                          std::string_view yes) {
    return config_one_of(source, value, {no, yes}) == 1;
}

} // namespace jauscat::net::detail
