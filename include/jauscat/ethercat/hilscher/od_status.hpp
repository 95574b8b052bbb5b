// Text for the status codes with which a Hilscher slave confirms that an object was created.
#pragma once

#include <jauscat/schema/ethercat/hilscher_od.hpp>

#include <string_view>

namespace jauscat::hilscher {

/// Unknown codes have a text too: print the number beside it.
[[nodiscard]] constexpr std::string_view describe(od_status status) noexcept {
    switch (status) {
    case od_status::ok: return "ok";
    case od_status::application_not_registered: return "the application is not registered at the slave";
    case od_status::object_exists: return "the object exists already";
    case od_status::subobject_exists: return "the subobject exists already";
    case od_status::not_owner: return "the object belongs to another application";
    case od_status::too_many_subobjects: return "the object was announced with fewer subobjects";
    case od_status::creation_incomplete: return "the object is not created completely";
    case od_status::wrong_total_data_bytes: return "ulTotalDataBytes and ulLen disagree";
    }
    return "unknown status";
}

} // namespace jauscat::hilscher
