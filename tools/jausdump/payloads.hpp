// The types of payload data elements, which do not travel with their values: given by the user, or heard in an earlier
// Report Payload Interface.
#pragma once
#include "record.hpp"
#include <jauscat/jaus/message/payload_reader.hpp>

#include <map>

namespace jausdump {

/// The interfaces of a payload by their number, from 1.
struct payload_interfaces {
    std::vector<jaus::payload_type> types{};
    std::vector<std::pair<double, double>> limits{}; ///< of each, for scaled types; empty: not known
};

/// The interfaces of each payload.
class payload_directory {
  public:
    payload_directory() = default;
    /// Every payload has these, in addition to those that it reports.
    explicit payload_directory(std::vector<jaus::payload_type> types)
        : given_{payload_interfaces{std::move(types), {}}} {}

    void learn(const jaus::address& payload, const jaus::report_payload_interface& report);
    /// nullptr: not known.
    [[nodiscard]] const payload_interfaces* commands(const jaus::address& payload) const;
    [[nodiscard]] const payload_interfaces* measurements(const jaus::address& payload) const;

  private:
    struct interfaces {
        payload_interfaces commands{}, measurements{};
    };
    [[nodiscard]] const interfaces* of(const jaus::address& payload) const;

    std::optional<payload_interfaces> given_{};
    std::map<std::uint32_t, interfaces> heard_{};
};

/// Type codes 1 to 22, as numbers between white space, commas or brackets. `name` is for the message of the
/// input_error that anything else gives.
std::vector<jaus::payload_type> parse_payload_types(const std::string& text, const std::string& name);

} // namespace jausdump
