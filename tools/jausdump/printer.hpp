// Records as readable lines or as JSON.
#pragma once
#include "record.hpp"
#include "support/colour.hpp"
#include "time_stamps.hpp"
#include <jauscat/text/jaus.hpp>

#include <map>

namespace jausdump {

using example::palette;

/// How much of what was seen.
class summary {
  public:
    void add(const record& message);
    void skip(const std::string& reason) { ++skipped_[reason]; }
    /// Messages of another form of JAUS.
    void skip_foreign(const std::string& form) { ++foreign_[form]; }
    void lose_data_set() { ++lost_; }
    void lose_transfer() { ++lost_transfers_; }
    [[nodiscard]] bool empty() const {
        return by_type_.empty() && refused_.empty() && skipped_.empty() && foreign_.empty();
    }
    /// Whether a message was broken or unknown, a data set or a transfer incomplete, or all messages of another form.
    [[nodiscard]] bool something_did_not_decode() const;
    [[nodiscard]] std::string text(const palette& colour) const;
    [[nodiscard]] json object() const;

  private:
    struct tally {
        std::size_t count{}, bytes{}, not_decoded{};
    };
    std::map<std::pair<std::string, std::string>, tally> by_type_{}; ///< by code and name
    std::map<kind, std::size_t> by_kind_{};
    std::map<std::string, std::size_t> refused_{}; ///< by message and reason
    std::map<std::string, std::size_t> skipped_{};
    std::map<std::string, std::size_t> foreign_{}; ///< datagrams, by form
    std::size_t lost_{}, lost_transfers_{};
};

/// The columns' names; sizes are those of bodies, in bytes.
std::string heading(const palette& colour, time_display display);
/// A line for the message, then its fields; also its bytes with their offsets, if `with_bytes`.
std::string to_text(const record& message, const time_stamp& stamp, const palette& colour, bool with_bytes);
/// One object on one line.
std::string to_json_line(const record& message, const time_stamp& time);
inline std::string to_json_line(const record& message) { return to_json_line(message, {.value = message.origin.time}); }

} // namespace jausdump
