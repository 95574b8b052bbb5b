// Determines a slave's process data and configures its SyncManagers, FMMUs and watchdog. Source: CoE (PDO assignment
// 1C10h + SyncManager, PDO mapping objects), else the SII.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/process_image.hpp>
#include <jauscat/ethercat/master/sdo_transfer.hpp>
#include <jauscat/ethercat/master/sii_read.hpp>
#include <jauscat/ethercat/master/sii_survey.hpp>
#include <jauscat/ethercat/master/slave_record.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/schema/ethercat/watchdog.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// State machine: while `wants_upload`, run `upload()` and pass its result to `uploaded`; else `request` adds the
/// datagrams of the present step and `reply` takes their return. Stays in place while it runs.
class process_setup {
  public:
    /// At most, of the present request: bytes and datagrams.
    [[nodiscard]] JAUSCAT_FUNCTION std::size_t request_size() const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION std::size_t request_datagrams() const noexcept;

    process_setup() noexcept = default;
    /// `slave` is in PRE-OP. Its place begins at `image_end`, where that of all other slaves ends, and moves it. It
    /// stays in place while this runs. `objects` get their places.
    JAUSCAT_FUNCTION process_setup(const slave_record& slave, std::uint32_t& image_end,
                                   std::chrono::nanoseconds watchdog, std::uint32_t logical_base = 0,
                                   std::span<process_object> objects = {}) noexcept;

    [[nodiscard]] const master_result<>& result() const noexcept { return result_; }
    /// Location of the process data, when done.
    [[nodiscard]] const process_place& place() const noexcept { return place_; }
    [[nodiscard]] JAUSCAT_FUNCTION std::chrono::nanoseconds watchdog() const noexcept;

    [[nodiscard]] bool wants_upload() const noexcept { return step_ == step::assignment || step_ == step::mapping; }
    /// The upload that it waits for.
    [[nodiscard]] JAUSCAT_FUNCTION sdo_transfer upload() noexcept;
    /// Continues with the result of the upload: its bytes.
    JAUSCAT_FUNCTION progress uploaded(const master_result<std::size_t>& upload) noexcept;

    JAUSCAT_FUNCTION void request(frame_builder& frame) noexcept;

    JAUSCAT_FUNCTION progress reply(replies datagrams, time_point now, const master_config& config) noexcept;

  private:
    enum class step : std::uint8_t {
        describe,
        take_sii,
        survey,
        assignment, // CoE: which PDOs a SyncManager carries
        mapping,    // CoE: what a PDO is made of
        give_sii,
        set_up,
        set_watchdog,
        check_watchdog,
    };
    static constexpr std::size_t max_fmmus = 16;
    static constexpr std::size_t sync_manager_size = datagram_overhead + wire::max_size<sync_manager>;

    JAUSCAT_FUNCTION progress go(step next) noexcept;
    JAUSCAT_FUNCTION progress fail(const master_error& error) noexcept;
    // Fails once the slave's application has the SII again.
    JAUSCAT_FUNCTION progress give_back(const master_error& why) noexcept;
    JAUSCAT_FUNCTION progress survey(bool sizes) noexcept;
    // The SyncManagers whose PDOs the SII says, a bit each.
    [[nodiscard]] JAUSCAT_FUNCTION std::uint32_t searched() noexcept;
    // With the object that is read.
    [[nodiscard]] JAUSCAT_FUNCTION master_error about_object(master_error error) noexcept;

    // CoE: every PDO of every SyncManager, and every entry of every PDO.
    JAUSCAT_FUNCTION progress next_manager() noexcept;
    [[nodiscard]] process_manager& managed() noexcept { return survey_.managers()[manager_]; }
    JAUSCAT_FUNCTION progress assigned(std::uint32_t value) noexcept;
    JAUSCAT_FUNCTION progress next_pdo() noexcept;
    JAUSCAT_FUNCTION progress mapped(std::uint32_t value) noexcept;
    // Whether so many more are within the limit of the whole job.
    [[nodiscard]] JAUSCAT_FUNCTION bool takes_objects(std::uint32_t more) noexcept;
    // Subindex 0 counts the others in one byte.
    [[nodiscard]] JAUSCAT_FUNCTION std::span<std::byte> room(std::uint32_t subindex) noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION std::uint32_t number_of(std::size_t size) const noexcept;

    JAUSCAT_FUNCTION progress lay_out() noexcept;
    // From the first bit of their SyncManager to that of all outputs or inputs.
    JAUSCAT_FUNCTION void place_objects() noexcept;

    // All in one frame. A SyncManager can be changed only while it is off.
    JAUSCAT_FUNCTION void set_up(frame_builder& frame) const noexcept;

    // An earlier tool may have left any value in these registers, and registers may be missing.
    JAUSCAT_FUNCTION void read_watchdog(frame_builder& frame) const noexcept;
    JAUSCAT_FUNCTION progress check_watchdog(replies datagrams) noexcept;

    std::uint16_t station_{};
    bool coe_{};
    process_place before_{}, place_{};
    std::uint32_t* image_end_{};
    std::uint16_t watchdog_units_{};
    std::uint32_t logical_base_{};
    std::uint8_t fmmus_{};
    std::span<process_object> objects_{};
    step step_{};

    sii_survey survey_{};
    bool by_coe_{};          // the slave's objects are to say how many bits there are
    std::size_t manager_{};  // whose assignment is read
    std::uint32_t by_sii_{}; // SyncManagers without an assignment object, a bit each: for them the SII says it
    std::array<process_manager, sii_survey::capacity> by_objects_{}; // what the objects have said

    std::array<std::byte, 4> value_{}; // of an object
    std::uint32_t pdo_{}, pdos_left_{}, entry_{}, entries_left_{};
    std::uint32_t read_{}; // PDOs and entries so far, of all SyncManagers
    std::uint16_t mapping_{};
    master_error failure_{}; // after which the SII is to be given back
    master_result<> result_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/process_setup.ipp>
#endif
