// A broken ESI file.
#include <jauscat/esi/read_esi.hpp>

int main() {
    namespace esi = jauscat::esi;
    return esi::parse_esi("<EtherCATInfo/>", "empty.xml").error().code == esi::errc::missing ? 0 : 1;
}
