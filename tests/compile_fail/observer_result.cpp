// expect: hook: the function returns another type than the hook
#include <jauscat/bridge/observer.hpp>

namespace bridge = jauscat::bridge;

constexpr auto settled = [](const bridge::component&) { return true; };
const bridge::observer watcher{.settled = settled};
