// JAUS messages found in a stream of bytes: however the bytes arrive, and after any noise.
#include "support/target.hpp"
#include <jauscat/jaus/message/stream_framer.hpp>

#include <array>

using namespace fuzz;
using namespace jauscat;
using namespace std::chrono_literals;

namespace {

constexpr std::size_t max_body = 64;
constexpr auto idle = 10ms;

// A framer, and what it hands on.
class listener {
  public:
    std::vector<byte_vector> messages{};

    void hear(std::span<const std::byte> part, std::chrono::nanoseconds now) {
        framer_.on_bytes(part, jauscat::time_point{now},
                         [this](std::span<const std::byte> m) { messages.push_back(copy_of(m)); });
    }
    void wait(std::chrono::nanoseconds now) {
        framer_.on_time(jauscat::time_point{now},
                        [this](std::span<const std::byte> m) { messages.push_back(copy_of(m)); });
    }

  private:
    std::array<std::byte, jaus::header_size + max_body> buffer_{};
    jaus::stream_framer framer_{buffer_, idle};
};

/// The messages of a stream that is at hand as a whole; `no_more` will come.
std::vector<byte_vector> messages_in(std::span<const std::byte> stream, bool no_more) {
    std::vector<byte_vector> found;
    while (stream.size() >= jaus::header_size) {
        jaus::header head{};
        static_cast<void>(wire::decode_prefix(head, stream));
        const std::size_t size = jaus::header_size + head.data_size;
        const bool possible = jaus::possible_header(head, max_body);
        if (possible && size > stream.size() && !no_more) break;
        const bool whole = possible && size <= stream.size();
        if (whole) found.push_back(copy_of(stream.first(size)));
        stream = stream.subspan(whole ? size : 1);
    }
    return found;
}

// Query Component Status of 1.1.1.1 to 2.1.33.2.
constexpr std::array status{std::byte{0x06}, std::byte{0x02}, std::byte{0x02}, std::byte{0x20},
                            std::byte{2},    std::byte{0x21}, std::byte{1},    std::byte{2},
                            std::byte{1},    std::byte{1},    std::byte{1},    std::byte{1},
                            std::byte{0},    std::byte{0},    std::byte{0x22}, std::byte{0}};

} // namespace

void fuzz::run(std::span<const std::byte> input) {
    input_reader in{input};
    const std::size_t first_part = std::size_t{in.take()} + 1;
    const std::size_t part_step = in.take();
    const byte_vector stream = copy_of(in.rest());

    listener whole, in_parts;
    whole.hear(stream, 0ms);
    std::span<const std::byte> rest{stream};
    for (std::size_t size = first_part; !rest.empty(); size = (size + part_step) % 251 + 1) {
        const auto part = rest.first(std::min(size, rest.size()));
        in_parts.hear(part, 0ms);
        rest = rest.subspan(part.size());
    }
    check(whole.messages == messages_in(stream, false), "every message that is sure to be one is found");
    check(whole.messages == in_parts.messages, "it does not matter how the bytes arrive");
    whole.wait(idle);
    in_parts.wait(idle);
    check(whole.messages == messages_in(stream, true), "every message is found when the line falls idle");
    check(whole.messages == in_parts.messages, "it does not matter how the bytes arrived when the line falls idle");
    for (const auto& message : whole.messages)
        check(static_cast<bool>(jaus::split(message)), "what is handed on is a whole message");

    const auto before = whole.messages.size();
    whole.hear(status, idle + 1ms);
    check(whole.messages.size() == before + 1 && std::ranges::equal(whole.messages.back(), status),
          "after any noise and an idle line, the next message is found");
}
