// The process data of a Primitive Driver, compiled by itself: it takes as much memory as all else of a bridge.
#pragma once
#include <jauscat/app/impl/bridge_state.hpp>
#include <jauscat/bridge/wrench_effort_part.hpp>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

JAUSCAT_DECL std::unique_ptr<bridging::process_part> make_wrench_effort_part() {
    return std::make_unique<bridging::wrench_effort_part>();
}

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
