// The functions of packet_job.
#pragma once
#include <jauscat/ethercat/hilscher/packet_job.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION packet_job::packet_job(std::span<const std::byte> request, std::span<std::byte> confirmation,
                                        const packet_options& options) noexcept
    : io_{request, confirmation.first(std::min(confirmation.size(), confirmation_size)), options} {}

JAUSCAT_FUNCTION bool packet_job::start(master& m) noexcept {
    if (!wire::decode_prefix(head_, io_.request) || is_answer(head_)) return false;
    status_ = check_header();
    if (status_ != packet_status::ok) return false;
    switch (head_.ul_cmd) {
    case packet_command::sdo_download_req: return begin<packet_download>(m);
    case packet_command::sdo_upload_req: return begin<packet_upload>(m);
    case packet_command::get_od_list_req: return begin<packet_od_list>(m);
    case packet_command::get_object_description_req: return begin<packet_object>(m);
    case packet_command::get_entry_description_req: return begin<packet_entry>(m);
    case packet_command::get_state_req: return begin<packet_get_state>(m);
    case packet_command::set_state_req: return begin<packet_set_state>(m);
    case packet_command::start_bus_scan_req: return begin<packet_start_scan>(m);
    case packet_command::get_bus_scan_info_req: return begin<packet_scan_info>(m);
    case packet_command::get_slave_handles_req: return begin<packet_slave_handles>(m);
    case packet_command::read_emergencies_req: return begin<packet_emergencies>(m);
    default: status_ = packet_status::unknown_command; return false;
    }
}

JAUSCAT_FUNCTION bool packet_job::next(master& m) noexcept {
    if (!runs_) return false;
    if (error_ == master_error{}) error_ = m.error();
    return std::visit([&](auto& service) { return take(next_of(service, m)); }, service_);
}

JAUSCAT_FUNCTION std::size_t packet_job::finish(const master& m) noexcept {
    return finish(m, has_run_ ? m.error() : master_error{});
}

JAUSCAT_FUNCTION std::size_t packet_job::finish(const master& m, const master_error& error) noexcept {
    if (!wire::decode_prefix(head_, io_.request) || is_answer(head_)) return 0;
    head_.ul_cmd = static_cast<packet_command>(static_cast<std::uint32_t>(head_.ul_cmd) + 1);
    if (status_ == packet_status::ok) status_ = hilscher::status_of(error);
    return std::visit([&](auto& service) { return confirm(service, m); }, service_);
}

JAUSCAT_FUNCTION bool packet_job::is_answer(const hilscher::packet_header& head) noexcept {
    return (static_cast<std::uint32_t>(head.ul_cmd) & 1u) != 0;
}

JAUSCAT_FUNCTION packet_job::packet_status packet_job::check_header() const noexcept {
    if (head_.ul_len > io_.request.size() - head_size) return packet_status::invalid_packet_length;
    if (!io_.options.check_header) return packet_status::ok;
    if (head_.ul_dest != channel_in_use && (head_.ul_dest == 0 || head_.ul_dest > last_channel))
        return packet_status::unknown_destination;
    if (head_.ul_dest_id != 0) return packet_status::unknown_destination_id;
    return (head_.ul_ext & sequence_bits) != 0 ? packet_status::invalid_extension : packet_status::ok;
}

JAUSCAT_FUNCTION bool packet_job::take(const service_step& step) noexcept {
    runs_ = step.runs;
    has_run_ = has_run_ || runs_;
    status_ = step.status;
    return runs_;
}

JAUSCAT_FUNCTION std::size_t packet_job::refuse(std::size_t repeated) noexcept {
    if (io_.confirmation.size() < head_size + repeated) return 0;
    head_.ul_sta = status_;
    head_.ul_len = static_cast<std::uint32_t>(repeated);
    static_cast<void>(wire::encode(head_, io_.confirmation));
    const auto body = io_.request.subspan(head_size);
    const auto out = io_.confirmation.subspan(head_size, repeated);
    std::ranges::fill(out, std::byte{});
    std::ranges::copy(body.first(std::min(body.size(), repeated)), out.begin());
    return head_size + repeated;
}

} // namespace jauscat::ethercat
