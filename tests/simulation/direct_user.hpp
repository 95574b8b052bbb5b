// An application that uses the master of a bridge itself: its SDO transfers take turns with those of the bridge, and
// some of them are given up before their answer.
#pragma once

#include "simulation/ring.hpp"
#include <jauscat/bridge/ring.hpp>

#include <array>
#include <optional>
#include <vector>

namespace simulation {

class direct_user {
  public:
    /// Transfers to the slaves of a ring; of drives it reads serial numbers. `user`: the actor, whose event
    /// `to_give_up` has the number of a transfer.
    direct_user(world& w, ring& wire, actor& user, std::uint8_t number, std::uint8_t to_give_up);

    /// A new life of the program begins.
    void start() noexcept { open_.reset(); }
    [[nodiscard]] bridging::shared_jobs jobs() noexcept;
    /// Its own deadline has passed. False: that transfer has ended.
    [[nodiscard]] bool gives_up(std::uint32_t number) noexcept;
    /// While it does, it begins no transfer.
    void waits(bool is_on) noexcept { waits_ = is_on; }

  private:
    struct transfer {
        std::uint32_t number{};
        std::size_t slave{};
        bool is_upload{};
        std::uint8_t subindex{};
        bool is_identity{}; ///< the serial number, of a slave that is no arm
        time begun{};
        direct_object::word value{}; ///< of a download
        [[nodiscard]] std::size_t size() const noexcept {
            return is_identity ? 4 : 8 * direct_object::words[subindex - 1U];
        }
    };

    bool begin(ethercat::master& idle);
    void done(ethercat::master& idle);
    void check_upload(bytes answer);
    void check_serial(bytes answer);
    void check_download();
    void breaks(const std::string& expected, std::string found);
    [[nodiscard]] time some_deadline();

    world& world_;
    ring& wire_;
    actor& user_;
    std::uint8_t number_, to_give_up_;
    generator random_;
    std::vector<std::size_t> arms_{}; ///< without any: all
    std::optional<transfer> open_{};
    bool is_given_up_{}, waits_{}, has_arms_{};
    std::size_t last_slave_{};
    std::uint32_t count_{};
    time next_at_{};
    std::array<std::byte, direct_object::longest> data_{};
};

} // namespace simulation
