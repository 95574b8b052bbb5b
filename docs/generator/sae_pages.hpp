// The reference's pages of SAE JAUS: a page for each set, and an index by service, ID and name.
#pragma once
#include "part.hpp"
#include "remarks.hpp"

namespace jauscat::reference {

struct sae_message : message {
    sae_remark remark{};
    unsigned object{}; ///< index of the object of component 0
};
struct sae_set {
    std::string file{};    ///< core
    std::string title{};   ///< Core services, AS5710
    std::string scope{};   ///< jauscat::sae::core
    std::string schemas{}; ///< schema/sae/core
    remarks from;
    std::vector<sae_message> messages{};
};

std::string sae_page(const sae_set& set);
/// README.md.
std::string sae_index_page(const std::vector<sae_set>& sets);

} // namespace jauscat::reference
