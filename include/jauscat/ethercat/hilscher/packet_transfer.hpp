// SDO download and upload packets.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/hilscher/packet_service.hpp>

namespace jauscat::ethercat {

/// The packet that writes an object.
class packet_download : public packet_coe_service<hilscher::sdo_download_request, hilscher::sdo_download_confirmation> {
  public:
    JAUSCAT_FUNCTION service_step begin(master& m, const packet_io& io) noexcept;
    static service_answer answer(confirmation&, const master&, const packet_io&) noexcept { return {}; }
};

/// The packet that reads an object.
class packet_upload : public packet_coe_service<hilscher::sdo_upload_request, hilscher::sdo_upload_confirmation, 12> {
  public:
    JAUSCAT_FUNCTION service_step begin(master& m, const packet_io& io) noexcept;
    JAUSCAT_FUNCTION service_answer answer(confirmation& out, const master& m, const packet_io&) const noexcept;
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/hilscher/impl/packet_transfer.ipp>
#endif
