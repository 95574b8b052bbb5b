// expect: no error
#include <jauscat/bridge/observer.hpp>

namespace bridging = jauscat::bridging;

struct notes {
    void lost(const bridging::slave_front&, bridging::loss, const jauscat::ethercat::master_error&) {}
} book;
constexpr auto settled = [](const bridging::component&) {};
const bridging::observer watcher{.slave_lost = jauscat::jaus::bound<&notes::lost>(book), .settled = settled};
