// For a bridge with tables of the application's: a translation table, or the tables of a process image.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/bridge/any_exchange.hpp>
#include <jauscat/bridge/image_part.hpp>

#include <memory>

namespace jauscat {
inline namespace JAUSCAT_WAY {

/// For `bridge::serve`: commands by the image_table `Commands` into the slave's outputs, queries answered by `Reports`
/// from its inputs. `at_rest` is the command that brings the actuator to rest; by default all its fields are zero.
///
///     bridge.serve({.component = 33}, bus.slave({.position = 0}), jauscat::process_image<commands, reports>());
template <class Commands, class Reports> std::unique_ptr<bridging::process_part> process_image() {
    return std::make_unique<bridging::image_part<Commands, Reports>>();
}
template <class Commands, class Reports>
std::unique_ptr<bridging::process_part> process_image(const typename Commands::message_type& at_rest) {
    return std::make_unique<bridging::image_part<Commands, Reports>>(at_rest);
}

namespace app {

template <class Table> std::unique_ptr<bridging::any_exchange> make_exchange(const bridging::slave_identity& slave) {
    return std::make_unique<bridging::exchange_under<Table>>(slave);
}

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
