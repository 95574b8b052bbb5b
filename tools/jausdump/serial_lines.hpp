// Finds the frames of SAE JAUS in the bytes of serial lines.
#pragma once
#include "record.hpp"
#include <jauscat/sae/transport/jserial.hpp>

#include <array>
#include <functional>
#include <map>

namespace jausdump {

class serial_lines {
  public:
    explicit serial_lines(std::function<void(const sae::serial_frame&, const origin&)> take) : take_{std::move(take)} {}

    /// Bytes of the line that comes from `from.from`. The origin of a frame is that of its last byte.
    void on_bytes(std::span<const std::byte> bytes, const origin& from) {
        line& one = lines_[from.from];
        one.last = from;
        one.frames.on_bytes(bytes, [&](const sae::serial_frame& frame) { take_(frame, one.last); });
    }
    /// The input has ended: the beginning of another frame shows one that is cut off.
    void finish() {
        for (auto& [name, one] : lines_)
            one.frames.on_bytes(std::array{std::byte{0x10}, std::byte{0x01}},
                                [&held = one, this](const sae::serial_frame& frame) { take_(frame, held.last); });
    }

  private:
    struct line {
        std::vector<std::byte> memory = std::vector<std::byte>(0xFFFF);
        sae::jserial_reader frames{memory};
        origin last{};
    };
    std::function<void(const sae::serial_frame&, const origin&)> take_;
    std::map<std::string, line> lines_{};
};

} // namespace jausdump
