// An EtherCAT medium that is chosen when a program starts, so that the program is compiled once for all of them.
#pragma once
#include <chrono>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

namespace example {

/// Models ethercat::link.
class any_link {
  public:
    virtual ~any_link() = default;
    virtual bool send(std::span<const std::byte> frame) = 0;
    virtual std::size_t receive(std::span<std::byte> buffer, std::chrono::nanoseconds timeout) = 0;
    virtual int native_handle() = 0;
    /// Why frames do not pass; empty while they do.
    [[nodiscard]] virtual const std::string& problem() const = 0;
};

/// Holds a link.
template <class Link> class held_link final : public any_link {
  public:
    explicit held_link(Link link) : link_{std::move(link)} {}
    bool send(std::span<const std::byte> frame) override { return link_.send(frame); }
    std::size_t receive(std::span<std::byte> buffer, std::chrono::nanoseconds timeout) override {
        return link_.receive(buffer, timeout);
    }
    int native_handle() override { return link_.native_handle(); }
    [[nodiscard]] const std::string& problem() const override { return link_.problem(); }

  private:
    Link link_;
};

} // namespace example
