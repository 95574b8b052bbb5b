// mapping-table.md: a table of one's own, for a packet that is not an EtherCAT card's.
//     docs_own_table
// [includes]
#include <jauscat/schema/jaus/header.hpp>
#include <jauscat/text/annotate.hpp>
#include <jauscat/translate/translator.hpp>

#include <array>
#include <iostream>

namespace jaus = jauscat::jaus;
namespace translate = jauscat::translate;
// [includes end]

// [packet]
/// The packet header of a radio link: 8 bytes, big endian.
struct radio_packet {
    std::uint16_t station{};
    std::uint8_t channel{};
    std::uint8_t message{}; ///< number of the message, from 1
    std::uint8_t place{};   ///< 0: a whole message, 1 to 3: first, middle, last part of one
    std::uint8_t counter{}; ///< set by the sender
    std::uint16_t size{};   ///< bytes of data that follow

    // clang-format off
    struct schema : jauscat::wire::items {
        using T = radio_packet;
        using type = layout<
            field<&T::station, u16be>,
            field<&T::channel, u8>,
            field<&T::message, u8>,
            field<&T::place, u8>,
            field<&T::counter, u8>,
            field<&T::size, u16be>>;
    };
    // clang-format on
};
// [packet end]
// [row]
/// The packet's value is `Factor` times the JAUS value.
template <class From, class To, std::uint32_t Factor> struct times {
    using uses = translate::path_list<From>;
    using writes = translate::path_list<To>;
    static constexpr translate::errc to_packet(const auto& header, auto& packet, translate::sizes) noexcept {
        To::of(packet) = static_cast<typename To::type>(From::of(header) * Factor);
        return translate::errc::ok;
    }
    static constexpr translate::errc from_packet(const auto& packet, auto& header, translate::sizes) noexcept {
        if (To::of(packet) % Factor != 0 || To::of(packet) / Factor > 255) return translate::errc::out_of_range;
        From::of(header) = static_cast<std::uint8_t>(To::of(packet) / Factor);
        return translate::errc::ok;
    }
};
// [row end]
// [table]
using J = jaus::header;
using A = jaus::address;
using P = radio_packet;
using translate::at;

inline constexpr std::array<std::uint16_t, 3> codes{0x0405, 0x2405, 0x4405}; // the messages that the radio carries

// clang-format off
using radio_table = translate::table<J, P, 200, // at most 200 bytes of data
    times<at<&J::destination, &A::node>, at<&P::station>, 16>,           // node 2 is station 32
    translate::copy<at<&J::destination, &A::component>, at<&P::channel>>,
    translate::code_rank<at<&J::command_code>, at<&P::message>, codes>,       // 0405h is 1, 2405h is 2, 4405h is 3
    translate::map_values<at<&J::data_flag>, at<&P::place>,
        translate::value_pair<jaus::data_flag::only, 0>,
        translate::value_pair<jaus::data_flag::first, 1>,
        translate::value_pair<jaus::data_flag::middle, 2>,
        translate::value_pair<jaus::data_flag::last, 3>>,                      // all other flags are refused
    translate::body_size<at<&J::data_size>>,                             // not carried: derived from the packet's size
    translate::data_count<at<&P::size>>,
    translate::caller_set<at<&P::counter>>,                                   // set by the caller
    translate::rest>;                                                    // all other fields, in the data
// clang-format on
// [table end]

int main() {
    // [use]
    using radio = translate::translator<radio_table>;
    // A Set Wrench Effort for 2.2.33.1: half of the force forward.
    const std::array<unsigned char, 20> octets{0x06, 0x02, 0x05, 0x04, 1,    33,   2,    2,    1,    32,
                                               1,    1,    4,    0,    0x22, 0x00, 0x01, 0x00, 0x00, 0x40};

    std::array<std::byte, radio::max_packet_size> packet{};
    const auto sent = radio::to_packet(std::as_bytes(std::span{octets}), packet, {.counter = 7});
    if (!sent) return std::cerr << describe(sent.error()) << '\n', 1;
    std::cout << jauscat::text::annotate<radio_packet>(*sent)
              << "  data: " << jauscat::text::hex(sent->subspan(radio::packet_size)) << '\n';

    std::array<std::byte, radio::max_message_size> again{};
    const auto back = radio::from_packet(*sent, again);
    if (!back) return std::cerr << describe(back.error()) << '\n', 1;
    std::cout << "back: " << jauscat::text::hex(*back) << '\n';
    // [use end]
}
