// Golden messages of the set mobility.
#include "jsidl/golden.hpp"
#include <jauscat/schema/sae/mobility.hpp>

TEST_CASE("every golden message of mobility decodes to its values and encodes to its bytes") {
    CHECK(golden_sae::check_all("urn:jaus:jss:mobility:", jauscat::sae::mobility::messages{}) == 571);
}
