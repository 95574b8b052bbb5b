#include "simulation/arm_unit.hpp"

namespace simulation {

void arm_unit::power_on(time now) {
    now_ = told_to_rest_at_ = now;
    told_to_move_at_ = {};
    arm_.emplace([](auto&&...) {}, [this] { tell_efforts(); });
    application_.emplace(subsystem, *arm_);
    process_data_.emplace(*arm_);
    watch_.emplace(*arm_, command_timeout);
    emergency_ = false;
    aborts_ = 0;
    denies_objects_ = !what_.knows_emergencies;
    slave_->power_on();
    moved_(0);
}

void arm_unit::on_time(time now) {
    now_ = now;
    application_->set_station(slave_->station_address());
    if (now >= work_at_ || slow_ == time{}) {
        work_at_ = now + slow_;
        const auto answers_at =
            slow_ == time{} ? 0 : what_.answer_delay; // a slow one takes this time for all of a message
        for (std::uint32_t i = 0; i <= answers_at; ++i) slave_->work();
    }
    slave_->on_time(jauscat::time_point{now});
    watch_->look(*slave_, jauscat::time_point{now}); // first: the inputs say what is in force then
    process_data_->work(*slave_);
}

ethercat::abort_code arm_unit::write(std::uint16_t index, std::uint8_t subindex, bytes data) noexcept {
    if (aborts_ != 0) {
        --aborts_;
        aborted_ = true;
        if (abort_ == ethercat::abort_code::no_object) denies_objects_ = true;
        return abort_;
    }
    std::array<std::byte, delivery::translator::max_message_size> message{};
    const bridging::slave_identity self{.subsystem = subsystem, .station = slave_->station_address()};
    const auto restored = delivery::message_of({self.station, index, subindex, data}, self, message);
    const auto order = restored ? jaus::split(*restored) : jaus::split_message{};
    const auto code = order.header.command_code;
    const bool is_of_emergency =
        code == jaus::command_code_of<jaus::set_emergency> || code == jaus::command_code_of<jaus::clear_emergency>;
    if (is_of_emergency && !what_.knows_emergencies) return ethercat::abort_code::no_subindex;
    const auto result = application_->write(index, subindex, data);
    if (result == ethercat::abort_code::none && restored) note_order(order.header, order.body);
    return result;
}

ethercat::object_read arm_unit::read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
    return application_->read(index, subindex, out);
}

void arm_unit::note_order(const jaus::header& head, bytes body) noexcept {
    const auto code = head.command_code;
    if (code == jaus::command_code_of<jaus::set_emergency>) emergency_ = true;
    if (code == jaus::command_code_of<jaus::clear_emergency>) emergency_ = false;
    const bool is_rest = moves(code) && motion_in(code, body) == command_number{0};
    if (is_rest || code == jaus::command_code_of<jaus::set_emergency>)
        told_to_rest_at_ = now_;
    else if (moves(code))
        told_to_move_at_ = now_;
}

void arm_unit::tell_efforts() {
    std::array<std::byte, 64> report{};
    const auto encoded = wire::encode(arm_->efforts(), report);
    moved_(encoded ? command_in<jaus::report_wrench_effort>(*encoded).value_or(0) : 0);
}

} // namespace simulation
