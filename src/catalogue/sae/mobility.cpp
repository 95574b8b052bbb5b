#include <jauscat/catalogue/of.hpp>
#include <jauscat/catalogue/sae.hpp>
#include <jauscat/schema/sae/mobility.hpp>

const jauscat::catalogue::list& jauscat::catalogue::sae_mobility_1_1() { return of<sae::mobility::messages>(); }
