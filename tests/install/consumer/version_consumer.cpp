// Code that checks the version of the library.
#include <jauscat/version.hpp>

// [version]
#if JAUSCAT_VERSION < 100 // major * 10000 + minor * 100 + patch
#    error "needs JausCat 0.1"
#endif
static_assert(JAUSCAT_VERSION_MAJOR == 0, "check what 1.0 has changed");
// [version end]

int main() { return JAUSCAT_VERSION_MINOR >= 1 ? 0 : 1; }
