// Golden messages of the set environment_sensing.
#include "jsidl/golden.hpp"
#include <jauscat/schema/sae/environment_sensing.hpp>

TEST_CASE("every golden message of environment_sensing decodes to its values and encodes to its bytes") {
    CHECK(golden_sae::check_all("urn:jaus:jss:environmentSensing:", jauscat::sae::environment_sensing::messages{}) ==
          374);
}
