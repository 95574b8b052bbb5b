// For a bridge with a translation table of the application's.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/bridge/any_exchange.hpp>

#include <memory>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

template <class Table> std::unique_ptr<bridging::any_exchange> make_exchange(const bridging::slave_identity& slave) {
    return std::make_unique<bridging::exchange_under<Table>>(slave);
}

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
