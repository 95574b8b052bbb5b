// An EtherCAT medium that is chosen when a program starts, so that its user is compiled once for all of them.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace jauscat::net {

/// Models ethercat::link and descriptor_link.
class any_link {
  public:
    virtual ~any_link() = default;
    virtual bool send(std::span<const std::byte> frame) = 0;
    virtual std::size_t receive(std::span<std::byte> buffer, duration timeout) = 0;
    virtual int native_handle() = 0;
    /// Why frames do not pass; empty while they do.
    [[nodiscard]] virtual const std::string& problem() const = 0;
};

/// Holds a link.
template <class Link> class held_link final : public any_link {
  public:
    explicit held_link(Link link) : link_{std::move(link)} {}
    bool send(std::span<const std::byte> frame) override { return link_.send(frame); }
    std::size_t receive(std::span<std::byte> buffer, duration timeout) override {
        return link_.receive(buffer, timeout);
    }
    int native_handle() override { return link_.native_handle(); }
    [[nodiscard]] const std::string& problem() const override { return link_.problem(); }

  private:
    Link link_;
};

inline namespace JAUSCAT_WAY {
/// Opens a master's end: raw Ethernet on the interface `where` ("eth0"), or EtherCAT in UDP with the slaves at
/// "udp:HOST" or "udp:HOST:PORT" (default port 34980; an IPv6 address is in brackets). Throws `open_error`.
JAUSCAT_DECL std::unique_ptr<any_link> open_link(std::string_view where);
/// Opens the end of emulated slaves: the same, but in UDP it receives at that address.
JAUSCAT_DECL std::unique_ptr<any_link> open_slaves_link(std::string_view where);
} // namespace JAUSCAT_WAY

} // namespace jauscat::net

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/net/link/impl/any_link.ipp>
#endif
