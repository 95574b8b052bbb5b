// SDO download and upload packets.
#pragma once

#include <jauscat/ethercat/hilscher/packet_service.hpp>

namespace jauscat::ethercat {

/// The packet that writes an object.
class packet_download : public packet_coe_service<hilscher::sdo_download_request, hilscher::sdo_download_confirmation> {
  public:
    service_step begin(master& m, const packet_io& io) noexcept {
        // ulLen may say more than there are data: a client may send packets of one size.
        const auto data = io.request.subspan(wire::max_size<request>);
        if (asked.ul_data_cnt > data.size() || asked.ul_data_cnt > asked.head.ul_len - least_length)
            return service_step::done(hilscher::packet_status::invalid_packet_length);
        if (const auto wrong = check_target(); wrong != hilscher::packet_status::ok) return service_step::done(wrong);
        return service_step::started(
            m.start(download{station(), index(), subindex(), data.first(asked.ul_data_cnt), io.options.download}));
    }
    static service_answer answer(confirmation&, const master&, const packet_io&) noexcept { return {}; }
};

/// The packet that reads an object.
class packet_upload : public packet_coe_service<hilscher::sdo_upload_request, hilscher::sdo_upload_confirmation, 12> {
  public:
    service_step begin(master& m, const packet_io& io) noexcept {
        if (const auto wrong = check_target(); wrong != hilscher::packet_status::ok) return service_step::done(wrong);
        return service_step::started(m.start(upload{station(), index(), subindex(), io.room(fields_size)}));
    }
    service_answer answer(confirmation& out, const master& m, const packet_io&) const noexcept {
        const auto data = m.result<upload>();
        if (!data) return {.status = hilscher::status_of(data.error())};
        out.ul_node_id = asked.ul_node_id;
        out.ul_index = asked.ul_index;
        out.ul_sub_index = asked.ul_sub_index;
        out.ul_data_cnt = static_cast<std::uint32_t>(data->size());
        return {.size = data->size()};
    }
};

} // namespace jauscat::ethercat
