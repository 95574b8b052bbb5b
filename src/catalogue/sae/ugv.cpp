#include <jauscat/catalogue/of.hpp>
#include <jauscat/catalogue/sae.hpp>
#include <jauscat/schema/sae/ugv.hpp>

const jauscat::catalogue::list& jauscat::catalogue::sae_ground_vehicle_1_0() { return of<sae::ugv::messages>(); }
