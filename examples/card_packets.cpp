// Code made for a Hilscher EtherCAT master card (netX, cifX) on a plain network interface: it sends packets and takes
// their confirmations, as it would through the card's driver. Without an argument the slaves are emulated in this
// process; with one, "card_packets eth0", they are those on that interface.
#include <jauscat/ethercat/hilscher/packet_job.hpp>
#include <jauscat/ethercat/slave/loopback_link.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/net/link/raw_link.hpp>
#include <jauscat/net/link/run_master.hpp>
#include <jauscat/schema/ethercat/hilscher_info.hpp>
#include <jauscat/schema/ethercat/hilscher_state.hpp>
#include <jauscat/text/packet_status_text.hpp>
#include <jauscat/version.hpp>

#include <array>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace {

using namespace jauscat;

/// Replaces the card's driver: accepts a packet, has our master execute it and keeps the confirmation.
template <ethercat::link Link> class channel {
  public:
    explicit channel(Link& link) : link_{link} {}

    // [put_packet]
    void put_packet(std::span<const std::byte> request) {
        packet_ = ethercat::execute_packet(master_, request, confirmation_, [&] { return net::run(link_, master_); });
    }
    // [put_packet end]
    [[nodiscard]] std::span<const std::byte> get_packet() const { return packet_; }

  private:
    Link& link_;
    ethercat::master_for<16> master_{};
    std::array<std::byte, ethercat::packet_job::confirmation_size> confirmation_{};
    std::span<const std::byte> packet_{};
};

// From here on it is code for the card.

class failed : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

template <class Channel> class host {
  public:
    explicit host(Channel& channel) : channel_{channel} {}

    /// Sends a packet, with data after its fields, and returns the confirmation's fields; the data after them are in
    /// `data`.
    template <class Confirmation, class Request>
    Confirmation ask(std::string_view service, Request request, std::span<const std::byte> with = {}) {
        request.head.ul_dest = 0x20; // the channel in use
        request.head.ul_id = ++id_;
        request.head.ul_len = static_cast<std::uint32_t>(wire::max_size<Request> - header_size + with.size());
        std::array<std::byte, ethercat::packet_job::confirmation_size> packet{};
        const auto size = wire::encode(request, packet)->size();
        std::ranges::copy(with, packet.begin() + size);
        channel_.put_packet(std::span{packet}.first(size + with.size()));

        const auto answer = channel_.get_packet();
        hilscher::packet_header head{};
        Confirmation confirmation{};
        if (!wire::decode_prefix(head, answer) || head.ul_id != id_) throw failed{"no confirmation"};
        std::cout << service << ": " << text::explain(head.ul_sta) << "\n";
        if (head.ul_sta != hilscher::packet_status::ok) throw failed{std::string{service} + " failed"};
        const auto used = wire::decode_prefix(confirmation, answer);
        if (!used) throw failed{"a confirmation that is too short"};
        data = answer.subspan(*used);
        return confirmation;
    }

    std::span<const std::byte> data{}; ///< behind the fields of the last confirmation

  private:
    static constexpr std::size_t header_size = wire::max_size<hilscher::packet_header>;
    Channel& channel_;
    std::uint32_t id_{};
};

/// Prints the objects of a slave and their names.
template <class Channel> void print_dictionary(host<Channel>& card, std::uint32_t station) {
    const auto list = card.template ask<hilscher::get_od_list_confirmation>(
        "OD list",
        hilscher::get_od_list_request{.ul_node_id = station, .ul_list_type = hilscher::packet_list_type::all});
    const std::vector<std::byte> indices{card.data.begin(), card.data.end()}; // the next confirmation takes their place
    for (std::size_t i = 0; i != list.ul_data_cnt; ++i) {
        ethercat::object_query object{};
        if (!wire::decode_prefix(object, std::span{indices}.subspan(2 * i))) break;
        const auto description = card.template ask<hilscher::get_object_description_confirmation>(
            "object description",
            hilscher::get_object_description_request{.ul_node_id = station, .ul_index = object.index});
        std::cout << "  " << text::hex_number(object.index, 4) << " \"";
        for (const auto letter : card.data.first(description.ul_ob_name_len)) std::cout << static_cast<char>(letter);
        std::cout << "\", highest subindex " << description.ul_max_num_sub_index << "\n";
    }
}

/// Finds the slaves, lists the first one's objects, and takes all of them to SAFE-OP.
template <class Channel> void talk(Channel& channel) {
    host card{channel};
    const auto found = card.template ask<hilscher::start_bus_scan_confirmation>(
        "scan", hilscher::start_bus_scan_request{.ul_timeout = 1000});
    std::cout << "  slaves: " << found.ul_found_slaves << "\n";
    for (std::uint32_t i = 0; i != found.ul_found_slaves; ++i) {
        const auto slave = card.template ask<hilscher::get_bus_scan_info_confirmation>(
            "scan info", hilscher::get_bus_scan_info_request{.us_auto_inc_addr = static_cast<std::uint16_t>(0u - i)});
        std::cout << "  vendor " << text::hex_number(slave.ul_vendor_id, 8) << ", product "
                  << text::hex_number(slave.ul_product_code, 8) << "\n";
    }

    constexpr std::uint32_t first = 1; // stations in the order of the ring
    const auto identity = card.template ask<hilscher::sdo_upload_confirmation>(
        "upload", hilscher::sdo_upload_request{.ul_node_id = first, .ul_index = 0x1018, .ul_sub_index = 1});
    std::cout << "  0x1018:1 is " << text::hex(card.data.first(identity.ul_data_cnt)) << "\n";

    try {
        print_dictionary(card, first);
    } catch (const failed& refusal) {
        std::cout << "  " << refusal.what() << ": not every slave describes its objects\n";
    }

    card.template ask<hilscher::set_state_confirmation>(
        "set state", hilscher::set_state_request{.us_new_ec_state = hilscher::bus_state::safe_op});
    const auto state = card.template ask<hilscher::get_state_confirmation>("state", hilscher::get_state_request{});
    std::cout << "  state " << static_cast<unsigned>(state.us_current_ec_state) << "\n";
}

/// Two slaves that have nothing but what every slave has.
class emulated_ring {
  public:
    ethercat::loopback_link& link() { return link_; }

  private:
    struct no_objects {
        // The standard objects describe themselves, and these are none.
        [[nodiscard]] std::uint16_t next_index(std::uint16_t) const noexcept { return 0; }
        [[nodiscard]] std::optional<ethercat::object_info> describe(std::uint16_t) const noexcept { return {}; }
        [[nodiscard]] std::optional<ethercat::entry_info> describe(std::uint16_t, std::uint8_t) const noexcept {
            return {};
        }
        ethercat::object_read read(std::uint16_t, std::uint8_t, std::span<std::byte>) noexcept {
            return {.error = ethercat::abort_code::no_object};
        }
        ethercat::abort_code write(std::uint16_t, std::uint8_t, std::span<const std::byte>) noexcept {
            return ethercat::abort_code::no_object;
        }
    };
    static constexpr ethercat::slave_description first{.vendor = 0x1A2B, .product = 1},
        second{.vendor = 0x1A2B, .product = 2};
    no_objects own_{};
    ethercat::standard_objects first_{first, own_}, second_{second, own_};
    std::array<ethercat::slave, 2> slaves_{ethercat::slave{first, first_}, ethercat::slave{second, second_}};
    ethercat::loopback_link link_{slaves_};
};

} // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::string_view{argv[1]} == "--version")
        return std::cout << "card_packets (JausCat) " << JAUSCAT_VERSION_TEXT << '\n', 0;
    if (argc > 2 || (argc == 2 && argv[1][0] == '-')) {
        std::cerr << "card_packets [INTERFACE]\n";
        return 2;
    }
    try {
        if (argc > 1) {
            net::raw_link link{argv[1]};
            channel wire{link};
            talk(wire);
        } else {
            emulated_ring ring;
            channel wire{ring.link()};
            talk(wire);
        }
    } catch (const std::exception& problem) {
        std::cerr << "card_packets: " << problem.what() << "\n";
        return 1;
    }
    if (!std::cout.flush()) return std::cerr << "card_packets: standard output cannot be written\n", 1;
    return 0;
}
