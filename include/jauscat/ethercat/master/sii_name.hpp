// Reads the name of a device from its SII, for slaves without object 1008h.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/sii_read.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/schema/ethercat/sii.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace jauscat::ethercat {

/// A string of the SII, in the encoding of the vendor: UTF-8 or Latin-1. Of a longer one the first 127 bytes.
struct sii_text {
    std::array<char, 127> characters{};
    std::uint8_t size{};

    [[nodiscard]] constexpr std::string_view view() const noexcept { return {characters.data(), size}; }
};

/// State machine: `request` adds the datagrams of the present step, `reply` takes their return. Stays in place while it
/// runs, in any state of the slave, which does not change. Errors: working_counter, duplicate_station, those of
/// sii_read, sii_malformed.
class sii_name {
  public:
    /// At most, of a request: bytes and datagrams.
    static constexpr std::size_t request_size() noexcept {
        return 2 * datagram_overhead + wire::max_size<sii_request> + wire::max_size<sii_access>;
    }
    static constexpr std::size_t request_datagrams() noexcept { return 2; }

    sii_name() noexcept = default;
    explicit sii_name(std::uint16_t station) noexcept : station_{station} {}

    /// Empty: the SII has none.
    [[nodiscard]] const sii_text& value() const noexcept { return name_; }
    [[nodiscard]] const master_result<>& result() const noexcept { return result_; }

    JAUSCAT_FUNCTION void request(frame_builder& frame) const noexcept;
    JAUSCAT_FUNCTION progress reply(replies datagrams, time_point now, const master_config& config) noexcept;

  private:
    enum class step : std::uint8_t { take_sii, category, general, strings, give_sii };

    static constexpr std::uint32_t sii_end = 0x8000; // words of the largest memory
    static constexpr unsigned max_categories = 100;  // an erased memory would have thousands

    JAUSCAT_FUNCTION progress read(step next, std::uint32_t word) noexcept;
    JAUSCAT_FUNCTION progress category_read() noexcept;
    JAUSCAT_FUNCTION progress next_category() noexcept;
    JAUSCAT_FUNCTION progress find_string() noexcept;
    JAUSCAT_FUNCTION progress strings_read() noexcept;
    // Once the slave's application has the SII again.
    JAUSCAT_FUNCTION progress end(const master_error& why = {}) noexcept;

    std::uint16_t station_{};
    step step_{};
    sii_read sii_{};
    std::array<std::byte, 4> buffer_{};
    std::uint32_t word_{}; // where it stands
    std::uint32_t end_{};  // of the category
    unsigned categories_{};
    std::uint32_t strings_{}, strings_end_{}; // words of their category; 0: not found yet
    unsigned wanted_{};                       // number of the string, from 1
    unsigned passed_{};                       // strings that have begun
    unsigned left_{};                         // bytes of the one that has
    bool is_counted_{};                       // the number of strings stands before the first one
    sii_text name_{};
    master_error failure_{};
    master_result<> result_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/sii_name.ipp>
#endif
