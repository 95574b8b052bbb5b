// Memory for the reassembly of a component's large data sets.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/jaus/large_data/reassembler.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace jauscat::net::detail {

/// A reassembler and its memory: `size` bytes of bodies, for `sets` at a time.
class large_data_memory {
  public:
    large_data_memory(std::size_t sets, std::size_t size, duration timeout, const jaus::reassembly_limits& limits)
        : places_(std::max<std::size_t>(sets, 1)),
          packets_(places_.size() * (size / places_.size() / smallest_packet + 1)),
          bytes_(size),
          reassembler_{places_, packets_, bytes_, timeout, limits} {}
    large_data_memory(const large_data_memory&) = delete;
    large_data_memory& operator=(const large_data_memory&) = delete;

    jaus::reassembler& operator*() noexcept { return reassembler_; }
    jaus::reassembler* operator->() noexcept { return &reassembler_; }

  private:
    static constexpr std::size_t smallest_packet = 256; ///< on average, for a data set that fills its place

    std::vector<jaus::partial_data_set> places_;
    std::vector<jaus::held_packet> packets_;
    std::vector<std::byte> bytes_;
    jaus::reassembler reassembler_;
};

} // namespace jauscat::net::detail
