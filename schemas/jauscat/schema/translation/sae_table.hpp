// The table of SAE JAUS: self-contained, exact as a packet and on the EtherCAT wire.
#pragma once
#include <jauscat/schema/ethercat/hilscher.hpp>
#include <jauscat/schema/sae/transport/message_head.hpp>
#include <jauscat/schema/translation/index_bases.hpp>
#include <jauscat/schema/translation/sae_ranks.hpp>
#include <jauscat/translate/table.hpp>

namespace jauscat::translation {

/// The table for any index base (see index_bases.hpp), lists of message IDs and largest abSdoData. The indices of
/// `sae_segments` are the base to the base + FFFh: 2000h to 2FFFh.
// clang-format off
template <std::uint32_t IndexBase = manufacturer_index_base, class Segments = sae_segments,
          std::size_t MaxData = hilscher::max_sdo_data>
struct sae_table_of {
    using J = sae::message_head;
    using T = sae::transport_header;
    using A = sae::jaus_id;
    using P = hilscher::sdo_download_request;
    using H = hilscher::packet_header;
    using type = translate::table<J, P, MaxData,
        translate::copy<translate::at<&J::transport, &T::destination, &A::node>, translate::at<&P::ul_node_id>>,
        translate::segmented_offset<translate::at<&J::transport, &T::destination, &A::component>,
            translate::at<&P::ul_index>, IndexBase, translate::at<&J::message_id>, Segments>,
        translate::segmented_rank<translate::at<&J::message_id>, translate::at<&P::ul_sub_index>, IndexBase,
            translate::at<&P::ul_index>, Segments>,
        translate::message_constant<translate::at<&J::transport, &T::message_type>, 0>,
        translate::message_constant<translate::at<&J::transport, &T::compression>, sae::compression::none>,
        translate::constant_in_rest<translate::at<&J::transport, &T::fragment_flag>, sae::fragment_flag::single,
            translate::errc::fragment_to_slave>,                     // other fragments have no message ID
        translate::body_size<translate::at<&J::transport, &T::size>, 14>, // stated by ulDataCnt; 14 bytes of head
        translate::least_body<2>,                                    // the sequence number
        translate::data_count<translate::at<&P::ul_data_cnt>>,
        translate::packet_length<translate::at<&P::head, &H::ul_len>, 16>,
        translate::constant<translate::at<&P::head, &H::ul_dest>, 0x20>, // the channel in use
        translate::constant<translate::at<&P::head, &H::ul_dest_id>, 0>,
        translate::constant<translate::at<&P::head, &H::ul_cmd>, hilscher::packet_command::sdo_download_req>,
        translate::constant<translate::at<&P::head, &H::ul_sta>, hilscher::packet_status::ok>,
        translate::constant<translate::at<&P::head, &H::ul_ext>, 0>,
        translate::constant<translate::at<&P::head, &H::ul_rout>, 0>,
        translate::caller_set<translate::at<&P::head, &H::ul_src>>,
        translate::caller_set<translate::at<&P::head, &H::ul_src_id>>,
        translate::caller_set<translate::at<&P::head, &H::ul_id>>,
        translate::rest>; // properties 1, subsystem 2, source 4, fields of the message, sequence number 2
};
// clang-format on

/// In the manufacturer-specific area, at 2000h.
using sae_table = sae_table_of<>::type;
/// In the device profile area.
using sae_table_at_6900h = sae_table_of<profile_index_base>::type;

} // namespace jauscat::translation

/// A message's schema has the message ID, which the head has too; behind the message is the sequence number.
template <jauscat::wire::message T>
inline constexpr std::size_t jauscat::translate::largest_body<jauscat::sae::message_head, T> =
    jauscat::wire::layout_of<T>::to_the_end || jauscat::wire::max_size<T> == jauscat::wire::unbounded
        ? jauscat::wire::unbounded
        : jauscat::wire::max_size<T> - sizeof(std::uint16_t) + jauscat::wire::max_size<jauscat::sae::sequence_number>;
