// Output of a command: values that become JSON, or cells of a table.
#pragma once
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace ecat {

class value;
using list = std::vector<value>;
/// Members in the order of the output.
using record = std::vector<std::pair<std::string, value>>;

/// A JSON value, with the text that a table shows instead.
class value {
  public:
    value() = default;
    value(std::monostate) {}
    value(bool v) : data_{v} {}
    template <std::integral T> value(T v) {
        if constexpr (std::signed_integral<T>)
            data_ = static_cast<std::int64_t>(v);
        else
            data_ = static_cast<std::uint64_t>(v);
    }
    value(double v) : data_{v} {}
    value(const char* v) : data_{std::string{v}} {}
    value(std::string_view v) : data_{std::string{v}} {}
    value(std::string v) : data_{std::move(v)} {}
    value(list v) : data_{std::move(v)} {}
    value(record v) : data_{std::move(v)} {}
    template <class T> value(T v, std::string shown) : value(std::move(v)) { shown_ = std::move(shown); }

    using any = std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, std::string, list, record>;
    [[nodiscard]] const any& data() const noexcept { return data_; }
    /// For a table.
    [[nodiscard]] std::string text() const;
    /// A table shows it as a decimal number.
    [[nodiscard]] bool is_plain_number() const noexcept {
        return shown_.empty() && data_.index() >= 2 && data_.index() <= 4;
    }

  private:
    any data_{};
    std::string shown_{};
};

/// `0x1A`, with at least so many digits.
[[nodiscard]] std::string hex(std::uint64_t number, int digits);
/// A number that a table shows in hexadecimal.
[[nodiscard]] inline value hex_value(std::uint64_t number, int digits) { return {number, hex(number, digits)}; }
/// `3702`, two digits for each byte.
[[nodiscard]] std::string hex_bytes(const std::vector<std::byte>& data);
/// Text of a slave, UTF-8 or Latin-1, as UTF-8; control characters become `?`.
[[nodiscard]] std::string printable(std::string_view text);

/// Prints on standard output, on one line if it is `compact`.
void print_json(const value& v, bool compact = false);
/// Prints rows with the keys of the first one as headings; members in `hidden` are left out.
void print_table(const std::vector<record>& rows, const std::vector<std::string_view>& hidden = {});
[[nodiscard]] std::string table_text(const std::vector<record>& rows, const std::vector<std::string_view>& hidden = {});
/// Prints one line for each member.
void print_record(const record& members, const std::string& indent = {});

} // namespace ecat
