// expect: hook: the function returns another type than the hook
#include <jauscat/bridge/observer.hpp>

namespace bridging = jauscat::bridging;

constexpr auto settled = [](const bridging::component&) { return true; };
const bridging::observer watcher{.settled = settled};
