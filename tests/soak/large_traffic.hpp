// Large data sets from one component to another, whose content tells whether they have arrived as they were sent.
#pragma once

#include <jauscat/net/node/jaus_node.hpp>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace soak {

namespace jaus = jauscat::jaus;
namespace net = jauscat::net;

/// Of the space for user-defined messages.
constexpr std::uint16_t image_code = 0xD111;

/// Data sets of 64 KiB, 256 KiB and 1 MiB in turn, filled by their number.
class large_traffic {
  public:
    struct counters {
        std::atomic<std::uint64_t> sent{}, not_sent{}, acknowledged{}, failed{}; ///< by this end
        std::atomic<std::uint64_t> intact{}, damaged{}, repeated{};              ///< that came to this end
    };

    large_traffic(const jaus::address& self, const jaus::address& to) : self_{self}, to_{to} {}

    void send(net::jaus_node& node) {
        fill(next_, body_);
        const jaus::header head{
            .ack_nak = jaus::ack_nak::request, .command_code = image_code, .destination = to_, .source = self_};
        if (node.send(head, std::span<const std::byte>{body_})) {
            ++next_;
            ++counts.sent;
        } else
            ++counts.not_sent; // too much waits: the next one is the same
    }
    void done(jaus::delivered what) { ++(what == jaus::delivered::acknowledged ? counts.acknowledged : counts.failed); }
    void received(std::span<const std::byte> body) {
        std::uint64_t number{};
        if (body.size() < sizeof number) {
            ++counts.damaged;
            return;
        }
        std::memcpy(&number, body.data(), sizeof number);
        fill(number, expected_);
        if (expected_.size() != body.size() || std::memcmp(expected_.data(), body.data(), body.size()) != 0)
            ++counts.damaged;
        else if (number < expects_)
            ++counts.repeated;
        else {
            expects_ = number + 1;
            ++counts.intact;
        }
    }

    counters counts{};

  private:
    static void fill(std::uint64_t number, std::vector<std::byte>& body) {
        constexpr std::array<std::size_t, 3> sizes{64U << 10U, 256U << 10U, 1U << 20U};
        body.resize(sizes[number % sizes.size()]);
        std::uint64_t word = number;
        for (std::size_t at = 0; at != body.size(); at += sizeof word) {
            std::memcpy(&body[at], &word, sizeof word);
            word = word * 6364136223846793005U + 1442695040888963407U;
        }
    }

    jaus::address self_, to_;
    std::uint64_t next_{}, expects_{};
    std::vector<std::byte> body_ = std::vector<std::byte>(1U << 20U), expected_ = body_;
};

} // namespace soak
