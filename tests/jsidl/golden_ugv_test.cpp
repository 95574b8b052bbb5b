// Golden messages of the set ugv.
#include "jsidl/golden.hpp"
#include <jauscat/schema/sae/ugv.hpp>

TEST_CASE("every golden message of ugv decodes to its values and encodes to its bytes") {
    CHECK(golden_sae::check_all("urn:jaus:jss:ugv:", jauscat::sae::ugv::messages{}) == 145);
}
