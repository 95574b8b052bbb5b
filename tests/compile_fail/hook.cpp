#include <jauscat/jaus/component/component_hooks.hpp>

namespace jaus = jauscat::jaus;

#ifdef GOOD
// expect: no error
constexpr auto on_state_function = [](jaus::primary_status_code, jaus::primary_status_code) {};
constexpr auto on_controller_function = [](const std::optional<jaus::controller>&, jaus::control_change) {};
constexpr auto on_delivered_function = [](const jaus::awaited_message&, jaus::delivered) {};
constexpr auto on_state_command_function = [](const jaus::header&) { return jaus::message_outcome::handled; };
const jaus::component_hooks hooks{.on_state = on_state_function,
                                  .on_controller = on_controller_function,
                                  .on_delivered = on_delivered_function,
                                  .on_state_command = on_state_command_function};

struct driver {
    void rest(jaus::primary_status_code, jaus::primary_status_code) {}
    jaus::message_outcome stop(const jaus::header&) const { return jaus::message_outcome::deferred; }
    jaus::component_hooks hooks{.on_state = jaus::bound<&driver::rest>(*this),
                                .on_state_command = jaus::bound<&driver::stop>(*this)};
} one;
const driver other;
#endif

#ifdef MEMBER_PARAMETERS
// expect: hook: the function has other parameters than the hook
struct driver {
    void rest(jaus::primary_status_code) {}
    jaus::component_hooks hooks{.on_state = jaus::bound<&driver::rest>(*this)};
} one;
#endif

#ifdef MEMBER_RESULT
// expect: hook: the function returns another type than the hook
struct driver {
    bool rest(jaus::primary_status_code, jaus::primary_status_code) { return true; }
    jaus::component_hooks hooks{.on_state = jaus::bound<&driver::rest>(*this)};
} one;
#endif

#ifdef ON_STATE_PARAMETERS
// expect: hook: the function has other parameters than the hook
constexpr auto function = [](jaus::primary_status_code) {};
const jaus::component_hooks hooks{.on_state = function};
#endif

#ifdef ON_STATE_RESULT
// expect: hook: the function returns another type than the hook
constexpr auto function = [](jaus::primary_status_code, jaus::primary_status_code) { return true; };
const jaus::component_hooks hooks{.on_state = function};
#endif

#ifdef TEMPORARY
// expect: hook: the function must outlive the component: give it a name
const jaus::component_hooks hooks{.on_state = [](auto, auto) {}};
#endif
