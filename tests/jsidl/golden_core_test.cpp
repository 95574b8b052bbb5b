// Golden messages of the set core.
#include "jsidl/golden.hpp"
#include <jauscat/schema/sae/core.hpp>

TEST_CASE("every golden message of core decodes to its values and encodes to its bytes") {
    CHECK(golden_sae::check_all("urn:jaus:jss:core:", jauscat::sae::core::messages{}) == 182);
}
