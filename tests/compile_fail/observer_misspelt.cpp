// expect: slave_lots
#include <jauscat/bridge/observer.hpp>

namespace bridging = jauscat::bridging;

constexpr auto lost = [](const bridging::slave_front&, bridging::loss, const jauscat::ethercat::master_error&) {};
const bridging::observer watcher{.slave_lots = lost};
