// A master, a link and a slave that can take objects in segments, with every mailbox message kept as text.
#pragma once

#include "ethercat/objects.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/simulated_link.hpp"
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/slave/slave.hpp>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace jauscat::test {

struct segmented_bench {
    using bytes = std::vector<std::byte>;
    using datagram = ethercat::basic_datagram<std::byte>;
    static constexpr std::uint16_t index = 0x6926;
    static constexpr std::uint8_t subindex = 1;

    test::objects objects{};
    bytes memory = bytes(4096);
    ethercat::slave device;
    bool works{true};
    simulated_link link{[this](std::span<std::byte> frame) {
        device.pass(frame);
        if (works) device.work();
    }};
    ethercat::master_for<16> master{};
    std::vector<std::string> mail{}; ///< messages that were taken, from the mailbox header on
    bool keeps_mail{true};
    std::function<void(const datagram&)> before_read{}; ///< may change a message that the master is about to get

    explicit segmented_bench(std::uint16_t mailbox_size, ethercat::coe_options options = {})
        : segmented_bench{mailbox_size, mailbox_size, options} {}
    segmented_bench(std::uint16_t mailbox_out_size, std::uint16_t mailbox_in_size, ethercat::coe_options options = {})
        : device{{.mailbox_out_size = mailbox_out_size, .mailbox_in_size = mailbox_in_size}, objects, [&] {
                     if (options.transfer_memory.empty()) options.transfer_memory = memory;
                     return options;
                 }()} {
        link.on_way_back = [this](bytes& frame) { look_at(frame); };
        REQUIRE(link.run(master, ethercat::bring_up{0, 0x1001}));
    }

    ethercat::master_result<> download(const bytes& data, const ethercat::download_options& options = {}) {
        return download(index, subindex, data, options);
    }
    ethercat::master_result<> download(std::uint16_t object, std::uint8_t entry, const bytes& data,
                                       const ethercat::download_options& options = {}) {
        mail.clear();
        return link.run(master, ethercat::download{0x1001, object, entry, data, options});
    }
    ethercat::master_result<std::size_t> upload(bytes& into, std::uint16_t object = index,
                                                std::uint8_t entry = subindex) {
        mail.clear();
        return size_of(link.run(master, ethercat::upload{0x1001, object, entry, into}));
    }
    void set(const bytes& value) { objects.entries[{index, subindex}].value = value; }
    [[nodiscard]] const bytes& stored() const { return objects.entries.at({index, subindex}).value; }

  private:
    void look_at(bytes& frame) {
        ethercat::mutable_frame_view view;
        if (!view.parse(frame)) FAIL("a frame that came back does not parse"); // REQUIRE is slow for every frame
        for (const auto d : view) {
            if (d.working_counter == 0 || (d.header.ado != 0x1000 && d.header.ado != 0x1600)) continue;
            if (d.header.ado == 0x1600 && before_read) before_read(d);
            ethercat::mailbox_header header{};
            if (wire::decode_prefix(header, d.data) && keeps_mail)
                mail.push_back(to_hex(d.data.first(std::size_t{6} + header.length)));
        }
    }
};

} // namespace jauscat::test
