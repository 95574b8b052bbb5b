// Packets that read a slave's object dictionary by SDO information. The slave's answers are read into the confirmation,
// to where their variable part has its place.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/hilscher/packet_service.hpp>
#include <jauscat/schema/ethercat/hilscher_info.hpp>

namespace jauscat::ethercat {

/// The packet that lists a slave's objects.
class packet_od_list : public packet_coe_service<hilscher::get_od_list_request, hilscher::get_od_list_confirmation, 8> {
  public:
    JAUSCAT_FUNCTION service_step begin(master& m, const packet_io& io) noexcept;
    JAUSCAT_FUNCTION service_answer answer(confirmation& out, const master& m, const packet_io&) const noexcept;
};

/// The packet that describes one object.
class packet_object : public packet_coe_service<hilscher::get_object_description_request,
                                                hilscher::get_object_description_confirmation, 8> {
  public:
    JAUSCAT_FUNCTION service_step begin(master& m, const packet_io& io) noexcept;
    JAUSCAT_FUNCTION service_answer answer(confirmation& out, const master& m, const packet_io&) const noexcept;

  private:
    // The name comes to lie where the confirmation has it.
    [[nodiscard]] JAUSCAT_FUNCTION static std::span<std::byte> place(const packet_io& io) noexcept;
};

/// The packet that describes one entry of an object.
class packet_entry : public packet_coe_service<hilscher::get_entry_description_request,
                                               hilscher::get_entry_description_confirmation, 12> {
  public:
    JAUSCAT_FUNCTION service_step begin(master& m, const packet_io& io) noexcept;
    JAUSCAT_FUNCTION service_answer answer(confirmation& out, const master& m, const packet_io& io) const noexcept;

  private:
    static constexpr unsigned unit_bit = 0x08;

    // Where there is a unit, the values behind it come to lie where the confirmation has them; else they move by 4
    // bytes.
    [[nodiscard]] JAUSCAT_FUNCTION static std::span<std::byte> place(const packet_io& io) noexcept;
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/hilscher/impl/packet_info.ipp>
#endif
