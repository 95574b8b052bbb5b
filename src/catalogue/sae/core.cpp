#include <jauscat/catalogue/of.hpp>
#include <jauscat/catalogue/sae.hpp>
#include <jauscat/schema/sae/core.hpp>

const jauscat::catalogue::list& jauscat::catalogue::sae_core_1_1() { return of<sae::core::messages>(); }
