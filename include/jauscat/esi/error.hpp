// Errors of ESI files and devices: a code to branch on, the element concerned, and a line for the operator.
#pragma once

#include <jauscat/base/result.hpp>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace jauscat::esi {

enum class errc : std::uint8_t {
    ok,
    unreadable,         ///< the file cannot be read
    not_xml,            ///< not well-formed XML
    not_esi,            ///< the root element is another one
    missing,            ///< an element, attribute or text that is required
    unexpected,         ///< an element that has no place there, or one too many
    invalid_value,      ///< a value of another form, or out of range
    duplicate,          ///< an object that is there twice
    unknown_reference,  ///< a type or group that the file does not define
    inconsistent,       ///< sizes or subindices that do not agree
    cannot_be_emulated, ///< `emulated_device`: a part that an emulated slave does not have
};

/// The error in one line. `describe(const error&)` says more.
[[nodiscard]] constexpr std::string_view describe(errc code) noexcept {
    switch (code) {
    case errc::ok: return "ok";
    case errc::unreadable: return "the file cannot be read";
    case errc::not_xml: return "not well-formed XML";
    case errc::not_esi: return "the root element is not <EtherCATInfo>";
    case errc::missing: return "an element, attribute or text is missing";
    case errc::unexpected: return "an element has no place there";
    case errc::invalid_value: return "a value is of another form, or out of range";
    case errc::duplicate: return "an object is there twice";
    case errc::unknown_reference: return "the file does not define a type or group that it names";
    case errc::inconsistent: return "sizes or subindices do not agree";
    case errc::cannot_be_emulated: return "an emulated slave does not have a part of the device";
    }
    return "unknown error";
}

/// Why an ESI file or a device cannot be used.
struct error {
    errc code{};
    std::string element{}; ///< its name, without brackets; empty for the whole file
    std::size_t line{};    ///< of the file, from 1; 0 for a file that cannot be read, or for a device
    std::string message{}; ///< `file:line: <element>: problem and expectation`

    friend bool operator==(const error&, const error&) = default;
};

/// What is wrong, and where.
[[nodiscard]] inline std::string_view describe(const error& why) noexcept { return why.message; }

/// The error as an exception. `what()` is its message.
class esi_error : public std::runtime_error {
  public:
    explicit esi_error(esi::error why) : std::runtime_error{why.message}, error_{std::move(why)} {}

    [[nodiscard]] const esi::error& error() const noexcept { return error_; }
    [[nodiscard]] errc code() const noexcept { return error_.code; }

  private:
    esi::error error_;
};

} // namespace jauscat::esi
