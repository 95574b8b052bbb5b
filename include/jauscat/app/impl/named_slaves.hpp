// The slaves that the options of a bus name: which of those that are found they are.
#pragma once
#include <jauscat/app/bus_error.hpp>
#include <jauscat/ethercat/master/clock_record.hpp>
#include <jauscat/ethercat/master/jobs.hpp>
#include <jauscat/ethercat/master/slave_matching.hpp>
#include <jauscat/net/config/slave_entry.hpp>

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

class bus_user;

/// A slave of the options.
struct named_slave {
    net::slave_entry entry{};                       ///< with the identity of its ESI file
    std::vector<ethercat::init_command> start_up{}; ///< refer to the entry
    std::uint16_t station{};                        ///< that it gets; 0: any
    boost::system::error_code why{};                ///< it is refused
    bus_user* user{};                               ///< waits for it
};

/// None: it has none.
[[nodiscard]] inline std::optional<ethercat::sync_settings> sync_of(const named_slave* slave) {
    if (slave == nullptr || !slave->entry.sync) return std::nullopt;
    const auto& sync = *slave->entry.sync;
    return ethercat::sync_settings{.assign_activate = sync.assign_activate,
                                   .sync0_cycle = sync.cycle,
                                   .sync1_delay = sync.sync1_delay,
                                   .shift = std::chrono::nanoseconds{sync.shift}};
}

class named_slaves {
  public:
    /// Reads the ESI files. Throws `std::invalid_argument` for slaves that cannot be told apart, and for files that
    /// cannot be read.
    JAUSCAT_DECL explicit named_slaves(std::vector<net::slave_entry> entries);
    named_slaves(const named_slaves&) = delete;
    named_slaves& operator=(const named_slaves&) = delete;

    [[nodiscard]] std::span<named_slave> all() noexcept { return all_; }
    [[nodiscard]] bool empty() const noexcept { return all_.empty(); }
    /// Nullptr: there is none of this name.
    [[nodiscard]] JAUSCAT_DECL named_slave* find(std::string_view name) noexcept;
    /// Explicit device identifications are to be read.
    [[nodiscard]] JAUSCAT_DECL bool has_identification() const noexcept;
    /// A match for each of `all()`. Positions do not count optional slaves that may be anywhere.
    [[nodiscard]] JAUSCAT_DECL std::vector<ethercat::matched_slave>
    match(std::vector<ethercat::found_slave> found) const;

  private:
    std::vector<named_slave> all_{};
};

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
