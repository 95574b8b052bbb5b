// What works while a node runs, besides its components.
#pragma once
#include <jauscat/app/component_status.hpp>
#include <jauscat/jaus/message/hook.hpp>
#include <jauscat/schema/jaus/header.hpp>

#include <memory>
#include <vector>

namespace jauscat::app {

/// Functions and no virtual ones: g++ takes the only class that has them for the one that is called, so that each
/// program with a node would hold the code of bridge and bus (300 KB).
struct node_part {
    std::shared_ptr<void> owner{};                               ///< which the node keeps
    jaus::hook<void()> start{};                                  ///< the node has started
    jaus::hook<void()> stop{};                                   ///< the node will stop: its messages still go out
    jaus::hook<void()> end{};                                    ///< the node ends: it is not referred to any more
    jaus::hook<bool(const jaus::address& component)> has{};      ///< one of its components has this ID
    jaus::hook<void(std::vector<component_status>& all)> list{}; ///< adds its components
};

} // namespace jauscat::app
