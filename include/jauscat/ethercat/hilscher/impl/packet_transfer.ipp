// The functions of packet_transfer.
#pragma once
#include <jauscat/ethercat/hilscher/packet_transfer.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION service_step packet_download::begin(master& m, const packet_io& io) noexcept {
    // ulLen may say more than there are data: a client may send packets of one size.
    const auto data = io.request.subspan(wire::max_size<request>);
    if (asked.ul_data_cnt > data.size() || asked.ul_data_cnt > asked.head.ul_len - least_length)
        return service_step::done(hilscher::packet_status::invalid_packet_length);
    if (const auto wrong = check_target(); wrong != hilscher::packet_status::ok) return service_step::done(wrong);
    return service_step::started(
        m.start(download{station(), index(), subindex(), data.first(asked.ul_data_cnt), io.options.download}));
}

JAUSCAT_FUNCTION service_step packet_upload::begin(master& m, const packet_io& io) noexcept {
    if (const auto wrong = check_target(); wrong != hilscher::packet_status::ok) return service_step::done(wrong);
    return service_step::started(m.start(upload{station(), index(), subindex(), io.room(fields_size)}));
}

JAUSCAT_FUNCTION service_answer packet_upload::answer(confirmation& out, const master& m,
                                                      const packet_io&) const noexcept {
    const auto data = m.result<upload>();
    if (!data) return {.status = hilscher::status_of(data.error())};
    out.ul_node_id = asked.ul_node_id;
    out.ul_index = asked.ul_index;
    out.ul_sub_index = asked.ul_sub_index;
    out.ul_data_cnt = static_cast<std::uint32_t>(data->size());
    return {.size = data->size()};
}

} // namespace jauscat::ethercat
