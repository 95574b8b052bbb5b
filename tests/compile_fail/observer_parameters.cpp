// expect: hook: the function has other parameters than the hook
#include <jauscat/bridge/observer.hpp>

namespace bridging = jauscat::bridging;

constexpr auto lost = [](const bridging::slave_front&, bridging::loss) {};
const bridging::observer watcher{.slave_lost = lost};
