#include "simulation/slave_judge.hpp"

#include <jauscat/schema/ethercat/hilscher.hpp>

#include <algorithm>
#include <utility>

namespace simulation {
namespace {

using ethercat::master_errc, ethercat::master_error;
using std::chrono::milliseconds, std::chrono::seconds;

// A loss is told so long after its cause at most: silence, states that are read seldom, steps that time out.
constexpr time lately = seconds{2};

std::string text_of(const master_error& error) {
    return std::string{ethercat::describe(error)} + " (" + std::to_string(static_cast<unsigned>(error.code)) + ")";
}
bool is_of_transfer(master_errc code) {
    using enum master_errc;
    return code != ok && code != sdo_abort && code != clear_refused && code != mailbox_error && code != data_too_long;
}

bool is_same(const ethercat::coe_emergency& a, const ethercat::coe_emergency& b) {
    return a.error_code == b.error_code && a.error_register == b.error_register && a.data == b.data;
}

} // namespace

void slave_judge::starts() {
    phase_ = {};
    next_try_ = time::min();
    agreement_.reset();
    last_count_.reset();
    returns_from_.reset();
}

// ---------------------------------------------------------------------------------------------------- brought up, lost

void slave_judge::attempt_ends() {
    world_.compares(comparison::attempt_paused);
    if (program_.local() < next_try_)
        breaks(contract::told, "a pause between two attempts to bring a slave up",
               "one that ends " + std::to_string((next_try_ - program_.local()) / milliseconds{1}) + " ms too early");
}

void slave_judge::up(const ethercat::slave_record& record, bool ready, const master_error& kept) {
    world_.compares(comparison::slave_told);
    says(ready == (phase_ == phase::pre_op) || !what_.is_cyclic, "a slave with process data is there, then ready",
         ready ? "ready" : "there");
    says(phase_ != phase::up, "a slave that is told to be there was not", "it was");
    says(record.station == slave().station && record.position == what_.place, "the record of this slave",
         "the record of station " + std::to_string(record.station));
    says(!what_.checks_serial || record.identity.serial == ring::serial_of(what_.place), "the serial number asked for",
         std::to_string(record.identity.serial));
    says(kept == master_error{}, "no error of a slave that was brought up", text_of(kept));
    if (phase_ == phase::absent) attempt_ends();
    if (ready && slave().drive != nullptr && !slave().away && !wire_.is_elsewhere(what_.place)) check_start_up();
    phase_ = ready ? phase::up : phase::pre_op;
    last_count_.reset();
    up_at_ = world_.now();
    returns_from_.reset();
}

// Its axes interpolate for one period: 60C2h, which a drive without supply forgets.
void slave_judge::check_start_up() {
    for (std::size_t i = 0; i != slave().drive->axis_count(); ++i) {
        const auto& values = slave().drive->axis(i).values;
        time is = values.interpolation_time * time{seconds{1}};
        for (int power = values.interpolation_index; power < 0; ++power) is /= 10;
        says(is == what_.period, "a drive that interpolates for one period", std::to_string(is.count()) + " ns");
    }
}

void slave_judge::failed(const master_error& why, const master_error& kept) {
    world_.compares(comparison::slave_told);
    says(phase_ == phase::absent, "an attempt to bring a lost slave up", "it is there");
    says(why.code != master_errc::ok, "why an attempt has failed", "no error");
    says(why == kept, "the error that is told is kept", text_of(kept));
    attempt_ends();
    next_try_ = program_.local() + what_.timing.bring_up_interval;
    returns_from_.reset();
}

void slave_judge::lost(bridging::loss what, const master_error& why, const master_error& kept) {
    world_.compares(comparison::slave_told);
    const char* const wrong = wrong_with_loss(what, why);
    says(wrong == nullptr, wrong == nullptr ? "" : wrong,
         "loss " + std::to_string(static_cast<unsigned>(what)) + ", " + text_of(why) + ", in state " +
             std::to_string(static_cast<unsigned>(why.state)));
    const bool was_up = phase_ == phase::up;
    if (!was_up) says(why == kept, "the error that is told is kept", text_of(kept));
    if (phase_ == phase::absent) attempt_ends();
    next_try_ = was_up ? program_.local() : program_.local() + what_.timing.bring_up_interval;
    returns_from_ = was_up && !what_.has_clock ? std::optional{world_.now()} : std::nullopt;
    phase_ = phase::absent;
    last_count_.reset();
}

bool slave_judge::was_in(const master_error& what) const {
    if (program_.jumped_at() + lately >= world_.now()) return true; // what it was told before
    for (std::size_t i = 0; i != wire_.size(); ++i) {
        if (i != what_.place && !wire_.is_rough()) continue; // no other answers for it
        const auto& each = wire_[i];
        const auto state = static_cast<std::size_t>(what.state);
        const bool is_error = each.error_told_at + lately >= world_.now() && what.state == ethercat::al_state::safe_op;
        const bool is_unknown = each.unknown_told_at + lately >= world_.now() && state == 0;
        if (is_error || is_unknown || (state < each.seen_in.size() && each.seen_in[state] + lately >= world_.now()))
            return true;
    }
    return false;
}

bool slave_judge::was_not_at_its_station() const {
    const auto& each = slave();
    return each.missed_at + lately >= world_.now() || each.restarted_at + lately >= world_.now() ||
           each.disturbed_at + lately >= world_.now() || each.unreachable_since || each.taken_since ||
           wire_.is_elsewhere(what_.place);
}

bool slave_judge::was_doubled() const {
    if (slave().shared_at != time{} && slave().shared_at + lately >= world_.now()) return true;
    for (std::size_t i = 0; i != wire_.size(); ++i)
        if (i != what_.place && wire_[i].unit->slave().station_address() == slave().station) return true;
    return false;
}

const char* slave_judge::wrong_with_loss(bridging::loss what, const master_error& why) const {
    using enum bridging::loss;
    const bool was_up = phase_ == phase::up;
    if (why.code == master_errc::ok) return "why a slave is lost";
    if (phase_ == phase::absent && what_.is_cyclic) return "a slave that was there";
    switch (what) {
    case no_answer:
        if (!was_up) return "a slave without an answer was there";
        return is_of_transfer(why.code) ? nullptr : "an error of frames or transfers";
    case left_state: {
        if (why.code != master_errc::al_error) return "an AL state";
        if (what_.is_cyclic && why.state == ethercat::al_state::op) return "a state in which the slave does not work";
        return was_in(why) ? nullptr : "a state in which the slave was";
    }
    case no_station:
        if (!was_up) return nullptr;
        if (why.code == master_errc::working_counter)
            return was_not_at_its_station() ? nullptr : "a slave that did not answer at its station address";
        if (why.code == master_errc::duplicate_station)
            return was_doubled() || wire_.is_rough() ? nullptr : "several slaves at a station address";
        return "no slave, or several, at the station address";
    case no_process_data:
        if (!was_up) return nullptr;
        if (!what_.is_cyclic) return "a slave with process data";
        return why.code == master_errc::timeout ? nullptr : "a stop order that was not executed in time";
    }
    return "one of the causes";
}

// ---------------------------------------------------------------------------------------------------- messages

// Each carries a number of its own.
void slave_judge::emergency(const ethercat::coe_emergency& what) {
    world_.compares(comparison::emergency_told);
    const auto number = ring::number_of(what);
    bool was_sent = false;
    for (std::size_t i = 0; i != wire_.size(); ++i)
        if (i == what_.place || wire_.is_rough())
            was_sent = was_sent || std::ranges::any_of(wire_[i].emergencies, [&](const sent_emergency& one) {
                           return is_same(one.what, what) && one.at <= world_.now();
                       });
    says(was_sent, "an emergency that its slave has sent", "number " + std::to_string(number));
    says(number > last_emergency_ || !is_quiet_for(seconds{1}), "emergencies in their order, and once",
         "number " + std::to_string(number) + " after " + std::to_string(last_emergency_));
    last_emergency_ = number;
}

void slave_judge::no_keep_alive(const bridging::refusal_reason& why) {
    world_.compares(comparison::refusal_detailed);
    says(!what_.is_cyclic, "a slave by mailbox", "one with process data");
    says(why.why == bridging::refusal::by_slave && why.of_master.code != master_errc::ok,
         "the error with which the slave has refused it", text_of(why.of_master));
}

void slave_judge::agrees(ethercat::clock_agreement how, std::uint32_t difference) {
    world_.compares(comparison::slave_told);
    says(what_.has_clock, "a slave with a clock", "one without");
    says(how != agreement_.value_or(ethercat::clock_agreement::good) || !agreement_,
         "clocks that agree better or worse than before", "the same");
    const ethercat::clock_watch_options limits{};
    says(how != ethercat::clock_agreement::error || difference > limits.error_limit,
         "a difference beyond the limit of errors", std::to_string(difference) + " ns");
    says(how == ethercat::clock_agreement::error || difference <= limits.error_limit,
         "a difference within the limit of errors", std::to_string(difference) + " ns");
    agreement_ = how;
}

void slave_judge::packet(bytes packet, bool asks_report) {
    world_.compares(comparison::slave_told);
    jauscat::hilscher::packet_header head{};
    const bool is_one = static_cast<bool>(wire::decode_prefix(head, packet));
    says(is_one && (head.ul_cmd == jauscat::hilscher::packet_command::sdo_upload_req) == asks_report,
         "an upload for a report, another packet for a command", std::to_string(static_cast<unsigned>(head.ul_cmd)));
    says(phase_ == phase::up, "a packet for a slave that is there", "it is lost");
}

void slave_judge::into_image(std::uint32_t count, bytes outputs, bytes data) {
    world_.compares(comparison::image_told);
    says(what_.is_cyclic, "a slave with process data", "one without");
    says(!last_count_ || static_cast<std::int32_t>(count - *last_count_) > 0, "numbers of commands that grow",
         std::to_string(count) + " after " + std::to_string(last_count_.value_or(0)));
    says(outputs.data() == data.data() && outputs.size() == data.size(), "the outputs of the slave",
         std::to_string(outputs.size()) + " bytes of others");
    last_count_ = count;
}

void slave_judge::from_image(bytes inputs, bytes data) {
    world_.compares(comparison::image_told);
    says(phase_ == phase::up, "a report of a slave that is there", "it is lost");
    says(!inputs.empty() && inputs.data() == data.data() && inputs.size() == data.size(), "the inputs of the slave",
         std::to_string(inputs.size()) + " bytes of others");
}

void slave_judge::check() {
    if (!program_.running() || world_.now() - checked_at_ < milliseconds{10}) return;
    checked_at_ = world_.now();
    // One that was used and has come back is brought up again at once.
    constexpr time to_return = milliseconds{400};
    if (returns_from_ && world_.now() - *returns_from_ > to_return) {
        const bool is_left_alone = is_quiet_for(world_.now() - *returns_from_ + milliseconds{1});
        if (is_left_alone) {
            world_.compares(comparison::attempt_paused);
            breaks(contract::told, "a slave that is lost and there again is brought up at once", "it is not");
        }
        if (world_.now() - *returns_from_ > seconds{2}) returns_from_.reset();
    }
    constexpr time to_tell = milliseconds{500};
    if (phase_ != phase::up || !is_quiet_for(seconds{1}) || up_at_ + seconds{1} > world_.now()) return;
    for (const auto& one : slave().emergencies) {
        const bool is_due = one.at > up_at_ + seconds{1} && is_quiet_for(world_.now() - one.at + seconds{1});
        if (one.number <= last_emergency_ || !is_due || world_.now() - one.at < to_tell) continue;
        breaks(contract::told, "an emergency of a slave to which nothing else happens is told",
               "it is not, after " + std::to_string((world_.now() - one.at) / milliseconds{1}) + " ms");
    }
}

void slave_judge::says(bool is_right, const char* expected, const std::string& found) {
    if (!is_right) breaks(contract::told, expected, found);
}

void slave_judge::breaks(contract point, std::string expected, std::string found) {
    world_.breaks({.point = point,
                   .who = program_.number(),
                   .whom = slave().number,
                   .expected = std::move(expected),
                   .found = std::move(found)});
}

} // namespace simulation
