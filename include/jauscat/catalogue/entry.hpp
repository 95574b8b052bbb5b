// A message that is known at run time: what its schema says, without its type.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/result.hpp>
#include <jauscat/text/annotate.hpp>
#include <jauscat/text/error.hpp>
#include <jauscat/text/structure.hpp>
#include <jauscat/wire/diagnosis.hpp>
#include <jauscat/wire/value_set.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jauscat::catalogue {

class any_message;

namespace detail {

/// What is compiled for each message (of.hpp). `object` is one of the message's type.
struct entry_data {
    std::uint16_t command_code{}, query{}, report{};
    std::string_view name{};
    std::size_t min_size{}, max_size{};
    std::uint32_t presence_bits{};
    bool has_lists{}; ///< decoding takes an arena
    bool takes_rest{};
    const text::structure& (*fields)(){};
    void* (*make)(){};
    void (*destroy)(void* object){};
    result<std::size_t, wire::errc> (*decode)(void* object, std::span<const std::byte> body, wire::arena&){};
    wire::errc (*check_values)(const void* object){};
    result<std::vector<std::byte>, wire::errc> (*encode)(const void* object){}; ///< tolerates values
    wire::diagnosis (*diagnose)(std::span<const std::byte> body, wire::errc error){};
};

} // namespace detail

/// A message of a catalogue (any_message.hpp has what its functions return). Copies are references to the same, which
/// lives as long as the program.
class entry {
  public:
    explicit entry(const detail::entry_data& data) noexcept : data_{&data} {}

    [[nodiscard]] std::uint16_t command_code() const noexcept { return data_->command_code; }
    /// Of its type: `set_wrench_effort`. text::message_name has the standard's.
    [[nodiscard]] std::string_view name() const noexcept { return data_->name; }
    /// The code of the query that it answers; 0: it is no report.
    [[nodiscard]] std::uint16_t query() const noexcept { return data_->query; }
    /// The code of the report that answers it; 0: it is no query.
    [[nodiscard]] std::uint16_t report() const noexcept { return data_->report; }
    /// Fewest and most bytes of its body.
    [[nodiscard]] std::size_t min_size() const noexcept { return data_->min_size; }
    [[nodiscard]] std::size_t max_size() const noexcept { return data_->max_size; }
    /// Its last field takes all bytes to the end of the body: a peer may send more than `max_size`.
    [[nodiscard]] bool takes_rest() const noexcept { return data_->takes_rest; }
    /// Bits of its presence vector that stand for a field; 0: it has no presence vector.
    [[nodiscard]] std::uint32_t presence_bits() const noexcept { return data_->presence_bits; }
    /// Its fields with names, units, limits, enumerators and lists.
    [[nodiscard]] const text::structure& fields() const { return data_->fields(); }

    /// A value-initialised message.
    [[nodiscard]] JAUSCAT_FUNCTION any_message make() const;
    /// The message of a body, which is copied, or where and why it does not decode.
    [[nodiscard]] JAUSCAT_FUNCTION result<any_message, wire::diagnosis> decode(std::span<const std::byte> body) const;
    /// The same, and accepts values outside their value sets.
    [[nodiscard]] JAUSCAT_FUNCTION result<any_message, wire::diagnosis> decode(std::span<const std::byte> body,
                                                                               wire::tolerate_values_tag) const;
    /// From `propulsive_linear_effort_x=50 ...`, in one line or as words; see text/from_text.hpp.
    [[nodiscard]] JAUSCAT_FUNCTION result<any_message, text::error> from_text(std::string_view line) const;
    [[nodiscard]] JAUSCAT_FUNCTION result<any_message, text::error>
    from_words(std::span<const std::string> words) const;

    /// Where and why a body does not decode; `ok` where it does.
    [[nodiscard]] JAUSCAT_FUNCTION wire::diagnosis diagnose(std::span<const std::byte> body) const;
    /// The bytes of each field of a body.
    [[nodiscard]] JAUSCAT_FUNCTION text::annotation annotated(std::span<const std::byte> body) const;
    /// A line for each field of a body: offset, counted from `first_offset`, bytes, name, value.
    [[nodiscard]] std::string annotate(std::span<const std::byte> body, std::size_t first_offset = 0) const {
        return text::to_text(annotated(body), body, first_offset);
    }
    /// The fields of a body, a line each, or one that says why it does not decode.
    [[nodiscard]] JAUSCAT_FUNCTION std::string to_text(std::span<const std::byte> body, std::size_t indent = 2) const;

    friend bool operator==(const entry&, const entry&) = default;

  private:
    friend class any_message;
    // It points at the bytes of the body.
    [[nodiscard]] JAUSCAT_FUNCTION result<any_message, wire::errc> decoded(std::span<const std::byte> body,
                                                                           bool tolerates_values) const;
    [[nodiscard]] JAUSCAT_FUNCTION result<any_message, wire::diagnosis> decode(std::span<const std::byte> body,
                                                                               bool tolerates_values) const;
    const detail::entry_data* data_;
};

} // namespace jauscat::catalogue
