// The self-contained table: like the seed table, but all that is not node, component or command code travels in the
// data, so that a slave can restore the whole message from what crosses the EtherCAT wire.
#pragma once
#include <jauscat/schema/translation/seed_table.hpp>

namespace jauscat::translation {

/// The self-contained table for any index base (see index_bases.hpp), list of command codes and largest abSdoData.
// clang-format off
template <std::uint32_t IndexBase = seed_index_base, const auto& Codes = ra_command_codes,
          std::size_t MaxData = hilscher::max_sdo_data>
struct self_contained_table_of {
    using J = jaus::header;
    using A = jaus::address;
    using P = hilscher::sdo_download_request;
    using H = hilscher::packet_header;
    using type = translate::table<J, P, MaxData,
        translate::copy<translate::at<&J::destination, &A::node>, translate::at<&P::ul_node_id>>,
        translate::offset<translate::at<&J::destination, &A::component>, translate::at<&P::ul_index>, IndexBase>,
        translate::code_rank<translate::at<&J::command_code>, translate::at<&P::ul_sub_index>, Codes>,
        translate::body_size_in_rest<translate::at<&J::data_size>>,
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
        translate::rest>; // properties 2, instance 1, subsystem 1, source 4, data control 2, sequence 2, body
};
// clang-format on

/// With the seed's index base, 6900 decimal.
using self_contained_table = self_contained_table_of<>::type;
/// For slaves that refuse writes to PDO mapping objects: 2000h is manufacturer specific.
using self_contained_table_at_2000h = self_contained_table_of<manufacturer_index_base>::type;
/// With the seed's number read as hexadecimal.
using self_contained_table_at_6900h = self_contained_table_of<profile_index_base>::type;

} // namespace jauscat::translation
