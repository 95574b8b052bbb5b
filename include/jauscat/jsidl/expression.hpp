// Real numbers as JSIDL files write them: 1000000.0, 1,000,000, -20*consts.PI, 3.14159265358979323846/2.
#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace jauscat::jsidl::detail {

[[nodiscard]] constexpr bool is_space(char c) noexcept { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
[[nodiscard]] constexpr bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }
[[nodiscard]] constexpr bool is_letter(char c) noexcept {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// Without white space at its ends, and with one space for each run of it inside.
[[nodiscard]] inline std::string with_single_spaces(std::string_view text) {
    std::string made;
    bool gap = false;
    for (const char c : text) {
        if (is_space(c)) {
            gap = !made.empty();
        } else {
            if (gap) made += ' ';
            gap = false;
            made += c;
        }
    }
    return made;
}

/// Sums, differences, products and quotients of numbers, constants and expressions in parentheses. `constant_of` gives
/// the value of a name such as `consts.PI`. The value is empty for another text, and where it is not finite.
///
/// A comma or a space in a number separates groups of three digits; elsewhere it is refused: "1,5" may be one and a
/// half or two numbers.
template <class ConstantOf> class expression {
  public:
    expression(std::string_view text, ConstantOf constant_of) : rest_{text}, constant_of_{constant_of} {}

    std::optional<double> value() {
        const double read = sum();
        skip_space();
        if (failed_ || !rest_.empty() || !std::isfinite(read)) return std::nullopt;
        return read;
    }

  private:
    void skip_space() {
        while (!rest_.empty() && is_space(rest_.front())) rest_.remove_prefix(1);
    }
    bool take(char c) {
        skip_space();
        if (rest_.empty() || rest_.front() != c) return false;
        rest_.remove_prefix(1);
        return true;
    }
    double sum() {
        double value = product();
        while (!failed_) {
            if (take('+'))
                value += product();
            else if (take('-'))
                value -= product();
            else
                break;
        }
        return value;
    }
    double product() {
        double value = factor();
        while (!failed_) {
            if (take('*'))
                value *= factor();
            else if (take('/'))
                value /= factor();
            else
                break;
        }
        return value;
    }
    double factor() {
        if (++depth_ > 64) failed_ = true; // nobody writes that; the stack is not endless
        if (failed_) return 0;
        double value = 0;
        if (take('-'))
            value = -factor();
        else if (take('+'))
            value = factor();
        else if (take('(')) {
            value = sum();
            if (!take(')')) failed_ = true;
        } else {
            skip_space();
            value = !rest_.empty() && is_letter(rest_.front()) ? constant() : number();
        }
        --depth_;
        return value;
    }
    double constant() {
        std::size_t size = 0;
        while (size != rest_.size() && (is_letter(rest_[size]) || is_digit(rest_[size]) || rest_[size] == '.')) ++size;
        const auto name = rest_.substr(0, size);
        rest_.remove_prefix(size);
        return constant_of_(name);
    }
    double number() {
        std::string digits = grouped_digits();
        const auto copy = [&](auto&& belongs) {
            while (!rest_.empty() && belongs(rest_.front())) {
                digits += rest_.front();
                rest_.remove_prefix(1);
            }
        };
        if (rest_.starts_with('.')) {
            digits += '.';
            rest_.remove_prefix(1);
            copy(is_digit);
        }
        if (rest_.starts_with('e') || rest_.starts_with('E')) {
            digits += 'e';
            rest_.remove_prefix(1);
            if (rest_.starts_with('-')) digits += '-';
            if (rest_.starts_with('-') || rest_.starts_with('+')) rest_.remove_prefix(1);
            copy(is_digit);
        }
        double value = 0;
        const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc{} || stop != digits.data() + digits.size()) failed_ = true;
        return value;
    }
    /// The digits before a point, without what separates groups of three.
    std::string grouped_digits() {
        std::string digits;
        const auto run = [&] {
            std::size_t size = 0;
            while (size != rest_.size() && is_digit(rest_[size])) ++size;
            digits += rest_.substr(0, size);
            rest_.remove_prefix(size);
            return size;
        };
        const std::size_t first = run();
        if (rest_.size() < 2 || (rest_.front() != ',' && rest_.front() != ' ') || !is_digit(rest_[1])) return digits;
        const char separator = rest_.front();
        bool in_groups = first >= 1 && first <= 3;
        while (rest_.size() >= 2 && rest_.front() == separator && is_digit(rest_[1])) {
            rest_.remove_prefix(1);
            if (run() != 3) in_groups = false;
        }
        if (!in_groups) failed_ = true;
        return digits;
    }

    std::string_view rest_;
    ConstantOf constant_of_;
    bool failed_{};
    int depth_{};
};

} // namespace jauscat::jsidl::detail
