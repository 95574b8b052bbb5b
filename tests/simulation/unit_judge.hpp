// What a judge of a component is called with: each before the component gets it, and `has_...` after it.
#pragma once

#include "simulation/messages.hpp"
#include <jauscat/jaus/component/component_outcome.hpp>

namespace simulation {

class unit_judge {
  public:
    unit_judge() = default;
    unit_judge(const unit_judge&) = delete;
    unit_judge& operator=(const unit_judge&) = delete;
    virtual ~unit_judge() = default;

    virtual void gets(const jaus::header& head, bytes body) = 0;
    virtual void has_handled(jaus::component_outcome what) = 0;
    virtual void runs() = 0;
    virtual void has_run() = 0;
    virtual void loses(const jaus::address& who) = 0;
    virtual void has_lost() = 0;
    /// It sends a message.
    virtual void sends(bytes message) = 0;
};

} // namespace simulation
