// Packet exchange whose translation table is selected at run time.
#pragma once
#include <jauscat/bridge/packet_exchange.hpp>

#include <cstddef>
#include <span>

namespace jauscat::bridging {

/// See packet_exchange. A ring is compiled once for all tables.
class any_exchange {
  public:
    /// Bytes of buffer that do for every table.
    static constexpr std::size_t buffer_size = 2048;

    virtual ~any_exchange() = default;
    virtual exchange_step begin(std::span<const std::byte> message, std::span<std::byte> buffer) = 0;
    virtual exchange_step on_confirmation(std::span<const std::byte> confirmation, std::span<std::byte> buffer) = 0;
    [[nodiscard]] virtual hilscher::packet_status status() const = 0;
    [[nodiscard]] virtual translate::errc error() const = 0;
};

template <class Table> class exchange_under final : public any_exchange {
  public:
    explicit exchange_under(const slave_identity& slave) : exchange_{slave} {}

    exchange_step begin(std::span<const std::byte> message, std::span<std::byte> buffer) override {
        return exchange_.begin(message, buffer);
    }
    exchange_step on_confirmation(std::span<const std::byte> confirmation, std::span<std::byte> buffer) override {
        return exchange_.on_confirmation(confirmation, buffer);
    }
    [[nodiscard]] hilscher::packet_status status() const override { return exchange_.status(); }
    [[nodiscard]] translate::errc error() const override { return exchange_.error(); }

  private:
    using packet_exchange = bridging::packet_exchange<Table>;
    static_assert(packet_exchange::buffer_size <= buffer_size);
    packet_exchange exchange_;
};

} // namespace jauscat::bridging
