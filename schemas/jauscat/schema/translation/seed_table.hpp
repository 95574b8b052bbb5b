// The seed table: JAUS message to ETHERCAT_MASTER_PACKET_SDO_DOWNLOAD_REQ_T, exact at packet level.
// On the EtherCAT wire only station address, index, subindex and data travel: see the self-contained table.
#pragma once
#include <jauscat/schema/ethercat/hilscher.hpp>
#include <jauscat/schema/jaus/header.hpp>
#include <jauscat/schema/translation/command_ranks.hpp>
#include <jauscat/schema/translation/index_bases.hpp>
#include <jauscat/translate/table.hpp>

namespace jauscat::translation {

/// The seed table for any index base (see index_bases.hpp), list of command codes and largest abSdoData.
// clang-format off
template <std::uint32_t IndexBase = seed_index_base, const auto& Codes = ra_command_codes,
          std::size_t MaxData = hilscher::max_sdo_data>
struct seed_table_of {
    using J = jaus::header;
    using A = jaus::address;
    using P = hilscher::sdo_download_request;
    using H = hilscher::packet_header;
    using type = translate::table<J, P, MaxData,
        translate::copy<translate::at<&J::destination, &A::subsystem>, translate::at<&P::head, &H::ul_dest>>,
        translate::copy<translate::at<&J::destination, &A::node>, translate::at<&P::ul_node_id>>,
        translate::offset<translate::at<&J::destination, &A::component>, translate::at<&P::ul_index>, IndexBase>,
        translate::code_rank<translate::at<&J::command_code>, translate::at<&P::ul_sub_index>, Codes>,
        translate::copy<translate::at<&J::destination, &A::instance>, translate::at<&P::head, &H::ul_dest_id>>,
        translate::map_values<translate::at<&J::data_flag>, translate::at<&P::head, &H::ul_ext>,
            translate::value_pair<jaus::data_flag::only, 0x000>,
            translate::value_pair<jaus::data_flag::first, 0x080>,
            translate::value_pair<jaus::data_flag::middle, 0x0C0>,
            translate::value_pair<jaus::data_flag::last, 0x040>,
            translate::value_pair<jaus::data_flag::repeated, 0x2C0>>, // middle, will be retried
        translate::body_size<translate::at<&J::data_size>>,     // stated by ulDataCnt
        translate::data_count<translate::at<&P::ul_data_cnt>>,
        translate::packet_length<translate::at<&P::head, &H::ul_len>, 16>,
        translate::constant<translate::at<&P::head, &H::ul_cmd>, hilscher::packet_command::sdo_download_req>,
        translate::constant<translate::at<&P::head, &H::ul_sta>, hilscher::packet_status::ok>,
        translate::constant<translate::at<&P::head, &H::ul_rout>, 0>,
        translate::caller_set<translate::at<&P::head, &H::ul_src>>,
        translate::caller_set<translate::at<&P::head, &H::ul_src_id>>,
        translate::caller_set<translate::at<&P::head, &H::ul_id>>,
        translate::rest>;                                       // properties 2, source 4, sequence 2, body
};
// clang-format on

/// With the seed's index base, 6900 decimal.
using seed_table = seed_table_of<>::type;
/// For slaves that refuse writes to PDO mapping objects: 2000h is manufacturer specific.
using seed_table_at_2000h = seed_table_of<manufacturer_index_base>::type;
/// With the seed's number read as hexadecimal.
using seed_table_at_6900h = seed_table_of<profile_index_base>::type;

} // namespace jauscat::translation
