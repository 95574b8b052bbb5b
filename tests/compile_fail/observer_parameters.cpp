// expect: hook: the function has other parameters than the hook
#include <jauscat/bridge/observer.hpp>

namespace bridge = jauscat::bridge;

constexpr auto lost = [](const bridge::slave_front&, bridge::loss) {};
const bridge::observer watcher{.slave_lost = lost};
