// Any message of the standard by its name.
#include <jauscat/catalogue/ra_3_3.hpp>

int main() {
    const auto message = jauscat::catalogue::ra_3_3().from_text("set_wrench_effort propulsive_linear_effort_x=50");
    return message && message->encode()->size() == 4 ? 0 : 1;
}
