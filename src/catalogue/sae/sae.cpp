#include <jauscat/catalogue/of.hpp>
#include <jauscat/catalogue/sae.hpp>
#include <jauscat/schema/sae_1_0/mobility.hpp>

const jauscat::catalogue::list& jauscat::catalogue::sae_mobility_1_0() {
    static const list all{of<sae_1_0::mobility::messages>(), sae_mobility_1_1()};
    return all;
}

const jauscat::catalogue::list& jauscat::catalogue::sae() {
    static const list all{sae_core_1_1(), sae_mobility_1_1(), sae_environment_sensing_2_0(), sae_manipulator_2_0(),
                          sae_ground_vehicle_1_0()};
    return all;
}
