// The frame that carries an object to a slave, as the master makes it: for pictures and worked bytes.
#pragma once

#include <jauscat/bridge/delivery.hpp>
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/slave/loopback_link.hpp>
#include <jauscat/net/link/run_master.hpp>

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <vector>

namespace jauscat::reference {

using bytes = std::vector<std::byte>;

/// A slave with one object that takes anything.
struct any_object {
    ethercat::object_read read(std::uint16_t, std::uint8_t, std::span<std::byte>) noexcept { return {}; }
    ethercat::abort_code write(std::uint16_t, std::uint8_t, std::span<const std::byte>) noexcept {
        return ethercat::abort_code::none;
    }
};

/// Keeps what the master sends.
struct recording_link {
    ethercat::loopback_link& link;
    std::vector<bytes> sent{};

    bool send(std::span<const std::byte> frame) {
        sent.emplace_back(frame.begin(), frame.end());
        return link.send(frame);
    }
    std::size_t receive(std::span<std::byte> buffer, std::chrono::nanoseconds timeout) {
        return link.receive(buffer, timeout);
    }
};

/// The first frame of an SDO download, as the master sends it.
inline bytes frame_with(const bridging::object_access& object) {
    any_object objects;
    std::array slaves{ethercat::slave{{.vendor = 1, .product = 2}, objects}};
    ethercat::loopback_link loop{slaves};
    recording_link link{loop};
    ethercat::master_for<16> master;
    if (!net::run(link, master, ethercat::bring_up{0, object.station})) throw std::logic_error{"no slave"};
    link.sent.clear();
    if (!net::run(link, master, ethercat::download{object.station, object.index, object.subindex, object.data}))
        throw std::logic_error{"the slave does not take the object"};
    for (const auto& frame : link.sent)
        if (std::search(frame.begin(), frame.end(), object.data.begin(), object.data.end()) != frame.end())
            return frame;
    throw std::logic_error{"no frame carries the object whole"};
}

} // namespace jauscat::reference
