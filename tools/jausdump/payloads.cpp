#include "payloads.hpp"

#include <charconv>

namespace jausdump {

namespace {

std::uint32_t key(const jaus::address& id) {
    return static_cast<std::uint32_t>((id.subsystem << 24) + (id.node << 16) + (id.component << 8) + id.instance);
}

double number(const jaus::payload_limit& limit) {
    return std::visit(
        []<class T>(const T& value) {
            if constexpr (std::is_arithmetic_v<T>)
                return static_cast<double>(value);
            else
                return 0.0;
        },
        limit);
}

template <class Interface> payload_interfaces heard(std::span<const Interface> reported) {
    payload_interfaces made;
    for (const Interface& one : reported) {
        made.types.push_back(one.type_code);
        made.limits.emplace_back(number(one.minimum_value), number(one.maximum_value));
    }
    return made;
}

} // namespace

void payload_directory::learn(const jaus::address& payload, const jaus::report_payload_interface& report) {
    constexpr std::size_t most = 4096; // payloads: a network full of false ones does not fill the memory
    if (heard_.size() >= most && !heard_.contains(key(payload))) return;
    heard_[key(payload)] = {heard(std::span{report.command_interface}), heard(std::span{report.information_interface})};
}

const payload_directory::interfaces* payload_directory::of(const jaus::address& payload) const {
    const auto found = heard_.find(key(payload));
    return found == heard_.end() ? nullptr : &found->second;
}
const payload_interfaces* payload_directory::commands(const jaus::address& payload) const {
    if (given_) return &*given_;
    const interfaces* const found = of(payload);
    return found == nullptr ? nullptr : &found->commands;
}
const payload_interfaces* payload_directory::measurements(const jaus::address& payload) const {
    if (given_) return &*given_;
    const interfaces* const found = of(payload);
    return found == nullptr ? nullptr : &found->measurements;
}

std::vector<jaus::payload_type> parse_payload_types(const std::string& text, const std::string& name) {
    constexpr std::string_view separators = ", \t\r\n[]";
    std::vector<jaus::payload_type> types;
    for (std::size_t at = text.find_first_not_of(separators); at != std::string::npos;
         at = text.find_first_not_of(separators, at)) {
        const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
        unsigned code{};
        const auto [stop, error] = std::from_chars(text.data() + at, text.data() + end, code);
        if (error != std::errc{} || stop != text.data() + end || code < 1 || code > 22)
            throw input_error{name + ": '" + text.substr(at, end - at) + "' is no payload type code: 1 to 22"};
        types.push_back(static_cast<jaus::payload_type>(code));
        at = end;
    }
    if (types.empty()) throw input_error{name + ": no payload type codes in it"};
    return types;
}

} // namespace jausdump
