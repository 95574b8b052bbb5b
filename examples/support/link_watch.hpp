// What an operator should know of the wire, said once when it comes up: a broken link, a second master, a broken ring,
// emergencies of slaves.
#pragma once
#include "support/any_link.hpp"
#include "support/say.hpp"
#include <jauscat/ethercat/master.hpp>
#include <jauscat/text/hex.hpp>

#include <string>

namespace example {

class link_watch {
  public:
    /// Looks at what a master has seen by now.
    void look(jauscat::ethercat::master& master, const any_link& link, const speaker& say) {
        if (link.problem() != problem_) {
            problem_ = link.problem();
            if (!problem_.empty()) say.bad(problem_);
        }
        const auto& seen = master.statistics();
        if (seen.foreign != 0 && !second_master_)
            say.bad("frames of another master are on this wire; only one may use it");
        if (seen.circulated != 0 && !broken_ring_)
            say.bad("frames come back marked as circulating: a cable between two slaves is out");
        second_master_ = seen.foreign != 0;
        broken_ring_ = seen.circulated != 0;
        for (const auto& slave : master.slaves()) {
            for (const auto& emergency : slave.emergencies.kept())
                say.bad("emergency of slave " + std::to_string(slave.station) + ": error code " +
                        jauscat::text::hex_number(emergency.error_code, 4) + ", error register " +
                        jauscat::text::hex_number(emergency.error_register, 2) + ", data " +
                        jauscat::text::hex(emergency.data));
            master.clear_emergencies(slave.station);
        }
    }

  private:
    std::string problem_{};
    bool second_master_{}, broken_ring_{};
};

} // namespace example
