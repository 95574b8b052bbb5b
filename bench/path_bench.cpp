// The whole way of a message: UDP datagram in, EtherCAT frame out. Without sockets against copying the frame's bytes;
// through loopback sockets against the same sockets without the work between them.
#include "pair.hpp"
#include <jauscat/bridge/delivery.hpp>
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/slave/loopback_link.hpp>
#include <jauscat/jaus/message/framing.hpp>
#include <jauscat/net/link/run_master.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>

#include <array>
#include <cstring>
#include <random>
#include <vector>

namespace {

namespace asio = boost::asio;
namespace bridging = jauscat::bridging;
namespace ethercat = jauscat::ethercat;
namespace jaus = jauscat::jaus;
namespace translation = jauscat::translation;
using bytes = std::vector<std::byte>;
using in_bytes = std::span<const std::byte>;
using out_bytes = std::span<std::byte>;

constexpr std::size_t item_count = 1024;
constexpr std::uint16_t station = 2;

struct any_object {
    ethercat::object_read read(std::uint16_t, std::uint8_t, out_bytes) noexcept { return {}; }
    ethercat::abort_code write(std::uint16_t, std::uint8_t, in_bytes) noexcept { return ethercat::abort_code::none; }
};

// What the master knows of a slave after start-up.
ethercat::slave_record slave_in_pre_op() {
    any_object objects;
    std::array slaves{ethercat::slave{{.vendor = 1, .product = 2}, objects}};
    ethercat::loopback_link link{slaves};
    ethercat::master_for<16> master;
    if (!jauscat::net::run(link, master, ethercat::bring_up{0, station})) return {};
    auto record = master.slaves().front();
    record.drained = true; // the first mailbox exchange would look whether it is empty
    return record;
}

// What a controller does with a datagram, up to the frame that carries the message: framing off, header checked,
// translated, posted to the slave's mailbox. Returns the frame's size, or 0.
template <class Table> [[gnu::noinline]] std::size_t path(in_bytes datagram, out_bytes frame_bytes) {
    using delivery = bridging::delivery<Table>;
    static ethercat::slave_record slave = slave_in_pre_op();
    static std::uint8_t index = 0;
    const auto message = jaus::remove_framing(datagram).message;
    const auto split = jaus::split(message);
    if (!split || delivery::deliverable(split.header) != jauscat::translate::errc::ok) return 0;
    std::array<std::byte, delivery::translator::max_packet_size> packet; // not zeroed: to_packet returns its size
    const auto packet_bytes = delivery::translator::to_packet(message, packet);
    if (!packet_bytes) return 0;
    const auto object = delivery::object_of(*packet_bytes);
    const auto transfer = ethercat::sdo_transfer::download(object.index, object.subindex, object.data);
    ethercat::mailbox_exchange exchange{slave};
    ethercat::frame_builder frame{frame_bytes, ++index};
    exchange.request(frame, slave, transfer);
    return frame.finish()->size();
}

[[gnu::noinline]] std::size_t copy_of_frame(out_bytes frame, std::size_t size) {
    static const std::array<std::byte, ethercat::max_frame_size> from{};
    std::memcpy(frame.data(), from.data(), size);
    return size;
}

/// Two sockets on loopback, one sending to the other.
class wire_pair {
  public:
    wire_pair() { out_.connect(in_.local_endpoint()); }
    std::size_t through(in_bytes datagram, out_bytes into) {
        out_.send(asio::buffer(datagram.data(), datagram.size()));
        return in_.receive(asio::buffer(into.data(), into.size()));
    }

  private:
    asio::io_context context_;
    asio::ip::udp::socket in_{context_, {asio::ip::address_v4::loopback(), 0}};
    asio::ip::udp::socket out_{context_, {asio::ip::address_v4::loopback(), 0}};
};

template <class Table> bool add(const std::string& table) {
    static std::vector<bytes> datagrams;
    static std::array<std::byte, ethercat::max_frame_size> frame;
    std::mt19937 random{3};
    bool agree = true;
    for (std::size_t i = 0; i != item_count; ++i) {
        bytes made(jaus::header_size + 20);
        const jaus::header head{.command_code = jaus::catalog[random() % jaus::catalog.size()].command_code,
                                .destination = {.instance = 5, .component = 33, .node = station, .subsystem = 1},
                                .source = {.instance = 2, .component = 32, .node = 3, .subsystem = 4},
                                .data_size = 20,
                                .sequence_number = static_cast<std::uint16_t>(random())};
        agree = agree && jauscat::wire::encode(head, made) && path<Table>(made, frame) != 0;
        datagrams.push_back(std::move(made));
    }
    const std::size_t size = path<Table>(datagrams.front(), frame);
    const std::span all{datagrams};
    bench::pair(
        "datagram to frame, " + table + " (memcpy)", all, [](const bytes& d) { return path<Table>(d, frame); }, all,
        [size](const bytes&) { return copy_of_frame(frame, size); });

    static wire_pair jaus_side, ethercat_side;
    static std::array<std::byte, 2048> received;
    bench::pair(
        "socket to socket, " + table + " (sockets alone)", all,
        [](const bytes& d) {
            const auto in = jaus_side.through(d, received);
            const auto out = path<Table>(std::span{received}.first(in), frame);
            return ethercat_side.through(std::span{frame}.first(out), received);
        },
        all,
        [size](const bytes& d) {
            jaus_side.through(d, received);
            return ethercat_side.through(std::span{frame}.first(size), received);
        });
    return agree;
}

} // namespace

bool bench::add_path_benchmarks() {
    return add<translation::seed_table>("seed table") && add<translation::self_contained_table>("self-contained table");
}
