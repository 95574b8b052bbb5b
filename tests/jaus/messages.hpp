// Messages for tests of state machines: made whole, and collected from a sink.
#pragma once
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/jaus/message/message_sink.hpp>

#include <vector>

namespace jauscat::test {

using bytes = std::vector<std::byte>;

/// A whole message; command code and data size are filled in.
template <jaus::coded_message T> bytes message(const jaus::header& head, const T& body) {
    bytes out(jaus::header_size + jaus::max_body_size);
    const auto message_bytes = jaus::make_message(head, body, out);
    REQUIRE(message_bytes);
    out.resize(message_bytes->size());
    return out;
}

/// What a state machine has sent, in order.
class sent_messages {
  public:
    [[nodiscard]] auto sink() {
        return [this](std::span<const std::byte> m) { all_.emplace_back(m.begin(), m.end()); };
    }
    [[nodiscard]] bool empty() const { return all_.empty(); }
    [[nodiscard]] std::size_t size() const { return all_.size(); }
    [[nodiscard]] const bytes& operator[](std::size_t i) const { return all_.at(i); }
    void clear() { all_.clear(); }
    /// Takes all out.
    [[nodiscard]] std::vector<bytes> take() { return std::exchange(all_, {}); }

    [[nodiscard]] jaus::header header(std::size_t i) const { return split(i).header; }
    template <jaus::coded_message T> [[nodiscard]] T body(std::size_t i) const {
        const auto m = split(i);
        REQUIRE(m.header.command_code == jaus::command_code_of<T>);
        T body{};
        REQUIRE(wire::decode(body, m.body));
        return body;
    }

  private:
    [[nodiscard]] jaus::split_message split(std::size_t i) const {
        const auto m = jaus::split(all_.at(i));
        REQUIRE(m);
        return m;
    }
    std::vector<bytes> all_{};
};

} // namespace jauscat::test
