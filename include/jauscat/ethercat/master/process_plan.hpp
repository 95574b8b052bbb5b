// Cuts the process image into datagrams, and these into frames.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/process_image.hpp>
#include <jauscat/ethercat/master/slave_record.hpp>
#include <jauscat/ethercat/master/slave_status.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>

namespace jauscat::ethercat {

/// A slave in the cyclic exchange.
struct process_member {
    std::uint16_t station{};
    bool has_mailbox{};
    process_place place{};
    slave_status status{};
};

/// A range of the image that has a datagram of its own: an LRW, or an LWR and an LRD. It holds whole slaves.
struct process_part {
    std::uint32_t address{};
    std::size_t size{};
    std::size_t members{};    ///< in the order of their addresses
    process_image counters{}; ///< working counters of a complete exchange
};

/// A frame of a cycle: consecutive parts, and consecutive members. Those with process data come first.
struct process_frame {
    std::size_t first_part{}, parts{};
    std::size_t first_member{}, members{};
    std::size_t size{}; ///< bytes of the datagrams
    bool waits{};       ///< it has not come back
    time_point sent_at{};
};

/// Memory for one slave: no cycle has more parts, or more frames, than slaves.
struct process_slot {
    process_member member{};
    process_part part{};
    process_frame frame{};
};

/// The frames of a cycle, in memory lent by the user. Each slave's data travel in one datagram, and what is read of a
/// watched slave in the same frame.
class process_plan {
  public:
    static constexpr std::size_t filler_size = 1;

    explicit process_plan(std::span<process_slot> memory) noexcept : slots_{memory} {}

    [[nodiscard]] std::size_t capacity() const noexcept { return slots_.size(); }
    [[nodiscard]] std::size_t member_count() const noexcept { return members_; }
    [[nodiscard]] std::size_t frame_count() const noexcept { return frames_; }
    [[nodiscard]] process_member& member(std::size_t i) const noexcept { return slots_[i].member; }
    [[nodiscard]] process_part& part(std::size_t i) const noexcept { return slots_[i].part; }
    [[nodiscard]] process_frame& frame(std::size_t i) const noexcept { return slots_[i].frame; }

    /// The member with this place and station; nullptr where there is none. Only after `cut`.
    [[nodiscard]] JAUSCAT_FUNCTION process_member* find(std::uint16_t station,
                                                        const process_place& place) const noexcept;

    /// Only while there are fewer members than the capacity.
    JAUSCAT_FUNCTION void add(const slave_record& slave) noexcept;
    template <class Stays> void remove_unless(Stays&& stays) noexcept {
        std::size_t kept = 0;
        for (std::size_t i = 0; i != members_; ++i)
            if (stays(slots_[i].member)) slots_[kept++].member = slots_[i].member;
        members_ = kept;
        frames_ = 0;
    }

    /// Distributes the members over datagrams and frames; `reserved` bytes of the first frame are left. False where the
    /// data of a slave are larger than a frame: there are no frames then.
    [[nodiscard]] JAUSCAT_FUNCTION bool cut(bool watches, std::size_t reserved = 0) noexcept;

    /// Bytes of the datagrams that read the state of a watched slave.
    [[nodiscard]] static constexpr std::size_t watch_size(bool has_mailbox) noexcept {
        return datagram_overhead + wire::max_size<al_status> +
               (has_mailbox ? datagram_overhead + wire::max_size<sync_manager_handshake> : 0);
    }

  private:
    using order = std::tuple<bool, std::uint32_t, std::uint16_t>;

    JAUSCAT_FUNCTION static order key_of(std::uint16_t station, const process_place& place) noexcept;
    JAUSCAT_FUNCTION static order key_of_slot(const process_slot& slot) noexcept;

    // Only the members move. Insertion: after a change of one slave the others are in order.
    JAUSCAT_FUNCTION void sort() noexcept;

    [[nodiscard]] JAUSCAT_FUNCTION bool place(std::size_t i, bool watches) noexcept;
    // Whether a slave's data can be in the same datagram as those of the slave before.
    [[nodiscard]] JAUSCAT_FUNCTION bool joins(const process_place& added, std::size_t data) const noexcept;

    std::span<process_slot> slots_;
    std::size_t members_{}, parts_{}, frames_{};
    std::size_t reserved_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/process_plan.ipp>
#endif
