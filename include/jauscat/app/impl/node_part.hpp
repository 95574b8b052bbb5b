// What works while a node runs, besides its components.
#pragma once
#include <jauscat/schema/jaus/header.hpp>

#include <functional>

namespace jauscat::app {

/// No virtual functions: g++ takes the only class that has them for the one that is called, so that each program with a
/// node would hold the code of bridge and bus (300 KB).
struct node_part {
    std::function<void()> start;                   ///< the node has started
    std::function<void()> stop;                    ///< the node will stop: its messages still go out; throws nothing
    std::function<bool(const jaus::address&)> has; ///< one of its components has this ID
};

} // namespace jauscat::app
