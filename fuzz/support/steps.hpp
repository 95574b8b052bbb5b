// Frames out of an input: datagrams whose lengths are right, so that they get further than random bytes would, or
// random bytes.
#pragma once
#include "target.hpp"
#include <jauscat/ethercat/frame_builder.hpp>

namespace fuzz {

/// Marks a step that is a frame as it stands: 16 bits of size, then the bytes.
inline constexpr std::uint8_t raw_frame_step = 0xFF;

/// The frame of the next step; empty where it does not fit a frame. Any other step is a number of datagrams, then for
/// each its header (10 bytes) and data.
inline byte_vector next_frame(input_reader& in) {
    using namespace jauscat;
    const auto kind = in.take();
    if (kind == raw_frame_step) return in.take_bytes(in.take<wire::u16le>() % (ethercat::max_frame_size + 1));
    byte_vector frame(ethercat::max_frame_size);
    ethercat::frame_builder builder{frame};
    for (unsigned left = kind % 16; left != 0; --left) {
        ethercat::datagram_header header{};
        static_cast<void>(wire::decode(header, in.take_bytes(wire::max_size<ethercat::datagram_header>)));
        const auto room = builder.add(header);
        std::ranges::copy(in.take_bytes(room.size()), room.begin());
    }
    const auto finished = builder.finish();
    frame.resize(finished ? finished->size() : 0);
    return frame;
}

/// Most steps of one execution: bounds its time.
inline constexpr int max_steps = 64;

} // namespace fuzz
