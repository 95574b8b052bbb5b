#include <jauscat/catalogue/ra_3_3.hpp>

namespace jauscat::catalogue {

list commands();
list queries();
list informs();

const list& ra_3_3() {
    static const list all{commands(), queries(), informs()};
    return all;
}

} // namespace jauscat::catalogue
