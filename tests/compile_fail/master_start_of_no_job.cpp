// expect: master: only the jobs of ethercat/master/jobs.hpp can be started
#include <jauscat/ethercat/master/master.hpp>

namespace ethercat = jauscat::ethercat;

bool start(ethercat::master& master) { return static_cast<bool>(master.start(ethercat::identity_check{.vendor = 1})); }
