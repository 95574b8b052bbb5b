// Request packets executed by a master over a simulated link with emulated slaves.
#pragma once

#include "ethercat/objects.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/simulated_link.hpp"
#include <jauscat/ethercat/hilscher/packet_job.hpp>
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>

#include <deque>
#include <string>
#include <vector>

namespace jauscat::test {

/// What is left of a confirmation when its header is known.
struct confirmed {
    std::uint32_t command{};
    std::uint32_t status{};
    std::uint32_t length{};
    std::string body{}; ///< hex
};

/// `Objects` stand behind the standard objects of each slave.
template <class Objects> class basic_packet_bench {
  public:
    using bytes = std::vector<std::byte>;

    struct device {
        Objects own{};
        ethercat::standard_objects dictionary;
        ethercat::slave slave;

        explicit device(const ethercat::slave_description& description)
            : dictionary{description, own}, slave{description, dictionary} {}
    };
    std::deque<device> devices{};
    simulated_link link{[this](std::span<std::byte> frame) {
        for (auto& each : devices) each.slave.process(frame);
    }};
    ethercat::master_for<16> master{};
    ethercat::packet_options options{};

    /// Puts another slave at the end of the ring.
    device& add(const ethercat::slave_description& description) { return devices.emplace_back(description); }

    /// Has a packet executed and returns its confirmation.
    bytes execute(std::span<const std::byte> request, std::size_t room = ethercat::packet_job::confirmation_size) {
        bytes confirmation(room);
        const auto made =
            ethercat::execute_packet(master, request, confirmation, [&] { return link.run(master); }, options);
        confirmation.resize(made.size());
        return confirmation;
    }
    std::string answer(const char* request) { return to_hex(execute(from_hex(request))); }

    /// Has the packet of a schema executed, and checks that the confirmation is its own.
    template <class Packet> confirmed ask(Packet packet, std::span<const std::byte> data = {}) {
        packet.head.ul_dest = 0x20;
        packet.head.ul_src = 0x11223344;
        packet.head.ul_id = ++id_;
        packet.head.ul_len = static_cast<std::uint32_t>(wire::max_size<Packet> - 40 + data.size());
        bytes request(wire::max_size<Packet>);
        REQUIRE(wire::encode(packet, request));
        request.insert(request.end(), data.begin(), data.end());
        const auto confirmation = execute(request);
        hilscher::packet_header head{};
        REQUIRE(wire::decode_prefix(head, confirmation));
        CHECK(head.ul_dest == 0x20);
        CHECK(head.ul_src == 0x11223344);
        CHECK(head.ul_id == id_);
        CHECK(static_cast<std::uint32_t>(head.ul_cmd) == static_cast<std::uint32_t>(packet.head.ul_cmd) + 1);
        CHECK(head.ul_len == confirmation.size() - 40);
        const auto body = std::span{confirmation}.subspan(40);
        return {static_cast<std::uint32_t>(head.ul_cmd), static_cast<std::uint32_t>(head.ul_sta), head.ul_len,
                body.empty() ? std::string{} : to_hex(body)};
    }

  private:
    std::uint32_t id_{};
};

using packet_bench = basic_packet_bench<objects>;

} // namespace jauscat::test
