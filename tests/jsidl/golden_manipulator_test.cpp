// Golden messages of the set manipulator.
#include "jsidl/golden.hpp"
#include <jauscat/schema/sae/manipulator.hpp>

TEST_CASE("every golden message of manipulator decodes to its values and encodes to its bytes") {
    CHECK(golden_sae::check_all("urn:jaus:jss:manipulator:", jauscat::sae::manipulator::messages{}) == 172);
}
