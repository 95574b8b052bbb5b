// The tree of the slaves, and the delay of a frame from the reference clock to each of them, out of the ports that are
// open and the local times at which one frame passed them.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/master/clock_record.hpp>
#include <jauscat/ethercat/master/master_errc.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// What measured delays have to be like.
struct clock_delay_options {
    std::uint32_t longest_cable{100'000}; ///< ns: a longer delay between neighbours is an error
    /// By how much longer, in ns, a frame takes through the processing unit of a slave than past it.
    std::int32_t processing_difference{};
};

namespace detail {

/// Ports in the order in which a frame passes them.
inline constexpr std::array<std::uint8_t, 4> port_order{0, 3, 1, 2};

/// The last open port before `place` of the order: where the frame came from.
[[nodiscard]] JAUSCAT_CONSTEXPR std::size_t open_before(const clock_record& slave, std::size_t place) noexcept;
[[nodiscard]] JAUSCAT_CONSTEXPR std::size_t place_of(std::size_t port) noexcept;
/// Time from a frame's arrival until it leaves back to the master: of all slaves behind this one.
[[nodiscard]] JAUSCAT_CONSTEXPR std::uint32_t loop_time(const clock_record& slave) noexcept;

} // namespace detail

/// The place of the reference clock, the first slave that has a clock; the number of slaves if none has.
[[nodiscard]] JAUSCAT_CONSTEXPR std::size_t reference_clock(std::span<const clock_record> slaves) noexcept;

/// Finds `parent` and `parent_port` of each slave out of `open`. `slaves` stand in the order of their positions. Error:
/// clock_topology, a slave that no open port is left for.
[[nodiscard]] JAUSCAT_CONSTEXPR master_result<> find_parents(std::span<clock_record> slaves) noexcept;

/// Computes `delay` of each slave that has a clock, from its nearest ancestor that has one. Slaves without a clock
/// count as cable. Needs `parent` and `received`. Errors: clock_topology, for a slave that has no such ancestor, or a
/// slave without a clock where the line branches; clock_delay, for a cable that is too long to be true.
[[nodiscard]] JAUSCAT_CONSTEXPR master_result<> find_delays(std::span<clock_record> slaves,
                                                            const clock_delay_options& options = {}) noexcept;

/// The time of which a clock of 32 bits shows `low`: the one nearest to `estimate`.
[[nodiscard]] JAUSCAT_CONSTEXPR std::uint64_t extend_time(std::uint32_t low, std::uint64_t estimate) noexcept;

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/clock_topology.ipp>
#endif
