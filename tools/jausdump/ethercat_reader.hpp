// JAUS messages out of captured EtherCAT frames.
#pragma once
#include "object_table.hpp"

namespace jausdump {

struct ethercat_listener {
    std::function<void(std::span<const std::byte> message, const origin&)> message{};
    /// An object of a component with data that are no message of the table.
    std::function<void(std::span<const std::byte> data, jauscat::translate::errc, const origin&)> unreadable{};
    std::function<void(record)> refused{};
    std::function<void()> lost{}; ///< a message with missing segments
    std::function<void(const std::string& reason)> skipped{};
};

/// From frames to mailbox messages, SDO transfers, and JAUS messages by the table.
class ethercat_reader {
  public:
    ethercat_reader(const object_table& how, ethercat_listener listener);
    ethercat_reader(const ethercat_reader&) = delete;
    ethercat_reader& operator=(const ethercat_reader&) = delete;

    /// A frame, EtherCAT header on.
    void read(std::span<const std::byte> frame, const origin& from);
    /// The capture has ended.
    void finish();
    /// Frames that were read.
    [[nodiscard]] std::size_t frames() const { return frames_; }

  private:
    [[nodiscard]] origin origin_of(const object_transfer& object) const;
    void take(const object_transfer& object);

    object_table how_;
    ethercat_listener listener_;
    origin from_{}; ///< of the frame that is being read
    std::size_t frames_{};
    sdo_reader transfers_;
    mailbox_reader mailboxes_;
};

} // namespace jausdump
