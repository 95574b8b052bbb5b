// Writes an ESI file: a document by EtherCATInfo.xsd, its elements in the schema's order.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/esi/device.hpp>

#include <string>

namespace jauscat::esi {
inline namespace JAUSCAT_WAY {

/// The ESI document of one device, as UTF-8 text.
JAUSCAT_DECL std::string write_esi(const device& what);

} // namespace JAUSCAT_WAY
} // namespace jauscat::esi

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/esi/impl/write_esi.ipp>
#endif
