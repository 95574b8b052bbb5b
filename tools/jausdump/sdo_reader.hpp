// SDO transfers out of mailbox messages: the data of objects, and refusals.
#pragma once
#include "mailbox_reader.hpp"
#include "record.hpp"
#include <jauscat/schema/ethercat/coe.hpp>

#include <functional>
#include <map>

namespace jausdump {

/// An object that a master writes or reads.
struct object_transfer {
    slave_address slave{};
    bool download{};
    std::uint16_t index{};
    std::uint8_t subindex{};
    bool complete_access{};
    std::vector<std::byte> data{}; ///< as far as they have come
};

struct sdo_listener {
    /// All data have been captured. Whether the slave accepts a download follows later.
    std::function<void(const object_transfer&)> carried{};
    std::function<void(const object_transfer&, const refusal&)> refused{};
    std::function<void(const object_transfer&)> lost{}; ///< segments are missing, or are not as announced
    std::function<void(const std::string& reason)> skipped{};
};

/// Follows one transfer for each slave: expedited, normal and in segments.
class sdo_reader {
  public:
    explicit sdo_reader(sdo_listener listener) : listener_{std::move(listener)} {}

    void read(const mailbox_message& message);
    /// The capture has ended.
    void finish();

  private:
    struct transfer {
        object_transfer object{};
        bool in_segments{};        ///< the first message had not all data
        bool open{};               ///< data are missing
        bool toggle{};             ///< of the next segment
        std::uint32_t announced{}; ///< bytes of all data
    };

    void read_request(const slave_address& slave, std::span<const std::byte> sdo);
    void read_response(const slave_address& slave, std::span<const std::byte> sdo);
    transfer* begin(const slave_address& slave, std::span<const std::byte> sdo, bool download);
    void take_initial(transfer& begun, std::span<const std::byte> sdo);
    void take_segment(const slave_address& slave, std::span<const std::byte> sdo, bool download);
    void take_abort(const slave_address& slave, std::span<const std::byte> sdo, const char* by);
    void take_mailbox_error(const mailbox_message& message);
    void confirm(const transfer* known);
    void lose(const slave_address& slave);
    transfer* find(const slave_address& slave);
    transfer* find_asked(const slave_address& slave, std::span<const std::byte> sdo);

    sdo_listener listener_;
    std::map<slave_address, transfer> transfers_{};
};

} // namespace jausdump
