// Mailbox messages out of captured EtherCAT frames.
#pragma once
#include "slave_address.hpp"
#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/schema/ethercat/mailbox.hpp>

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace jausdump {

/// A message that a slave's mailbox took or gave.
struct mailbox_message {
    slave_address slave{};
    bool to_slave{};
    jauscat::ethercat::mailbox_type type{};
    std::span<const std::byte> body{}; ///< behind the mailbox header
};

struct mailbox_listener {
    std::function<void(const mailbox_message&)> message{};
    std::function<void(const std::string& reason)> skipped{};
};

/// Finds each mailbox message once, although its frame passes the tap before and after the slaves, and although a
/// message may be repeated. A mailbox is recognised by its content, so that a capture need not begin with the setup of
/// the SyncManagers.
class mailbox_reader {
  public:
    explicit mailbox_reader(mailbox_listener listener) : listener_{std::move(listener)} {}

    /// A frame, EtherCAT header on.
    void read(std::span<const std::byte> frame);
    /// The capture has ended.
    void finish();

  private:
    using datagram = jauscat::ethercat::datagram_view;

    /// One direction of a slave's mailbox.
    struct lane {
        std::vector<std::byte> last{};    ///< the message that was executed last
        std::uint8_t last_index{};        ///< of its datagram
        std::vector<std::byte> pending{}; ///< a write that no slave has executed yet
    };
    /// A datagram with an address by position, before the slaves: each slave increments the address.
    struct position_access {
        jauscat::ethercat::command cmd{};
        std::uint16_t ado{}, adp{};
    };

    bool take(const datagram& each);
    void note_setup(const datagram& each);
    void pend(lane& direction, std::span<const std::byte> message);
    std::uint16_t position_of(const datagram& each) const;
    slave_address address_of(const datagram& each) const;

    mailbox_listener listener_;
    std::vector<std::byte> framed_{}; ///< the frame behind an Ethernet header
    std::map<std::pair<slave_address, bool>, lane> lanes_{};
    std::map<std::uint16_t, std::uint16_t> stations_{}; ///< by position
    std::array<std::optional<position_access>, 256> on_the_way_{};
};

} // namespace jausdump
