// A message as text.
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/text/print.hpp>

#include <string>

int main() {
    const jauscat::jaus::set_wrench_effort effort{.propulsive_linear_effort_x = 50};
    return jauscat::text::to_text(effort).find("propulsive_linear_effort_x") != std::string::npos ? 0 : 1;
}
