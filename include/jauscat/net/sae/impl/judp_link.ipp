// The functions of judp_link.
#pragma once
#include <jauscat/net/detail/endpoint_text.hpp>
#include <jauscat/net/sae/judp_link.hpp>

#include <algorithm>
#include <random>
#include <string>

namespace jauscat::net {
inline namespace JAUSCAT_WAY {

JAUSCAT_DECL const judp_link::endpoint& judp_link::checked(const endpoint& local) {
    if (!local.address().is_v4())
        throw open_error{{.code = errc::invalid_address,
                          .message = "JUDP cannot use " + detail::text(local) + ": give an address of IPv4"}};
    return local;
}

JAUSCAT_DECL judp_link::judp_link(boost::asio::io_context& context, sae::transport& transport,
                                  const judp_options& options)
    : accepted_{options.accepted},
      limit_{options.limit, std::random_device{}()},
      socket_{context, checked(options.local), options.socket},
      medium_{context, transport, putter()} {
    open(context, options);
}
JAUSCAT_DECL judp_link::judp_link(boost::asio::io_context& context, transport_driver& driver,
                                  const judp_options& options)
    : accepted_{options.accepted},
      limit_{options.limit, std::random_device{}()},
      socket_{context, checked(options.local), options.socket},
      medium_{driver, putter()} {
    open(context, options);
}

JAUSCAT_DECL void judp_link::open(boost::asio::io_context& context, const judp_options& options) {
    if (options.group) {
        group_ = endpoint{options.group->group, options.group->port};
        if (options.local.address().is_unspecified()) {
            socket_.join(*options.group);
        } else {
            auto shared = options.socket;
            shared.reuse_address = true;
            group_socket_.emplace(context, *group_, shared);
            group_socket_->join(*options.group);
        }
        socket_.send_multicast_by(*options.group);
    }
    const auto accept = [this](std::span<const std::byte>, const endpoint& from, jaus::framing) { return check(from); };
    socket_.set_filter(accept);
    if (group_socket_) group_socket_->set_filter(accept);
}

JAUSCAT_DECL void judp_link::start(sae_handlers handlers, ra_handler on_ra_message) {
    medium_.start(std::move(handlers));
    on_ra_message_ = std::move(on_ra_message);
    const auto on_message = [this](std::span<const std::byte> message, const endpoint& from, jaus::framing framing) {
        received(message, from, framing);
    };
    const auto on_error = [this](std::string_view text) { medium_.report(text); };
    socket_.start(on_message, on_error);
    if (group_socket_) group_socket_->start(on_message, on_error);
}

JAUSCAT_DECL void judp_link::stop() {
    medium_.stop();
    socket_.stop();
    if (group_socket_) group_socket_->stop();
}

JAUSCAT_DECL udp_counters judp_link::counts() const noexcept {
    auto all = socket_.counts();
    if (group_socket_)
        for (const auto& counter : udp_counter_list) all.*counter.value += group_socket_->counts().*counter.value;
    return all;
}

JAUSCAT_DECL sae::endpoint_key judp_link::key_of(const endpoint& from) noexcept {
    return {std::uint64_t{from.address().to_v4().to_uint()} << 16 | from.port()};
}

JAUSCAT_DECL judp_link::endpoint judp_link::endpoint_of(sae::endpoint_key key) {
    return {boost::asio::ip::address_v4{static_cast<std::uint32_t>(key.value >> 16)},
            static_cast<std::uint16_t>(key.value & 0xFFFF)};
}

JAUSCAT_DECL verdict judp_link::check(const endpoint& from) {
    const auto ip = from.address().to_v4();
    if (!accepted_.empty() && std::ranges::find(accepted_, ip) == accepted_.end()) return verdict::unknown_peer;
    return limit_.take({0, ip.to_uint()}, now()) ? verdict::accepted : verdict::rate_limited;
}

JAUSCAT_DECL void judp_link::received(std::span<const std::byte> message, const endpoint& from, jaus::framing framing) {
    auto form = jaus::datagram_form::judp1; // the transport did not see what the socket has removed
    if (framing == jaus::framing::jaus01) form = jaus::datagram_form::jaus01;
    if (framing == jaus::framing::bare)
        form = medium_.on_datagram(key_of(from), message);
    else
        medium_.count_foreign(form);
    if (form == jaus::datagram_form::judp2) return;
    if (on_ra_message_ && form != jaus::datagram_form::unknown && form != jaus::datagram_form::judp1_compressed)
        on_ra_message_(message, from, framing);
    else
        name(form, from);
}

JAUSCAT_DECL void judp_link::name(jaus::datagram_form form, const endpoint& from) {
    if (!named_.is_new(from.address(), form)) return;
    medium_.report(
        "a datagram from " + detail::text(from) + " is dropped: it is " + std::string{describe(form)} +
        ", which is not served here: give start a handler of RA messages, such as a node's (docs/sae-transport.md); the"
        " next ones of this host are only counted");
}

JAUSCAT_DECL void judp_link::put(const sae::outgoing_datagram& datagram) {
    if (!datagram.to && !group_) return; // the transport sends nothing to a group that it does not have
    const auto to = datagram.to ? endpoint_of(*datagram.to) : *group_;
    if (const auto sent = socket_.send(datagram.bytes, to); !sent) medium_.report(sent.error().message);
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::net
