// An exchange of packets under a translation table that is chosen when a program starts.
#pragma once
#include <jauscat/ethercat/packet_exchange.hpp>

#include <cstddef>
#include <span>

namespace example {

/// See ethercat::packet_exchange.
class any_exchange {
  public:
    /// Bytes of buffer that do for every table.
    static constexpr std::size_t buffer_size = 2048;

    virtual ~any_exchange() = default;
    virtual jauscat::ethercat::exchange_step begin(std::span<const std::byte> message, std::span<std::byte> buffer) = 0;
    virtual jauscat::ethercat::exchange_step on_confirmation(std::span<const std::byte> confirmation,
                                                             std::span<std::byte> buffer) = 0;
    [[nodiscard]] virtual std::size_t acknowledgement(std::span<std::byte> out) const = 0;
    [[nodiscard]] virtual jauscat::hilscher::packet_status status() const = 0;
    [[nodiscard]] virtual jauscat::translate::errc error() const = 0;
};

template <class Table> class exchange_under final : public any_exchange {
  public:
    explicit exchange_under(const jauscat::ethercat::slave_identity& slave) : exchange_{slave} {}

    jauscat::ethercat::exchange_step begin(std::span<const std::byte> message, std::span<std::byte> buffer) override {
        return exchange_.begin(message, buffer);
    }
    jauscat::ethercat::exchange_step on_confirmation(std::span<const std::byte> confirmation,
                                                     std::span<std::byte> buffer) override {
        return exchange_.on_confirmation(confirmation, buffer);
    }
    [[nodiscard]] std::size_t acknowledgement(std::span<std::byte> out) const override {
        return exchange_.acknowledgement(out);
    }
    [[nodiscard]] jauscat::hilscher::packet_status status() const override { return exchange_.status(); }
    [[nodiscard]] jauscat::translate::errc error() const override { return exchange_.error(); }

  private:
    using packet_exchange = jauscat::ethercat::packet_exchange<Table>;
    static_assert(packet_exchange::buffer_size <= buffer_size);
    packet_exchange exchange_;
};

} // namespace example
