// Single datagrams to emulated slaves, and mailbox messages to one, byte for byte.
#pragma once

#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/ethercat/slave/slave.hpp>

#include <string>
#include <vector>

namespace jauscat::test {

/// A datagram as it came back.
struct returned_datagram {
    std::uint16_t working_counter{};
    std::uint16_t adp{};
    std::vector<std::byte> data{};
};

/// Sends a frame of one datagram through whatever `process` does to it.
returned_datagram send_through(auto&& process, ethercat::command cmd, std::uint16_t adp, std::uint16_t ado,
                               std::span<const std::byte> data) {
    constexpr std::uint8_t index = 7;
    std::vector<std::byte> frame(ethercat::max_frame_size);
    ethercat::frame_builder builder{frame, index};
    builder.add(cmd, adp, ado, data);
    const auto finished = builder.finish();
    REQUIRE(finished);
    process(*finished);
    ethercat::frame_view view;
    REQUIRE(view.parse(frame));
    const auto datagram = *view.begin();
    REQUIRE(datagram.header.index == index);
    return {datagram.working_counter, datagram.header.adp, {datagram.data.begin(), datagram.data.end()}};
}

/// The message in a reply mailbox that was read, as long as its header says; empty if there was none.
inline std::string mail_in(const returned_datagram& read) {
    if (read.working_counter == 0) return {};
    ethercat::mailbox_header header{};
    const auto used = wire::decode_prefix(header, read.data);
    REQUIRE(used);
    return to_hex(std::span{read.data}.first(*used + header.length));
}

/// Mailboxes are of one size, at 0x1000 and 0x1600.
class slave_bench {
  public:
    static ethercat::slave_description sized(ethercat::slave_description description, std::uint16_t size) {
        description.mailbox_out_size = description.mailbox_in_size = size;
        return description;
    }

    /// Brings the slave to PRE-OP.
    void start(ethercat::slave& device, std::uint16_t mailbox_size) {
        device_ = &device;
        size_ = mailbox_size;
        using namespace ethercat;
        const sync_manager out{.start = 0x1000,
                               .length = size_,
                               .mode = sync_manager_mode::mailbox,
                               .direction = sync_manager_direction::master_writes,
                               .enable = true};
        const sync_manager in{.start = 0x1600, .length = size_, .mode = sync_manager_mode::mailbox, .enable = true};
        std::vector<std::byte> bytes(16);
        REQUIRE(wire::encode(mailbox_managers{out, in}, bytes));
        REQUIRE(send(command::apwr, 0x0800, bytes).working_counter == 1);
        CHECK(state("0200") == "02 00 00 00 00 00");
    }

    returned_datagram send(ethercat::command cmd, std::uint16_t ado, std::span<const std::byte> data) {
        return send_through([this](std::span<std::byte> frame) { device_->process(frame); }, cmd, 0, ado, data);
    }
    std::uint16_t write(std::uint16_t ado, std::string_view hex) {
        return send(ethercat::command::apwr, ado, from_hex(hex)).working_counter;
    }
    std::string read(std::uint16_t ado, std::size_t size) {
        return to_hex(send(ethercat::command::aprd, ado, std::vector<std::byte>(size)).data);
    }
    /// Asks for a state; AL status up to its code.
    std::string state(std::string_view control) {
        write(0x0120, control);
        return read(0x0130, 6);
    }
    /// 4 bytes of the SII.
    std::string sii(std::uint32_t word) {
        const ethercat::sii_request request{.cmd = ethercat::sii_command::read, .address = word};
        std::vector<std::byte> bytes(6);
        REQUIRE(wire::encode(request, bytes));
        send(ethercat::command::apwr, 0x0502, bytes);
        return read(0x0508, 4);
    }

    /// A message into the slave's mailbox; false if that is full.
    bool put(std::string_view hex) {
        auto message = from_hex(hex);
        message.resize(size_);
        return send(ethercat::command::apwr, 0x1000, message).working_counter == 1;
    }
    /// The message in the reply mailbox; empty if there is none.
    std::string take() { return mail_in(send(ethercat::command::aprd, 0x1600, std::vector<std::byte>(size_))); }
    std::string ask(std::string_view hex) {
        CHECK(put(hex));
        return take();
    }
    void toggle_repeat() {
        repeat_ = !repeat_;
        write(0x080E, repeat_ ? "03" : "01");
    }

  private:
    ethercat::slave* device_{};
    std::uint16_t size_{};
    bool repeat_{};
};

} // namespace jauscat::test
