// What the tests of translation share: both translators, a message with every field, and calls that return bytes.
#pragma once
#include "plain_translator.hpp"
#include "support/hex.hpp"
#include <jauscat/schema/translation/seed_table.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>
#include <jauscat/translate/translator.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace jauscat::test {

using seed = translate::translator<translation::seed_table>;
using self_contained = translate::translator<translation::self_contained_table>;
using packet = hilscher::sdo_download_request;

/// What plain loops call the table.
constexpr plain_table plain_of(seed) { return plain_table::seed; }
constexpr plain_table plain_of(self_contained) { return plain_table::self_contained; }

/// Set Wrench Effort with all twelve elements, to 1.2.33.5 from 4.3.32.2, sequence number 34.
inline constexpr auto wrench_effort = hex_literal<36>("0602 0504"      // priority 6, version 2; code 0405h
                                                      "05 21 02 01"    // destination, instance first
                                                      "02 20 03 04"    // source
                                                      "1400 2200"      // 20 bytes, only packet; sequence number
                                                      "ff0f"           // all twelve
                                                      "ff7f 0180 0000" // 100, -100, 0 %
                                                      "0040 01c0 0020" // 50, -50, 25 %
                                                      "00 ff 80"       // 0, 100, 50 %
                                                      "33 66 99");     // 20, 40, 60 %

/// The same under the seed table.
inline constexpr auto wrench_effort_seed = hex_literal<84>("01000000"           // ulDest: subsystem
                                                           "00000000"           // ulSrc
                                                           "05000000"           // ulDestId: instance
                                                           "00000000"           // ulSrcId
                                                           "2c000000"           // ulLen 44
                                                           "00000000 00000000"  // ulId, ulSta
                                                           "08006500"           // ulCmd
                                                           "00000000 00000000"  // ulExt, ulRout
                                                           "02000000"           // ulNodeId
                                                           "151b0000"           // ulIndex 6933
                                                           "1a000000"           // ulSubIndex 26
                                                           "1c000000"           // ulDataCnt 28
                                                           "0602 02200304 2200" // properties, source, sequence
                                                           "ff0f ff7f 0180 0000 0040 01c0 0020 00ff80 336699");

/// The same under the self-contained table.
inline constexpr auto wrench_effort_self_contained =
    hex_literal<88>("20000000 00000000 00000000 00000000" // ulDest 20h, ulSrc, ulDestId, ulSrcId
                    "30000000 00000000 00000000 08006500" // ulLen 48, ulId, ulSta, ulCmd
                    "00000000 00000000"                   // ulExt, ulRout
                    "02000000 151b0000 1a000000 20000000" // node 2, index 6933, subindex 26, 32 bytes
                    "0602 05 01 02200304 1400 2200"       // all but code, component and node
                    "ff0f ff7f 0180 0000 0040 01c0 0020 00ff80 336699");

/// What became of a translation: the bytes, or the error and no bytes.
struct outcome {
    translate::errc error{};
    std::vector<std::byte> bytes{};
};

inline outcome outcome_of(const jauscat::result<std::span<std::byte>, translate::errc>& result,
                          std::vector<std::byte> out) {
    out.resize(result->size());
    return {result.error(), std::move(out)};
}
/// Message to packet. `Translator` is seed, self_contained or a user's.
template <class Translator>
outcome to_packet(std::span<const std::byte> message, const typename Translator::packet_type& given = {}) {
    std::vector<std::byte> out(Translator::max_packet_size);
    const auto result = Translator::to_packet(message, out, given);
    return outcome_of(result, std::move(out));
}
/// Packet to message.
template <class Translator> outcome from_packet(std::span<const std::byte> bytes) {
    std::vector<std::byte> out(Translator::max_message_size);
    const auto result = Translator::from_packet(bytes, out);
    return outcome_of(result, std::move(out));
}

template <std::size_t Size> std::vector<std::byte> vector_of(const std::array<std::byte, Size>& bytes) {
    return {bytes.begin(), bytes.end()};
}

/// Places of a packet's words.
enum class word : std::size_t {
    ul_dest = 0,
    ul_src = 4,
    ul_dest_id = 8,
    ul_src_id = 12,
    ul_len = 16,
    ul_id = 20,
    ul_sta = 24,
    ul_cmd = 28,
    ul_ext = 32,
    ul_rout = 36,
    ul_node_id = 40,
    ul_index = 44,
    ul_sub_index = 48,
    ul_data_cnt = 52,
};
inline std::uint32_t get(std::span<const std::byte> bytes, word at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- != 0;)
        value = value << 8 | std::to_integer<std::uint32_t>(bytes[static_cast<std::size_t>(at) + i]);
    return value;
}
inline void set(std::span<std::byte> bytes, word at, std::uint32_t value) {
    for (std::size_t i = 0; i != 4; ++i)
        bytes[static_cast<std::size_t>(at) + i] = static_cast<std::byte>(value >> 8 * i);
}
inline std::vector<std::byte> with(std::vector<std::byte> bytes, word at, std::uint32_t value) {
    set(bytes, at, value);
    return bytes;
}

/// A message to 1.2.33.5 whose body is `size` bytes counted up.
inline std::vector<std::byte> message_with_body(std::size_t size) {
    std::vector<std::byte> message(16 + size);
    std::copy_n(wrench_effort.begin(), 16, message.begin());
    message[12] = static_cast<std::byte>(size);
    message[13] = static_cast<std::byte>(size >> 8);
    for (std::size_t i = 0; i != size; ++i) message[16 + i] = static_cast<std::byte>(i);
    return message;
}

} // namespace jauscat::test
