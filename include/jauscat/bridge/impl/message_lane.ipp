// The functions of message_lane.
#pragma once
#include <jauscat/bridge/message_lane.hpp>

namespace jauscat::bridging {

JAUSCAT_FUNCTION void message_lane::begin(const task& what, std::size_t size, ethercat::master& owner,
                                          const ethercat::packet_options& options) {
    task_ = what;
    options_ = options;
    is_busy_ = true;
    outcome_.reset();
    what.front->set_carried(what.what == purpose::order ? std::optional{what.message} : std::nullopt);
    if (!owner.lend(what.front->station(), master_))
        return end({}, {.code = ethercat::master_errc::wrong_station, .station = what.front->station()});
    if (what.what == purpose::emergencies) {
        static_cast<void>(master_.start(ethercat::collect_emergencies{what.front->station()}));
        return;
    }
    take_step(exchange().begin(std::span{message_}.first(size), packet_));
}

JAUSCAT_FUNCTION bool message_lane::advance() {
    if (!is_busy_) return false;
    if (task_.front->is_withdrawn()) withdraw();
    while (!outcome_ && master_.idle()) {
        if (task_.what == purpose::emergencies)
            end({.what = exchange_progress::done}, master_.error());
        else if (!job_ || !job_->next(master_))
            confirm();
    }
    return outcome_.has_value();
}

JAUSCAT_FUNCTION message_lane::outcome message_lane::take_outcome(ethercat::master& owner) {
    owner.take_back(master_);
    task_.front->set_carried({});
    is_busy_ = false;
    job_.reset();
    return *std::exchange(outcome_, std::nullopt);
}

JAUSCAT_FUNCTION void message_lane::drop(ethercat::master& owner) {
    cancel();
    owner.take_back(master_);
    task_.front->set_carried({});
    is_busy_ = false;
    job_.reset();
    outcome_.reset();
    task_.front = nullptr;
}

JAUSCAT_FUNCTION void message_lane::take_step(const exchange_step& step) {
    if (step.what != exchange_progress::request) return end(step, job_ ? job_->error() : ethercat::master_error{});
    const auto packet = std::span{packet_}.first(step.size);
    tell(packet);
    job_.emplace(packet, confirmation_, options_);
    if (!job_->start(master_)) confirm();
}

JAUSCAT_FUNCTION void message_lane::confirm() {
    const auto size = job_->finish(master_);
    take_step(exchange().on_confirmation(std::span{confirmation_}.first(size), packet_));
}

JAUSCAT_FUNCTION void message_lane::withdraw() {
    if (master_.withdraw(ethercat::master_errc::timeout)) outcome_ = outcome{.was_withdrawn = true};
}

JAUSCAT_FUNCTION void message_lane::end(const exchange_step& step, const ethercat::master_error& error) {
    const bool is_done = step.what == exchange_progress::done;
    outcome_ = outcome{.is_done = is_done, .report = std::span{packet_}.first(is_done ? step.size : 0), .error = error};
}

JAUSCAT_FUNCTION void message_lane::tell(std::span<const std::byte> packet) const {
    if (task_.what == purpose::keep_alive) return;
    const auto& watcher = task_.front->watcher();
    hilscher::packet_header head{};
    static_cast<void>(wire::decode_prefix(head, packet));
    if (head.ul_cmd == hilscher::packet_command::sdo_upload_req)
        watcher.asks_report(*task_.front, packet);
    else
        watcher.translated(*task_.front, packet);
}

} // namespace jauscat::bridging
