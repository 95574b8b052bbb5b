// A broken ESI file.
#include <jauscat/esi/read_esi.hpp>

int main() {
    try {
        static_cast<void>(jauscat::esi::parse_esi("<EtherCATInfo/>", "empty.xml"));
    } catch (const jauscat::esi::esi_error&) {
        return 0;
    }
    return 1;
}
