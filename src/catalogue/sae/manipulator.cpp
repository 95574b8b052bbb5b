#include <jauscat/catalogue/of.hpp>
#include <jauscat/catalogue/sae.hpp>
#include <jauscat/schema/sae/manipulator.hpp>

const jauscat::catalogue::list& jauscat::catalogue::sae_manipulator_2_0() { return of<sae::manipulator::messages>(); }
