// The functions of clients, and those of control and subscription.
#pragma once
#include <jauscat/app/control.hpp>
#include <jauscat/app/impl/clients.hpp>
#include <jauscat/app/impl/component_state.hpp>
#include <jauscat/app/impl/node_state.hpp>
#include <jauscat/app/impl/search.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/net/now.hpp>
#include <jauscat/text/message_name.hpp>

#include <boost/asio/system_executor.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <random>
#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

JAUSCAT_DECL clients::clients(component_state& component, const jaus::address& self, const retry_policy& retry)
    : component_{component},
      self_{self},
      retry_{retry},
      connections_{self, {.retry = retry}},
      events_{self, retry},
      last_number_{static_cast<std::uint16_t>(std::random_device{}())} {}

inline node_errc error_of(net::errc error) {
    switch (error) {
    case net::errc::not_running: return node_errc::not_running;
    case net::errc::queue_full: return node_errc::queue_full;
    case net::errc::not_encodable:
    case net::errc::invalid_message: return node_errc::not_encodable;
    default: return node_errc::unroutable;
    }
}
inline error_code error_of(jaus::delivered what) {
    switch (what) {
    case jaus::delivered::acknowledged: return {};
    case jaus::delivered::refused: return node_errc::refused;
    case jaus::delivered::control_lost: return node_errc::control_lost;
    case jaus::delivered::timed_out: break;
    }
    return node_errc::no_answer;
}

/// The error code has no destination: that is in the log.
inline node_errc clients::refused(const jaus::header& head, node_errc why) const {
    if (why == node_errc::unroutable)
        component_.node().log(net::to_jausip(self_) + ": " + text::message_name(head.command_code) + " to " +
                              net::to_jausip(head.destination) +
                              " is not sent: no <system> of the configuration has this address in its jausip");
    return why;
}

inline result<std::uint16_t, node_errc> clients::send_acknowledged(const jaus::header& head, bytes body) {
    if (!jaus::names_one_component(head.destination)) return node_errc::not_one_address;
    auto& net = component_.node().net();
    if (!net.running()) return node_errc::not_running;
    if (body.size() > jaus::max_body_size) {
        auto large = head;
        large.ack_nak = jaus::ack_nak::request;
        large.sequence_number = ++last_number_;
        const auto sent = net.send(large, body);
        if (!sent) return refused(head, error_of(sent.error().code));
        return large.sequence_number;
    }
    std::vector<std::byte> message(jaus::header_size + body.size());
    const auto made = jaus::join(head, body, message);
    if (!made) return node_errc::not_encodable;
    if (!component_.is_routable(head.destination)) return refused(head, node_errc::unroutable);
    const auto sent = component_.send_acknowledged(*made);
    if (!sent)
        return sent.error().code == jaus::send_errc::no_capacity ? node_errc::queue_full : node_errc::not_encodable;
    return *sent;
}

JAUSCAT_DECL void clients::send(jaus::header head, bytes body, const operation_ptr<>& done,
                                std::shared_ptr<control_state> by) {
    const auto number = send_acknowledged(head, body);
    if (!number) return done->complete(number.error());
    head.sequence_number = *number;
    sent_.push_back({head, done, body.size() > jaus::max_body_size, std::move(by)});
}

JAUSCAT_DECL void clients::ask(const jaus::address& of, question_codes codes, std::vector<std::byte> body,
                               const ask_options& options, const operation_ptr<bytes>& done) {
    const auto now = net::now();
    const auto head = component_.head_of(codes.query, of);
    question asked{.head = head,
                   .report = codes.report,
                   .done = done,
                   .until = deadline{now, options.timeout},
                   .is_large = body.size() > jaus::max_body_size};
    if (options.acknowledged) {
        const auto number = send_acknowledged(head, body);
        if (!number) return done->complete(number.error(), {});
        asked.head.sequence_number = *number;
    } else {
        if (!jaus::names_one_component(head.destination)) return done->complete(node_errc::not_one_address, {});
        asked.head.sequence_number = ++last_number_;
        const auto sent = component_.node().net().send(asked.head, body);
        if (!sent) return done->complete(refused(head, error_of(sent.error().code)), {});
        asked.message = std::move(body);
        asked.repeated_at = saturating_add(now, retry_.interval);
        asked.made = 1;
    }
    questions_.push_back(std::move(asked));
}

JAUSCAT_DECL void clients::on_delivered(const jaus::header& head, jaus::delivered what, bool is_large) {
    const auto is_it = [&](const auto& one) {
        return one.head.command_code == head.command_code && one.head.destination == head.destination &&
               one.is_large == is_large && one.head.sequence_number == head.sequence_number;
    };
    if (const auto found = std::ranges::find_if(sent_, is_it); found != sent_.end()) {
        found->done->complete(error_of(what));
        sent_.erase(found);
        return;
    }
    // An acknowledged query may be answered later: its timeout ends it.
    const auto asked = std::ranges::find_if(questions_, is_it);
    if (asked == questions_.end() || what == jaus::delivered::acknowledged) return;
    asked->done->complete(error_of(what), {});
    questions_.erase(asked);
}

JAUSCAT_DECL jaus::message_outcome clients::on_message(const jaus::header& head, bytes body, time_point now,
                                                       jaus::message_sink out) {
    for (auto& one : held_)
        if (const auto what = one.machine->on_message(head, body, now, out); what != jaus::message_outcome::unhandled) {
            end_uncontrolled();
            return what;
        }

    const auto connection = connections_.on_message(head, body, now, out);
    if (connection.what == jaus::consumer_notice::report)
        if (const auto to = subscription_at(false, connection.place)) deliver(*to, body);
    if (connection.what != jaus::consumer_notice::unhandled) {
        note_streams();
        return connection.what == jaus::consumer_notice::malformed ? jaus::message_outcome::malformed
                                                                   : jaus::message_outcome::handled;
    }

    const auto event = events_.on_message(head, body, now, out);
    if (event.what == jaus::event_notice::event)
        if (const auto to = subscription_at(true, event.place)) deliver(*to, event.report);
    if (event.what != jaus::event_notice::unhandled) {
        note_streams();
        return event.what == jaus::event_notice::malformed ? jaus::message_outcome::malformed
                                                           : jaus::message_outcome::handled;
    }

    if (head.service_connection) return jaus::message_outcome::unhandled;
    const auto found = question_of(head, body.size() > jaus::max_body_size);
    if (found == questions_.end()) return jaus::message_outcome::unhandled;
    note_ended(*found);
    found->done->complete({}, body);
    questions_.erase(found);
    return jaus::message_outcome::handled;
}

// An answer has the number of its question. There are components that number answers otherwise: theirs belong to the
// first question, until one of them has had the number of a question. The packets of a large one are numbered.
JAUSCAT_DECL std::list<clients::question>::iterator clients::question_of(const jaus::header& head, bool is_large) {
    const auto answers = [&](const question& one) {
        return one.report == head.command_code && one.head.destination == head.source;
    };
    const auto has_number = [&](const jaus::header& one) {
        return one.sequence_number == head.sequence_number && one.destination == head.source;
    };
    const auto first = std::ranges::find_if(questions_, answers);
    if (is_large || first == questions_.end()) return first;
    auto& numbers = numbering_[std::bit_cast<std::uint32_t>(head.source)];
    const auto found =
        std::ranges::find_if(questions_, [&](const question& one) { return answers(one) && has_number(one.head); });
    if (found != questions_.end()) {
        if (head.sequence_number != 0) numbers = {.is_known = true};
        return found;
    }
    const bool is_late = numbers.is_known || (!numbers.is_other && std::ranges::any_of(ended_, has_number));
    if (!is_late) return first;
    if (++numbers.misses < most_misses) return questions_.end();
    numbers = {.is_other = true}; // it may have been replaced by a program that numbers otherwise
    return first;
}
JAUSCAT_DECL void clients::note_ended(const question& one) {
    if (one.head.sequence_number == 0) return;
    if (ended_.size() == most_ended) ended_.pop_front();
    ended_.push_back(one.head);
}

JAUSCAT_DECL bool clients::awaits(const jaus::header& head) const {
    if (head.ack_nak != jaus::ack_nak::none) return false;
    const auto is_provided = [&](const jaus::consumed_connection& one) {
        return one.state != jaus::consumed_state::free && one.provider == head.source &&
               one.request.command_code == head.command_code;
    };
    if (head.service_connection) return std::ranges::any_of(connections_.connections(), is_provided);
    return std::ranges::any_of(questions_, [&](const question& one) {
        return one.report == head.command_code && one.head.destination == head.source;
    });
}

JAUSCAT_DECL void clients::on_time(time_point now, jaus::message_sink out) {
    for (auto& one : held_) one.machine->on_time(now, out);
    end_uncontrolled();
    std::erase_if(held_, [&](const held& one) { return !one.is_wanted() && now - one.over_at >= late; });
    connections_.on_time(now, out);
    events_.on_time(now, out);
    note_streams();
    for (auto& one : questions_) {
        if (one.until.is_reached(now)) {
            note_ended(one);
            one.done->complete(node_errc::no_answer, {});
            component_.forget(one.head);
        }
        if (one.done->is_done() || one.made == 0 || one.repeated_at > now) continue;
        if (!retry_.allows_another(one.made)) {
            one.repeated_at = time_point::max();
            continue;
        }
        ++one.made;
        one.repeated_at = saturating_add(now, retry_.interval);
        static_cast<void>(component_.node().net().send(one.head, one.message)); // its timeout ends it
    }
    for (const auto& one : std::vector{searches_}) one->on_time(now);
    std::erase_if(searches_, [](const auto& one) { return one->done()->is_done(); });
    std::erase_if(questions_, [](const question& one) { return one.done->is_done(); });
}

JAUSCAT_DECL void clients::begin(const std::shared_ptr<search>& made, std::span<const jaus::address> heard) {
    searches_.push_back(made);
    for (const auto& who : heard) made->heard(who);
}
JAUSCAT_DECL void clients::appeared(const jaus::address& who) {
    for (const auto& one : std::vector{searches_})
        if (!one->done()->is_done()) one->heard(who);
}

JAUSCAT_DECL std::optional<time_point> clients::next_event() const {
    std::optional<time_point> first;
    const auto consider = [&](std::optional<time_point> next) {
        if (next && (!first || *next < *first)) first = next;
    };
    for (const auto& one : held_) consider(one.machine->next_event());
    consider(connections_.next_event());
    consider(events_.next_event());
    for (const auto& one : questions_) {
        consider(one.until.at());
        if (one.made != 0) consider(one.repeated_at);
    }
    for (const auto& one : searches_) consider(one->next_event());
    return first;
}

JAUSCAT_DECL void clients::on_lost(const jaus::address& who) {
    for (auto& one : held_) one.machine->on_lost(who);
    end_uncontrolled();
    events_.on_lost(who);
    note_streams();
}

JAUSCAT_DECL void clients::end_all(error_code why, time_point now, jaus::message_sink out) noexcept {
    for (auto& one : std::exchange(sent_, {})) one.done->complete(why);
    for (const auto& one : std::exchange(searches_, {})) one->done()->complete(why, {});
    for (auto& one : std::exchange(questions_, {})) one.done->complete(why, {});
    for (const auto& one : std::exchange(subscriptions_, {})) {
        if (const auto place = std::exchange(one->place, std::nullopt)) // the next start has other places
            one->is_event ? events_.cancel(*place, now, out) : connections_.end(*place, now, out);
        if (one->asked) one->asked->complete(why, nullptr);
        if (one->next) one->next->complete(why, {});
    }
    for (auto& one : held_) {
        one.machine->release(out);
        if (one.state->asked) std::exchange(one.state->asked, nullptr)->complete(why, nullptr);
        for (const auto& lost : std::exchange(one.state->when_lost, {})) lost->complete(why);
    }
    held_.clear();
}

JAUSCAT_DECL void clients::end_cancelled() {
    const auto is_cancelled = [](const auto& operation) { return operation != nullptr && operation->is_done(); };
    const auto forget = [&](const auto& one) {
        if (!is_cancelled(one.done) || one.is_large) return false; // the node sends it to its end, which comes
        component_.forget(one.head);
        return true;
    };
    std::erase_if(sent_, forget);
    std::erase_if(searches_, [&](const auto& one) {
        if (is_cancelled(one->done())) one->end_questions();
        return is_cancelled(one->done());
    });
    for (const auto& one : questions_)
        if (is_cancelled(one.done)) note_ended(one);
    std::erase_if(questions_, forget);
    for (const auto& one : std::vector{subscriptions_})
        if (is_cancelled(one->asked)) end(*one);
    for (const auto& one : held_)
        if (is_cancelled(one.state->asked)) release(*one.state);
}

JAUSCAT_DECL void clients::cancel() {
    std::vector<operation_ptr<>> plain; // first, because what they have begun leaves the lists
    std::vector<operation_ptr<bytes>> with_report;
    for (const auto& one : sent_) plain.push_back(one.done);
    for (const auto& one : questions_) with_report.push_back(one.done);
    for (const auto& one : subscriptions_)
        if (one->next) with_report.push_back(std::exchange(one->next, nullptr));
    for (const auto& one : held_)
        for (auto& lost : std::exchange(one.state->when_lost, {})) plain.push_back(std::move(lost));
    for (const auto& one : std::vector{subscriptions_})
        if (const auto asked = one->asked) asked->cancel();
    std::vector<std::shared_ptr<control_state>> controls;
    for (const auto& one : held_) controls.push_back(one.state);
    for (const auto& one : controls)
        if (const auto asked = one->asked) asked->cancel();
    for (const auto& one : std::vector{searches_}) one->done()->cancel();
    for (const auto& one : plain) one->cancel();
    for (const auto& one : with_report) one->cancel();
}

// Reports as streams.

JAUSCAT_DECL std::shared_ptr<subscription_state> clients::subscription_at(bool is_event, std::size_t place) const {
    const auto found = std::ranges::find_if(
        subscriptions_, [&](const auto& one) { return one->is_event == is_event && one->place == place; });
    return found == subscriptions_.end() ? nullptr : *found;
}

JAUSCAT_DECL void clients::deliver(subscription_state& to, bytes body) {
    if (to.news == make_error_code(node_errc::silent)) to.news = {};
    if (to.next != nullptr && !to.next->is_done()) return std::exchange(to.next, nullptr)->complete({}, body);
    if (to.reports.size() >= to.max_waiting && !to.reports.empty()) {
        to.reports.pop_front();
        ++to.dropped;
    }
    to.reports.emplace_back(body.begin(), body.end());
}
JAUSCAT_DECL void clients::tell(subscription_state& to, node_errc why) {
    if (to.asked) return std::exchange(to.asked, nullptr)->complete(why, nullptr);
    if (to.next != nullptr && !to.next->is_done()) return std::exchange(to.next, nullptr)->complete(why, {});
    to.news = why;
}

JAUSCAT_DECL stream_state clients::state_of(const subscription_state& of) const {
    if (of.is_event) switch (events_.requested()[*of.place].state) {
        case jaus::requested_state::active: return stream_state::active;
        case jaus::requested_state::stale: return stream_state::silent;
        case jaus::requested_state::rejected: return stream_state::refused;
        case jaus::requested_state::unanswered: return stream_state::unanswered;
        case jaus::requested_state::free: return stream_state::over; // it came once
        default: return stream_state::asking;
        }
    switch (connections_.connections()[*of.place].state) {
    case jaus::consumed_state::active: return stream_state::active;
    case jaus::consumed_state::stale: return stream_state::silent;
    case jaus::consumed_state::refused: return stream_state::refused;
    case jaus::consumed_state::unanswered: return stream_state::unanswered;
    default: return stream_state::asking;
    }
}

JAUSCAT_DECL void clients::note_streams() {
    for (auto i = subscriptions_.size(); i-- != 0;) {
        const auto of = subscriptions_[i];
        const auto state = state_of(*of);
        if (!of->is_event && of->place) of->rate = connections_.connections()[*of->place].rate;
        if (std::exchange(of->seen, state) == state || state == stream_state::asking) continue;
        if (state == stream_state::silent) {
            tell(*of, node_errc::silent);
            continue;
        }
        if (state != stream_state::active) {
            of->place.reset();
            std::erase(subscriptions_, of);
        }
        if (state == stream_state::refused) tell(*of, node_errc::connection_refused);
        if (state == stream_state::unanswered) tell(*of, node_errc::no_answer);
        if (of->asked) std::exchange(of->asked, nullptr)->complete({}, of);
    }
}

/// Why a consumer takes no request: all its places are in use, or the message cannot be made.
inline node_errc refusal_of(const auto& places) {
    const auto is_free = [](const auto& one) { return one.state == decltype(one.state)::free; };
    return std::ranges::any_of(places, is_free) ? node_errc::not_encodable : node_errc::queue_full;
}

JAUSCAT_DECL void clients::connect(const jaus::address& to, std::uint16_t code, const connect_options& options,
                                   std::shared_ptr<subscription_state> made) {
    const auto now = net::now();
    if (!jaus::names_one_component(to)) return tell(*made, node_errc::not_one_address);
    if (jaus::sayable_rate(options.rate, jaus::update_rate::max) == 0 || options.rate > jaus::update_rate::max)
        return tell(*made, node_errc::rate_out_of_range);
    for (const auto& one : subscriptions_)
        if (const auto& known = connections_.connections()[one->place.value_or(0)];
            one->place && !one->is_event && known.provider == to && known.request.command_code == code)
            return tell(*made, node_errc::already_asked); // a report's header names no connection
    made->place = connections_.ask(to, code, options.rate, options.presence_vector, now, component_.node().net().out());
    if (!made->place) return tell(*made, refusal_of(connections_.connections()));
    subscriptions_.push_back(std::move(made));
}

JAUSCAT_DECL void clients::request_event(const jaus::address& of, bytes request,
                                         std::shared_ptr<subscription_state> made) {
    jaus::create_event wanted{};
    if (!wire::decode(wanted, request)) return tell(*made, node_errc::not_encodable);
    if (!jaus::names_one_component(of)) return tell(*made, node_errc::not_one_address);
    made->place = events_.create(of, wanted, net::now(), component_.node().net().out());
    if (!made->place) return tell(*made, refusal_of(events_.requested()));
    subscriptions_.push_back(std::move(made));
}

JAUSCAT_DECL void clients::end(subscription_state& ended) {
    const auto now = net::now();
    const auto out = component_.node().net().out();
    if (const auto place = std::exchange(ended.place, std::nullopt))
        ended.is_event ? events_.cancel(*place, now, out) : connections_.end(*place, now, out);
    std::erase_if(subscriptions_, [&](const auto& one) { return one.get() == &ended; });
}

// Control.

JAUSCAT_DECL void clients::held::changed(jaus::control_state now) {
    state->state = now;
    over_at = net::now();
    switch (now) {
    case jaus::control_state::held:
        if (state->asked) std::exchange(state->asked, nullptr)->complete({}, state);
        break;
    case jaus::control_state::refused:
        if (state->asked) std::exchange(state->asked, nullptr)->complete(node_errc::control_refused, nullptr);
        break;
    case jaus::control_state::unanswered:
    case jaus::control_state::lost:
        if (state->asked) std::exchange(state->asked, nullptr)->complete(node_errc::no_answer, nullptr);
        for (const auto& one : std::exchange(state->when_lost, {})) one->complete(node_errc::control_lost);
        break;
    case jaus::control_state::none:
    case jaus::control_state::asking: break;
    }
}

JAUSCAT_DECL void clients::control(const control_options& options, std::shared_ptr<control_state> made) {
    const auto fail = [&](node_errc why) { std::exchange(made->asked, nullptr)->complete(why, nullptr); };
    if (!jaus::names_one_component(made->of)) return fail(node_errc::not_one_address);
    const auto is_same = [&](const held& one) { return one.state->of == made->of; };
    if (std::ranges::any_of(held_, [&](const held& one) { return is_same(one) && one.is_wanted(); }))
        return fail(node_errc::already_asked);
    for (const auto& one : held_)
        if (is_same(one)) forget(one.release); // a repeat of it would end the control that is asked for now
    std::erase_if(held_, is_same);
    auto& one = held_.emplace_back(held{.state = std::move(made)});
    one.machine.emplace(self_, one.state->of,
                        jaus::held_control_options{.retry = options.retry, .renewal = options.renewal},
                        jaus::bound<&held::changed>(one));
    one.machine->ask(options.authority, net::now(), component_.node().net().out());
}

JAUSCAT_DECL void clients::end_uncontrolled() {
    std::erase_if(sent_, [this](const sent_message& one) {
        if (one.by == nullptr || one.by->state == jaus::control_state::held) return false;
        one.done->complete(node_errc::control_lost);
        if (one.is_large) return false; // the node sends it to its end, which comes
        component_.forget(one.head);
        return true;
    });
}

JAUSCAT_DECL void clients::forget(const jaus::header& sent) {
    component_.forget(sent);
    const auto is_it = [&](const sent_message& one) {
        return !one.is_large && one.head.command_code == sent.command_code &&
               one.head.destination == sent.destination && one.head.sequence_number == sent.sequence_number;
    };
    const auto found = std::ranges::find_if(sent_, is_it);
    if (found == sent_.end()) return;
    found->done->complete(boost::asio::error::operation_aborted);
    sent_.erase(found);
}

JAUSCAT_DECL void clients::release(control_state& released, const operation_ptr<>& done) {
    const auto found = std::ranges::find_if(held_, [&](const held& one) { return one.state.get() == &released; });
    if (found == held_.end() || !found->is_wanted()) return;
    // Acknowledged: a lost release would leave the component without its controller until that is noticed.
    found->machine->release([&](bytes message) {
        static_cast<void>(wire::decode_prefix(found->release, message));
        const auto number = component_.send_acknowledged(message);
        found->release.sequence_number = number.value_or(std::uint16_t{});
        if (done == nullptr) return;
        if (!number) return done->complete(node_errc::queue_full);
        sent_.push_back({found->release, done});
    });
    end_uncontrolled();
}

// What the typed functions call, from any thread: the rest happens on the thread of the io_context.

/// `begin(clients&)` starts the operation `done` at a running component.
template <class... Results>
void enqueue(const std::shared_ptr<component_state>& component, const operation_ptr<Results...>& done,
             std::function<void(clients&)> begin) {
    component->context()->post([component, done, begin = std::move(begin)](bool is_over) {
        if (is_over) return done->complete(node_errc::not_running, Results{}...);
        if (component->is_closed()) return done->complete(boost::asio::error::operation_aborted, Results{}...);
        if (!component->is_running()) return done->complete(node_errc::not_running, Results{}...);
        if (done->is_done()) return;
        done->when_cancelled = [weak = std::weak_ptr{component}] {
            const auto still = weak.lock();
            if (still == nullptr || !still->is_running()) return;
            still->others().end_cancelled();
            still->node().wake();
        };
        begin(component->others());
        component->node().wake();
    });
}
/// The same for what has no operation, and nothing to do at a component that does not run.
inline void enqueue_end(const std::weak_ptr<component_state>& component, node_context& context,
                        std::function<void(clients&)> end) noexcept {
    try {
        context.post([component, end = std::move(end)](bool is_over) {
            const auto still = component.lock();
            if (is_over || still == nullptr || !still->is_running()) return;
            end(still->others());
            still->node().wake();
        });
    } catch (...) { // no memory: the peer notices that nobody is there
    }
}

JAUSCAT_DECL void cancel(const std::shared_ptr<component_state>& of) {
    of->context()->post([of](bool is_over) {
        if (!is_over && of->is_running()) of->others().cancel();
    });
}
JAUSCAT_DECL boost::asio::any_io_executor executor_of(const std::shared_ptr<component_state>& of) noexcept {
    return of->context()->executor();
}
JAUSCAT_DECL boost::asio::any_io_executor executor_of(const std::shared_ptr<subscription_state>& of) noexcept {
    if (of == nullptr) return boost::asio::system_executor{};
    return of->context->executor();
}
JAUSCAT_DECL boost::asio::any_io_executor executor_of(const std::shared_ptr<control_state>& of) noexcept {
    if (of == nullptr) return boost::asio::system_executor{};
    return of->context->executor();
}
JAUSCAT_DECL std::uint64_t dropped_of(const subscription_state& of) noexcept { return of.dropped; }
JAUSCAT_DECL double rate_of(const subscription_state& of) noexcept { return of.rate; }

JAUSCAT_DECL void begin_send(const std::shared_ptr<component_state>& from, const jaus::address& to, std::uint16_t code,
                             std::vector<std::byte> body, const operation_ptr<>& done) {
    enqueue(from, done, [head = from->head_of(code, to), body = std::move(body), done](clients& all) {
        all.send(head, body, done);
    });
}
JAUSCAT_DECL void begin_ask(const std::shared_ptr<component_state>& from, const jaus::address& of, question_codes codes,
                            std::vector<std::byte> body, const ask_options& options, const operation_ptr<bytes>& done) {
    if (codes.report == 0) codes.report = jaus::report_code_of(codes.query);
    if (codes.report == 0) return done->complete(node_errc::not_a_query, {});
    enqueue(from, done, [of, codes, body = std::move(body), options, done](clients& all) mutable {
        all.ask(of, codes, std::move(body), options, done);
    });
}

inline std::shared_ptr<subscription_state>
new_subscription(const std::shared_ptr<component_state>& by,
                 const operation_ptr<std::shared_ptr<subscription_state>>& asked) {
    auto made = std::make_shared<subscription_state>(subscription_state{.component = by, .context = by->context()});
    made->asked = asked;
    return made;
}
JAUSCAT_DECL void begin_connect(const std::shared_ptr<component_state>& from, const jaus::address& of,
                                std::uint16_t code, const connect_options& options,
                                const operation_ptr<std::shared_ptr<subscription_state>>& done) {
    enqueue(from, done, [from, of, code, options, done](clients& all) {
        auto made = new_subscription(from, done);
        made->max_waiting = options.max_waiting;
        all.connect(of, code, options, std::move(made));
    });
}
JAUSCAT_DECL void begin_event(const std::shared_ptr<component_state>& from, const jaus::address& of,
                              std::vector<std::byte> request, std::size_t max_waiting,
                              const operation_ptr<std::shared_ptr<subscription_state>>& done) {
    enqueue(from, done, [from, of, request = std::move(request), max_waiting, done](clients& all) {
        auto made = new_subscription(from, done);
        made->is_event = true;
        made->max_waiting = max_waiting;
        all.request_event(of, request, std::move(made));
    });
}
JAUSCAT_DECL void begin_next(const std::shared_ptr<subscription_state>& of, const operation_ptr<bytes>& done) {
    if (of == nullptr) return done->complete(boost::asio::error::operation_aborted, {});
    of->context->post([of, done](bool is_over) {
        if (is_over) return done->complete(boost::asio::error::operation_aborted, {});
        if (!of->reports.empty()) {
            const auto body = std::move(of->reports.front());
            of->reports.pop_front();
            return done->complete({}, body);
        }
        if (const auto news = std::exchange(of->news, {})) return done->complete(news, {});
        const auto component = of->component.lock();
        if (!of->place || component == nullptr || !component->is_running())
            return done->complete(boost::asio::error::operation_aborted, {});
        if (of->next) of->next->complete(boost::asio::error::operation_aborted, {}); // one at a time
        of->next = done;
    });
}
JAUSCAT_DECL void end(const std::shared_ptr<subscription_state>& of) noexcept {
    enqueue_end(of->component, *of->context, [of](clients& all) {
        all.end(*of);
        of->reports.clear();
        of->news = {};
        if (of->next) std::exchange(of->next, nullptr)->complete(boost::asio::error::operation_aborted, {});
    });
}

JAUSCAT_DECL void begin_control(const std::shared_ptr<component_state>& from, const jaus::address& of,
                                const control_options& options,
                                const operation_ptr<std::shared_ptr<control_state>>& done) {
    enqueue(from, done, [from, of, options, done](clients& all) {
        auto made = std::make_shared<control_state>(control_state{.component = from, .context = from->context()});
        made->of = of;
        made->asked = done;
        all.control(options, std::move(made));
    });
}
JAUSCAT_DECL void begin_send(const std::shared_ptr<control_state>& by, std::uint16_t code, std::vector<std::byte> body,
                             const operation_ptr<>& done) {
    if (by == nullptr) return done->complete(node_errc::control_lost);
    const auto from = by->component.lock();
    if (from == nullptr) return done->complete(boost::asio::error::operation_aborted);
    enqueue(from, done, [by, head = from->head_of(code, by->of), body = std::move(body), done](clients& all) {
        if (by->state != jaus::control_state::held) return done->complete(node_errc::control_lost);
        all.send(head, body, done, by);
    });
}
JAUSCAT_DECL void begin_release(const std::shared_ptr<control_state>& of, const operation_ptr<>& done) {
    if (of == nullptr) return done->complete(node_errc::control_lost);
    const auto from = of->component.lock();
    if (from == nullptr) return done->complete(boost::asio::error::operation_aborted);
    enqueue(from, done, [of, done](clients& all) {
        if (of->state != jaus::control_state::held) return done->complete(node_errc::control_lost);
        all.release(*of, done);
        for (const auto& one : std::exchange(of->when_lost, {})) one->complete(boost::asio::error::operation_aborted);
    });
}
JAUSCAT_DECL void begin_lost(const std::shared_ptr<control_state>& of, const operation_ptr<>& done) {
    if (of == nullptr) return done->complete(node_errc::control_lost);
    of->context->post([of, done](bool is_over) {
        if (is_over || of->state != jaus::control_state::held) return done->complete(node_errc::control_lost);
        std::erase_if(of->when_lost, [](const auto& one) { return one->is_done(); });
        of->when_lost.push_back(done);
    });
}
JAUSCAT_DECL void end(const std::shared_ptr<control_state>& of) noexcept {
    enqueue_end(of->component, *of->context, [of](clients& all) {
        all.release(*of);
        for (const auto& one : std::exchange(of->when_lost, {})) one->complete(boost::asio::error::operation_aborted);
    });
}

} // namespace app

JAUSCAT_DECL bool control::is_held() const noexcept {
    return state_ != nullptr && !is_released_ && state_->state == jaus::control_state::held;
}
JAUSCAT_DECL const jaus::address& control::of() const noexcept {
    static constexpr jaus::address nobody{};
    return state_ == nullptr ? nobody : state_->of;
}

} // namespace JAUSCAT_WAY
} // namespace jauscat
