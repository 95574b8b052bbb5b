#include "simulation/direct_user.hpp"

#include <jauscat/ethercat/slave/standard_objects.hpp>

#include <algorithm>

namespace simulation {

using std::chrono::microseconds;
using std::chrono::milliseconds;

direct_user::direct_user(world& w, ring& wire, actor& user, std::uint8_t number, std::uint8_t to_give_up)
    : world_{w}, wire_{wire}, user_{user}, number_{number}, to_give_up_{to_give_up}, random_{w.stream(1006)} {
    for (std::size_t i = 0; i != wire.size(); ++i)
        if (wire[i].arm != nullptr) arms_.push_back(i);
    has_arms_ = !arms_.empty();
    for (std::size_t i = 0; !has_arms_ && i != wire.size(); ++i) arms_.push_back(i);
}

bridging::shared_jobs direct_user::jobs() noexcept {
    if (arms_.empty()) return {};
    return {.begin = jaus::bound<&direct_user::begin>(*this), .done = jaus::bound<&direct_user::done>(*this)};
}

bool direct_user::gives_up(std::uint32_t number) noexcept {
    is_given_up_ = open_ && open_->number == number;
    return is_given_up_;
}

// An upload of one message takes two frames, each of some 0.1 ms.
time direct_user::some_deadline() {
    switch (random_.below(4)) {
    case 0: return random_.between(microseconds{20}, microseconds{500});
    case 1: return random_.between(microseconds{500}, milliseconds{5});
    case 2: return random_.between(milliseconds{5}, milliseconds{50});
    default: return milliseconds{100};
    }
}

// After a transfer that was given up, often one to the same slave follows at once.
bool direct_user::begin(ethercat::master& idle) {
    if (waits_ || world_.now() < next_at_) return false;
    if (random_.below(2) == 0 || count_ == 0) last_slave_ = arms_[random_.below(arms_.size())];
    transfer made{.number = ++count_,
                  .slave = last_slave_,
                  .is_upload = random_.below(3) != 0,
                  .subindex = static_cast<std::uint8_t>(1 + random_.below(direct_object::words.size())),
                  .begun = world_.now(),
                  .value = count_};
    if (!has_arms_) made.is_upload = made.is_identity = true;
    if (!has_arms_) made.subindex = 4;
    const auto station = wire_[made.slave].station;
    const std::uint16_t index = made.is_identity ? ethercat::standard_indices::identity : direct_object::index;
    const auto data = std::span{data_}.first(made.size());
    if (has_arms_) direct_object::fill(data, made.value);
    const auto started =
        made.is_upload
            ? idle.start(ethercat::upload{.station = station, .index = index, .subindex = made.subindex, .into = data})
            : idle.start(
                  ethercat::download{.station = station, .index = index, .subindex = made.subindex, .data = data});
    next_at_ = world_.now() + random_.between(time{}, random_.below(2) == 0 ? milliseconds{2} : milliseconds{100});
    if (!started) return false;
    open_ = made;
    is_given_up_ = false;
    world_.tell({.what = deed::begins_transfer,
                 .who = number_,
                 .whom = wire_[made.slave].number,
                 .number = made.subindex,
                 .value = made.number,
                 .why = made.is_upload ? "reads" : "writes"});
    world_.in(some_deadline(), user_, to_give_up_, made.number);
    return true;
}

void direct_user::done(ethercat::master& idle) {
    if (!open_) return;
    const bool is_answered = idle.error() == ethercat::master_error{};
    world_.tell({.what = deed::ends_transfer,
                 .who = number_,
                 .whom = wire_[open_->slave].number,
                 .value = open_->number,
                 .why = is_answered    ? "is answered"
                        : is_given_up_ ? "is given up"
                                       : "has failed"});
    if (!is_answered) wire_.note_given_up(open_->slave);
    if (is_answered && open_->is_identity)
        check_serial(idle.result<ethercat::upload>().value_or(std::span<std::byte>{}));
    else if (is_answered && open_->is_upload)
        check_upload(idle.result<ethercat::upload>().value_or(std::span<std::byte>{}));
    else if (is_answered)
        check_download();
    open_.reset();
}

void direct_user::check_upload(bytes answer) {
    world_.compares(comparison::direct_upload);
    const auto value = direct_object::value_of(open_->subindex, answer);
    if (!value) return breaks("one whole answer", std::to_string(answer.size()) + " bytes of several, or of another");
    const auto read_at = direct_object::time_of(*value);
    const auto is_of = [&](std::size_t i) {
        return *value == direct_object::answer(ring::serial_of(i), open_->subindex, read_at);
    };
    // Slaves that change places or addresses answer in place of each other.
    const bool is_own = wire_.is_rough() ? std::ranges::any_of(arms_, is_of) : is_of(open_->slave);
    if (!is_own) return breaks("the answer of its slave and entry", "the answer of another");
    if (read_at < open_->begun)
        breaks("what the slave has read for this transfer",
               "what it has read " + std::to_string((open_->begun - read_at) / microseconds{1}) + " us before");
}

void direct_user::check_serial(bytes answer) {
    world_.compares(comparison::direct_upload);
    std::uint32_t serial = 0;
    for (std::size_t i = 0; i != answer.size(); ++i) serial |= std::to_integer<std::uint32_t>(answer[i]) << 8U * i;
    const auto is_of = [&](std::size_t i) { return answer.size() == 4 && serial == ring::serial_of(i); };
    if (wire_.is_rough() ? std::ranges::any_of(arms_, is_of) : is_of(open_->slave)) return;
    breaks("the serial number of its slave", std::to_string(serial));
}

void direct_user::check_download() {
    world_.compares(comparison::direct_download);
    const auto has_it = [&](std::size_t i) { return wire_[i].arm->direct().written() == open_->value; };
    if (wire_.is_rough() ? std::ranges::any_of(arms_, has_it) : has_it(open_->slave)) return;
    breaks("a confirmed value is that of the slave", "the confirmation of another download");
}

void direct_user::breaks(const std::string& expected, std::string found) {
    world_.breaks({.point = contract::s7,
                   .who = number_,
                   .whom = wire_[open_->slave].number,
                   .expected = "transfer " + std::to_string(open_->number) + ": " + expected,
                   .found = std::move(found)});
}

} // namespace simulation
