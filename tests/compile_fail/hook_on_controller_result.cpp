// expect: hook: the function returns another type than the hook
#include <jauscat/jaus/component/component_hooks.hpp>

namespace jaus = jauscat::jaus;

constexpr auto function = [](const std::optional<jaus::controller>&, jaus::control_change) {
    return jaus::message_outcome::handled;
};
const jaus::component_hooks hooks{.on_controller = function};
