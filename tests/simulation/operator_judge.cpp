#include "simulation/operator_judge.hpp"

#include <algorithm>
#include <array>

namespace simulation {
namespace {

template <class T> constexpr std::uint16_t code_of = jaus::command_code_of<T>;

constexpr time to_act = std::chrono::milliseconds{20};
constexpr unsigned most_releases = 8;

std::string text(bytes message) {
    jaus::header head{};
    static_cast<void>(wire::decode_prefix(head, message));
    return "command code " + std::to_string(head.command_code) + ", number " + std::to_string(head.sequence_number);
}
std::string text(jaus::control_state state) {
    constexpr std::array names{"none", "asking", "held", "refused", "lost", "unanswered"};
    return names.at(static_cast<std::size_t>(state));
}

} // namespace

void operator_judge::starts(std::uint16_t first_number) {
    state_ = state::none;
    asked_ = releases_left_ = 0;
    next_number_ = std::max<std::uint16_t>(first_number, 1);
    waiting_.clear();
    is_open_ = is_mute_ = false;
}

// ---------------------------------------------------------------------------------------------------- what it does

void operator_judge::begin() {
    is_open_ = true;
    expected_.clear();
    sent_.clear();
    changes_expected_.clear();
    changes_.clear();
    outcomes_expected_.clear();
    outcomes_.clear();
}

void operator_judge::sends(bytes message) {
    if (!is_open_) return breaks(contract::s6, "no message", text(message));
    sent_.emplace_back(message.begin(), message.end());
}

void operator_judge::changed(jaus::control_state to) {
    if (!is_open_) return breaks(contract::s5, "no change of control", text(to));
    changes_.push_back(to);
}

void operator_judge::delivered(const jaus::header& head, jaus::delivered what) {
    if (!is_open_) return breaks(contract::s1, "no outcome of a message", std::string{describe(what)});
    outcomes_.push_back({head, what});
}

void operator_judge::compare() {
    if (!std::exchange(is_open_, false)) return;
    if (!expected_.empty()) world_.compares(comparison::repeat_ruled);
    if (!changes_expected_.empty()) world_.compares(comparison::request_ruled);
    if (!outcomes_expected_.empty()) world_.compares(comparison::outcome_told);
    if (!std::ranges::is_permutation(sent_, expected_)) { // those of one time may come in any order
        const auto [right, is] = std::ranges::mismatch(expected_, sent_);
        return breaks(contract::s6, right == expected_.end() ? "no further message" : text(*right),
                      is == sent_.end() ? "none" : text(*is) + ", which differs");
    }
    if (changes_ != changes_expected_)
        return breaks(contract::s5,
                      changes_expected_.empty() ? "no change of control"
                                                : "control: " + text(changes_expected_.front()),
                      changes_.empty() ? "no change" : "control: " + text(changes_.front()));
    if (std::ranges::is_permutation(outcomes_, outcomes_expected_)) return;
    const auto say = [](const std::vector<outcome>& all) {
        return all.empty() ? std::string{"no outcome"}
                           : "an outcome of number " + std::to_string(all.front().head.sequence_number) + ": " +
                                 std::string{describe(all.front().what)};
    };
    breaks(contract::s1, say(outcomes_expected_), say(outcomes_));
}

void operator_judge::expect(const jaus::header& head, const auto& body) {
    std::array<std::byte, 128> space{};
    const auto made = jaus::make_message(head, body, space);
    if (made) expected_.emplace_back(made->begin(), made->end());
}

// ---------------------------------------------------------------------------------------------------- control

void operator_judge::enter(state to) {
    const bool was_wanted = is_wanted();
    if (state_ != to) changes_expected_.push_back(to);
    state_ = to;
    if (was_wanted && !is_wanted()) releases_left_ = most_releases;
}

void operator_judge::request() {
    ++asked_;
    at_ = program_.local();
    expect({.destination = what_.target, .source = what_.id}, jaus::request_component_control{authority_});
}

void operator_judge::asks(std::uint8_t authority) {
    begin();
    authority_ = authority;
    asked_ = 0;
    if (state_ != state::held) enter(state::asking);
    request();
}

void operator_judge::releases() {
    begin();
    const bool was_wanted = is_wanted();
    enter(state::none);
    if (was_wanted) expect({.destination = what_.target, .source = what_.id}, jaus::release_component_control{});
}

void operator_judge::gets(const jaus::header& head, bytes body) {
    begin();
    if (jaus::is_acknowledgement(head)) {
        for (std::size_t i = 0; i != waiting_.size(); ++i) {
            const auto& sent = waiting_[i].head;
            if (sent.command_code != head.command_code || sent.sequence_number != head.sequence_number ||
                sent.destination != head.source)
                continue;
            using enum jaus::delivered;
            return end_message(i, head.ack_nak == jaus::ack_nak::ack ? acknowledged : refused);
        }
        return;
    }
    // Commands that only a controller may send are not repeated without control.
    if (head.command_code == code_of<jaus::reject_component_control>)
        for (std::size_t i = waiting_.size(); i-- != 0;)
            if (waiting_[i].head.destination == head.source &&
                waiting_[i].head.command_code != code_of<jaus::set_emergency>)
                end_message(i, jaus::delivered::control_lost);
    if (head.source != what_.target) return;
    const jaus::header to_target{.destination = what_.target, .source = what_.id};
    switch (head.command_code) {
    case code_of<jaus::confirm_component_control>: {
        jaus::confirm_component_control answer{};
        if (!wire::decode(answer, body)) return;
        const bool is_accepted = answer.response_code == jaus::component_control_response::control_accepted;
        if (!is_wanted()) {
            if (is_accepted) expect(to_target, jaus::release_component_control{});
            return;
        }
        asked_ = 0;
        at_ = program_.local();
        return enter(is_accepted ? state::held : state_ == state::held ? state::lost : state::refused);
    }
    case code_of<jaus::reject_component_control>:
        if (state_ == state::held)
            enter(state::lost);
        else if (state_ == state::asking)
            enter(state::refused);
        releases_left_ = 0;
        return;
    case code_of<jaus::query_heartbeat_pulse>:
        if (is_wanted()) return expect(jaus::answer_to(head, what_.id), jaus::report_heartbeat_pulse{});
        if (releases_left_ == 0) return;
        --releases_left_;
        return expect(to_target, jaus::release_component_control{});
    default: return;
    }
}

std::optional<time> operator_judge::control_due() const {
    if (state_ == state::asking || (state_ == state::held && asked_ != 0)) return at_ + what_.control.retry.interval;
    if (state_ == state::held && what_.control.renewal != time{}) return at_ + what_.control.renewal;
    return std::nullopt;
}

void operator_judge::loses(const jaus::address& who) {
    begin();
    const auto same = [](std::uint8_t level, std::uint8_t octet) { return level == 255 || level == octet; };
    const auto& target = what_.target;
    if (is_wanted() && same(who.subsystem, target.subsystem) && same(who.node, target.node) &&
        same(who.component, target.component) && same(who.instance, target.instance))
        enter(state::lost);
}

// ---------------------------------------------------------------------------------------------------- messages

void operator_judge::begins_message() { begin(); }

void operator_judge::has_sent(const jaus::send_result& result, std::uint16_t code) {
    is_open_ = false;
    world_.compares(comparison::repeat_ruled);
    if (!result) {
        const bool is_full = waiting_.size() == what_.places && result.error().code == jaus::send_errc::no_capacity;
        if (!is_full) breaks(contract::s6, "a place for a message that waits", std::string{describe(result.error())});
        if (!sent_.empty()) breaks(contract::s6, "no message without a place", text(sent_.front()));
        return;
    }
    if (sent_.size() != 1) return breaks(contract::s6, "one message", std::to_string(sent_.size()));
    const auto m = jaus::split(sent_.front());
    if (!m) return;
    const auto& head = m.header;
    const auto is_used = [&](std::uint16_t number) {
        return std::ranges::any_of(waiting_, [&](const waiting_message& one) {
            return one.head.sequence_number == number && one.head.command_code == code;
        });
    };
    const auto after = [](std::uint16_t number) {
        return number == 0xFFFF ? std::uint16_t{1} : static_cast<std::uint16_t>(number + 1);
    };
    while (is_used(next_number_)) next_number_ = after(next_number_);
    if (head.sequence_number != next_number_ || *result != next_number_ || head.command_code != code ||
        head.ack_nak != jaus::ack_nak::request || head.destination != what_.target || head.source != what_.id)
        breaks(contract::s1, "command code " + std::to_string(code) + ", number " + std::to_string(next_number_),
               text(sent_.front()));
    next_number_ = after(head.sequence_number);
    const time now = program_.local();
    const auto& retry = what_.acknowledgement.retry;
    waiting_.push_back({head, sent_.front(), 1, now + retry.interval, now + retry.interval * retry.attempts});
}

void operator_judge::end_message(std::size_t i, jaus::delivered what) {
    outcomes_expected_.push_back({waiting_[i].head, what});
    waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(i));
}

void operator_judge::runs() {
    begin();
    const time now = program_.local();
    std::vector<std::size_t> over;
    for (std::size_t i = 0; i != waiting_.size(); ++i) {
        auto& one = waiting_[i];
        if (now < one.due) continue;
        if (one.sent == what_.acknowledgement.retry.attempts || now >= one.until) {
            over.push_back(i);
            continue;
        }
        ++one.sent;
        one.due = now + what_.acknowledgement.retry.interval;
        expected_.push_back(one.whole);
    }
    for (auto i = over.rbegin(); i != over.rend(); ++i) end_message(*i, jaus::delivered::timed_out);
    const auto due = control_due();
    if (!due || now < *due) return;
    if (asked_ >= what_.control.retry.attempts)
        enter(state::unanswered);
    else
        request();
}

// What is due by a time happens at that time, not with the next message.
void operator_judge::check() {
    if (!program_.running() || is_mute_ || world_.now() - std::max(program_.jumped_at(), spoke_at_) <= to_act) return;
    const time late = program_.local() - to_act;
    world_.compares(comparison::repeat_ruled);
    if (const auto due = control_due(); due && *due < late)
        breaks(contract::s6, "a request for control is repeated, renewed or ended in time", "it is " + text(state_));
    for (const auto& one : waiting_)
        if (one.due < late)
            return breaks(contract::s6, "a message without an answer is repeated or given up in time",
                          text(one.whole) + ", sent " + std::to_string(one.sent) + " times");
}

void operator_judge::breaks(contract point, std::string expected, std::string found) {
    world_.breaks(
        {.point = point, .who = program_.number(), .expected = std::move(expected), .found = std::move(found)});
}

} // namespace simulation
