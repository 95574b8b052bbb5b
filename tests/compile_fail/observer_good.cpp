// expect: no error
#include <jauscat/bridge/observer.hpp>

namespace bridge = jauscat::bridge;

struct notes {
    void lost(const bridge::slave_front&, bridge::loss, const jauscat::ethercat::master_error&) {}
} book;
constexpr auto settled = [](const bridge::component&) {};
const bridge::observer watcher{.slave_lost = jauscat::jaus::bound<&notes::lost>(book), .settled = settled};
