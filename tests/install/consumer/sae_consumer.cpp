// Any message of SAE JAUS by its name.
#include <jauscat/catalogue/sae.hpp>

int main() {
    const auto message = jauscat::catalogue::sae().from_text("request_control authority_code=35");
    return message && message->encode()->size() == 3 ? 0 : 1;
}
