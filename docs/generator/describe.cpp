#include "describe.hpp"

#include <cmath>
#include <numbers>

namespace jauscat::reference {

std::string with_minus(std::string number) {
    if (number.starts_with('-')) number.replace(0, 1, "−");
    return number;
}

std::string number(double value, int digits) {
    const double in_pi = value / std::numbers::pi;
    if (value != 0 && std::abs(in_pi - std::round(in_pi)) < 1e-9) {
        const std::string factor = std::abs(in_pi) < 1.5 ? "" : std::to_string(std::lround(std::abs(in_pi)));
        return (value < 0 ? "−" : "") + factor + "π";
    }
    std::string made = text::detail::real_text(value, digits);
    if (const auto exponent = made.find("e-0"); exponent != std::string::npos) made.erase(exponent + 2, 1);
    return with_minus(made);
}

std::string plain_name(const std::type_info& type) {
    const std::string whole = boost::core::demangle(type.name());
    const std::string name = whole.substr(0, whole.find('<'));
    return name.substr(name.rfind(':') + 1);
}

} // namespace jauscat::reference
