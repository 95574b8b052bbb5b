#include <jauscat/catalogue/of.hpp>
#include <jauscat/catalogue/sae.hpp>
#include <jauscat/schema/sae/environment_sensing.hpp>

const jauscat::catalogue::list& jauscat::catalogue::sae_environment_sensing_2_0() {
    return of<sae::environment_sensing::messages>();
}
