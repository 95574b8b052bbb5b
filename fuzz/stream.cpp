// JAUS messages found in a stream of bytes: however the bytes arrive, and after any noise.
#include "support/target.hpp"
#include <jauscat/jaus/stream.hpp>

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
    std::vector<bytes> messages{};

    void hear(std::span<const std::byte> part, std::chrono::nanoseconds now) {
        framer_.on_bytes(part, now, [this](std::span<const std::byte> m) { messages.push_back(copy_of(m)); });
    }
    void wait(std::chrono::nanoseconds now) {
        framer_.on_time(now, [this](std::span<const std::byte> m) { messages.push_back(copy_of(m)); });
    }

  private:
    std::array<std::byte, jaus::header_size + max_body> buffer_{};
    jaus::stream_framer framer_{buffer_, idle};
};

void check_messages(const std::vector<bytes>& messages, std::span<const std::byte> stream) {
    for (const auto& message : messages) {
        const auto m = jaus::split(message);
        check(static_cast<bool>(m), "what is handed on is a whole message");
        check(jaus::possible_header(m.header, max_body), "what is handed on has a possible header");
        const auto found = std::search(stream.begin(), stream.end(), message.begin(), message.end());
        check(found != stream.end(), "messages come in the order of the stream, and never overlap");
        stream = stream.subspan(static_cast<std::size_t>(found - stream.begin()) + message.size());
    }
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
    const bytes stream = copy_of(in.rest());

    listener whole, in_parts;
    whole.hear(stream, 0ms);
    std::span<const std::byte> rest{stream};
    for (std::size_t size = first_part; !rest.empty(); size = (size + part_step) % 251 + 1) {
        const auto part = rest.first(std::min(size, rest.size()));
        in_parts.hear(part, 0ms);
        rest = rest.subspan(part.size());
    }
    check(whole.messages == in_parts.messages, "it does not matter how the bytes arrive");
    whole.wait(idle);
    in_parts.wait(idle);
    check(whole.messages == in_parts.messages, "it does not matter how the bytes arrived when the line falls idle");
    check_messages(whole.messages, stream);

    const auto before = whole.messages.size();
    whole.hear(status, idle + 1ms);
    check(whole.messages.size() == before + 1 && std::ranges::equal(whole.messages.back(), status),
          "after any noise and an idle line, the next message is found");
}
