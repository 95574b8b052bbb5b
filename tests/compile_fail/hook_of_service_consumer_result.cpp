// expect: hook: the function returns another type than the hook
#include <jauscat/jaus/events/service_consumer.hpp>

namespace jaus = jauscat::jaus;

constexpr auto changed = [](const jaus::consumed_connection&) { return true; };
jaus::service_consumer<1> reports{{}, {}, changed};
