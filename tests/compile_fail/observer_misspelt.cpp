// expect: slave_lots
#include <jauscat/bridge/observer.hpp>

namespace bridge = jauscat::bridge;

constexpr auto lost = [](const bridge::slave_front&, bridge::loss, const jauscat::ethercat::master_error&) {};
const bridge::observer watcher{.slave_lots = lost};
