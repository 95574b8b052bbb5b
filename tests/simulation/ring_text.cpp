#include "simulation/story.hpp"

namespace simulation {

std::string ring_text(const happening& one, const std::vector<std::string>& names) {
    return names[one.who] + ": " + std::to_string(one.number) + ", " + std::to_string(one.value);
}

} // namespace simulation
