// The functions of sae_node.
#pragma once
#include <jauscat/net/detail/endpoint_text.hpp>
#include <jauscat/net/detail/mapped_address.hpp>
#include <jauscat/net/sae/judp_link.hpp>
#include <jauscat/net/sae/sae_node.hpp>

#include <optional>
#include <string>
#include <utility>

namespace jauscat::net {

namespace detail {
inline std::string text(const sae::jaus_id& id) { return std::string{sae::jaus_id_text{id}.view()}; }

inline bool has_ip(const system_entry& system, const boost::asio::ip::address& ip) {
    const auto host = unmapped(ip);
    return unmapped(system.ip) == host ||
           std::ranges::any_of(system.more_ips,
                               [&](const boost::asio::ip::address& one) { return unmapped(one) == host; });
}

inline errc errc_of(sae::transport_errc why) noexcept {
    switch (why) {
    case sae::transport_errc::unknown_peer: return errc::unroutable;
    case sae::transport_errc::no_capacity: return errc::queue_full;
    case sae::transport_errc::too_large: return errc::too_large;
    default: return errc::invalid_message;
    }
}
} // namespace detail

inline namespace JAUSCAT_WAY {

struct sae_node::media {
    std::optional<judp_link> judp{};
    std::optional<shared_judp> shared{};
    std::optional<jtcp_link> jtcp{};
    std::optional<jserial_link> jserial{};

    [[nodiscard]] bool is_judp(sae::endpoint_key key) const {
        const auto number = transport_medium::number_of(key);
        return (judp && number == judp->medium()) || (shared && number == shared->medium());
    }
    [[nodiscard]] bool is_jtcp(sae::endpoint_key key) const {
        return jtcp && transport_medium::number_of(key) == jtcp->medium();
    }
    [[nodiscard]] bool is_jserial(sae::endpoint_key key) const { return jserial && key == jserial->key(); }
    /// The transport's key of an endpoint of JUDP.
    [[nodiscard]] sae::endpoint_key judp_key(const endpoint& to) const {
        return shared ? shared->key_in_transport(to) : judp->key_in_transport(to);
    }
};

inline sae_node::storage::storage(const sae::transport_sizes& sizes)
    : peers(sizes.peers),
      seen(sizes.seen),
      fragments(sizes.fragments),
      fragment_bytes(sizes.fragments * sizes.payload_size),
      message(sizes.message_size),
      queue(sizes.queue),
      queue_bytes(sizes.queue * (1 + sae::transport_overhead + sizes.payload_size)),
      replies(sizes.replies) {}
inline sae::transport_memory sae_node::storage::memory() noexcept {
    return {peers, seen, fragments, fragment_bytes, message, queue, queue_bytes, replies};
}

JAUSCAT_DECL std::vector<sae::local_component> sae_node::components_of(const jaus_config& config,
                                                                       const sae_node_options& options) {
    const auto& me = config.me();
    const auto complaint = [&](std::size_t line, const std::string& why) {
        return detail::complaint(config, config_errc::inconsistent, "sae", line, why);
    };
    if (!me.sae)
        throw complaint(me.line,
                        "this system has no <sae>; a node of SAE JAUS needs one, such as <sae id=\"126.1.10\">");
    const auto& id = me.sae->id;
    if (id.node == 0)
        throw complaint(me.sae->line, "the id " + detail::text(id) +
                                          " of this system names no node; give one, such as " +
                                          std::to_string(id.subsystem) + ".1.0");
    auto numbers = options.components;
    if (numbers.empty()) numbers.push_back(id.component);
    std::vector<sae::local_component> made;
    for (const auto number : numbers) {
        const sae::jaus_id one{number, id.node, id.subsystem};
        if (!sae::names_one_component(one))
            throw complaint(me.sae->line,
                            "the id " + detail::text(id) +
                                " of this system names no component; name it there or in the option components");
        if (!sae::covers(id, one))
            throw complaint(me.sae->line, "the component " + detail::text(one) + " is outside of the id " +
                                              detail::text(id) + " of this system");
        made.push_back({one});
    }
    return made;
}

JAUSCAT_DECL sae::transport_options sae_node::transport_options_of() const {
    const auto& mine = *config_.me().sae;
    auto made = options_.transport;
    made.has_group = (mine.judp && mine.judp->group) || mine.jtcp || mine.jserial;
    made.is_closed = false; // the node decides by the ranges of IDs of the configuration
    return made;
}

JAUSCAT_DECL sae_node::sae_node(boost::asio::io_context& context, jaus_config config, sae_node_options options)
    : context_{context},
      config_{std::move(config)},
      options_{std::move(options)},
      components_{components_of(config_, options_)},
      storage_{options_.memory},
      transport_{components_, storage_.memory(), transport_options_of()},
      driver_{context_, transport_},
      buckets_(config_.systems.size()),
      log_{[this](std::string_view line) {
               if (running() && on_error_) on_error_(line);
           },
           options_.log_limit} {
    driver_.set_filter(
        [this](const sae::transport_header& head, sae::endpoint_key from) { return is_accepted(head, from); });
}

JAUSCAT_DECL sae_node::~sae_node() {
    try {
        stop();
    } catch (...) { // of the log; the media are closed in any case
    }
}

JAUSCAT_DECL void sae_node::start(sae_handlers handlers) {
    stop();
    media_.reset();
    for (const auto& peer : peers().places())
        if (peer.is_used) transport_.forget(peer.endpoint); // its key is that of an earlier medium
    const auto& me = config_.me();
    const auto& mine = *me.sae;
    const bool is_open = options_.accept == access::open;
    auto opened = std::make_unique<media>();
    if (mine.judp) {
        const auto& group = mine.judp->group;
        if (options_.send_datagram)
            opened->shared.emplace(driver_, options_.send_datagram,
                                   group ? std::optional{endpoint{group->group, group->port}} : std::nullopt);
        else // strangers share a limit; a system has its own
            opened->judp.emplace(context_, driver_,
                                 judp_options{.local = me.endpoint(),
                                              .socket = options_.socket,
                                              .group = group,
                                              .limit = is_open ? system_limits{}.messages : rate{}});
    }
    if (mine.jtcp) {
        auto jtcp = options_.jtcp;
        jtcp.listen.reset();
        if (mine.jtcp->listen) jtcp.listen = jtcp_link::endpoint{me.ip, *mine.jtcp->listen};
        jtcp.from = me.ip;
        jtcp.accepted.clear();
        jtcp.limit = is_open ? system_limits{}.messages : rate{};
        for (const auto& system : config_.systems) {
            if (is_open || &system == &me || !system.sae || !system.sae->jtcp) continue;
            jtcp.accepted.push_back(system.ip);
            jtcp.accepted.insert(jtcp.accepted.end(), system.more_ips.begin(), system.more_ips.end());
        }
        if (!is_open && jtcp.accepted.empty()) jtcp.max_connections = 0;
        opened->jtcp.emplace(context_, driver_, jtcp);
    }
    if (mine.jserial) {
        auto jserial = options_.jserial;
        jserial.device = mine.jserial->device;
        jserial.baud = mine.jserial->baud;
        opened->jserial.emplace(context_, driver_, jserial);
    }
    media_ = std::move(opened);
    is_running_ = true;
    on_error_ = handlers.on_error;
    driver_.start(std::move(handlers));
    if (media_->judp) media_->judp->start({});
    if (media_->jserial) media_->jserial->start({});
    if (!media_->jtcp) return;
    media_->jtcp->start({});
    for (const auto& name : mine.jtcp->connect) {
        const auto& to = *config_.find(name);
        media_->jtcp->connect({to.ip, *to.sae->jtcp->listen});
    }
}

JAUSCAT_DECL void sae_node::stop() {
    if (!is_running_) return;
    is_running_ = false;
    driver_.stop();
    if (media_->judp) media_->judp->stop();
    if (media_->jtcp) media_->jtcp->stop();
    if (media_->jserial) media_->jserial->stop();
}

// What is known of a component before it is heard: the address of its system.
JAUSCAT_DECL void sae_node::learn_configured(const sae::jaus_id& destination) {
    if (!sae::names_one_component(destination) || peers().find(destination)) return;
    const auto* const system = config_.system_of(destination);
    if (!system || system == &config_.me()) return;
    const auto& its = *system->sae;
    std::optional<sae::endpoint_key> where;
    if (media_->jtcp && its.jtcp && its.jtcp->listen)
        where = media_->jtcp->connection_to({system->ip, *its.jtcp->listen});
    if (!where && its.judp && (media_->judp || media_->shared)) where = media_->judp_key(system->endpoint());
    if (!where && its.jserial && media_->jserial) where = media_->jserial->key();
    if (where) transport_.learn(destination, *where, now());
}

JAUSCAT_DECL result<std::uint16_t, error> sae_node::send(sae::outgoing_message message, bytes payload) {
    if (!running()) return error{.code = errc::not_running, .reason = {}, .message = "the node is not running"};
    if (message.source == sae::jaus_id{}) message.source = self();
    learn_configured(message.destination);
    const auto number = driver_.send(message, payload);
    if (number) return *number;
    return error{.code = detail::errc_of(number.error()),
                 .reason = reason_of(number.error()),
                 .message = "a message of " + detail::text(message.source) + " to " +
                            detail::text(message.destination) +
                            " is not sent: " + std::string{describe(number.error())}};
}

JAUSCAT_DECL void sae_node::on_datagram(bytes datagram, const endpoint& from) {
    if (running() && media_->shared) media_->shared->on_datagram(datagram, from);
}

JAUSCAT_DECL std::string sae_node::place_of(sae::endpoint_key key) const {
    if (!media_) return "a closed medium";
    if (media_->is_judp(key)) return "UDP " + detail::text(judp_link::endpoint_of(transport_medium::own_key(key)));
    if (media_->is_jserial(key)) return "the serial line " + config_.me().sae->jserial->device;
    const auto peer = media_->is_jtcp(key) ? media_->jtcp->peer_of(key) : std::nullopt;
    return peer ? "TCP " + detail::text(*peer) : "a closed connection";
}

// Whether the system sends from there.
JAUSCAT_DECL bool sae_node::is_of(const system_entry& system, sae::endpoint_key from) const {
    const auto& its = *system.sae;
    if (media_->is_jserial(from)) return its.jserial.has_value();
    if (media_->is_judp(from)) {
        const auto at = judp_link::endpoint_of(transport_medium::own_key(from));
        return its.judp && (system.any_source_port || at.port() == system.port) && detail::has_ip(system, at.address());
    }
    const auto peer = media_->jtcp->peer_of(from);
    return its.jtcp && peer && detail::has_ip(system, peer->address());
}

JAUSCAT_DECL verdict sae_node::check(const sae::jaus_id& source, sae::endpoint_key from) {
    const bool is_open = options_.accept == access::open;
    const auto* const system = config_.system_of(source);
    if (!system) return is_open ? verdict::accepted : verdict::unknown_peer;
    if (!is_of(*system, from)) return is_open ? verdict::accepted : verdict::wrong_sender;
    auto& bucket = buckets_[static_cast<std::size_t>(system - config_.systems.data())];
    return bucket.take(system->limits.messages, now()) ? verdict::accepted : verdict::rate_limited;
}

JAUSCAT_DECL bool sae_node::is_accepted(const sae::transport_header& head, sae::endpoint_key from) {
    if (!running()) return false; // a handler has stopped it
    const bool is_own = std::ranges::find(components_, head.source, &sae::local_component::id) != components_.end();
    const auto what = is_own ? verdict::accepted : check(head.source, from); // the transport counts its own ones
    if (what == verdict::accepted) return true;
    ++(what == verdict::unknown_peer   ? counters_.unknown_peer
       : what == verdict::wrong_sender ? counters_.wrong_sender
                                       : counters_.rate_limited);
    log_(now(), [&] {
        const std::string why = what == verdict::unknown_peer
                                    ? "unknown peer: no <sae> of " + config_.source + " has its source in the id"
                                    : std::string{describe(what)};
        return "a message of " + detail::text(head.source) + " from " + place_of(from) + " is refused: " + why;
    });
    return false;
}

JAUSCAT_DECL sae_node_counters sae_node::counts() const {
    auto all = counters_;
    all.transport = transport_.counts();
    if (media_ && media_->judp) all.judp = media_->judp->counts();
    if (media_ && media_->jtcp) all.jtcp = media_->jtcp->counts();
    if (media_ && media_->jserial) all.jserial = media_->jserial->counts();
    return all;
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::net
