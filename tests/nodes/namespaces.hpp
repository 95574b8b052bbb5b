// Two network namespaces joined by a cable: the master's has if_m, the slave's if_s. Needs root.
#pragma once
#include "nodes/robot.hpp"

#include <string>
#include <vector>

namespace nodes {

class two_namespaces {
  public:
    two_namespaces();
    two_namespaces(const two_namespaces&) = delete;
    two_namespaces& operator=(const two_namespaces&) = delete;
    ~two_namespaces();

    /// False: skipped, with the reason printed. As root with CI=true the test fails instead.
    [[nodiscard]] bool exist() const { return exist_; }
    /// In front of a command.
    static words in(const std::string& name) { return {"ip", "netns", "exec", name}; }
    [[nodiscard]] words in_master() const { return in(master_); }
    [[nodiscard]] words in_slave() const { return in(slave_); }
    /// A cable from `interface` of the master to if_s in a namespace of its own, whose name it returns.
    std::string add_cable(const std::string& interface);
    void set_slave_link(bool up) const;
    /// Arm and controller, by raw Ethernet.
    void start_robot(robot& r) const;

  private:
    std::string make(); ///< the reason if it cannot

    std::string master_, slave_;
    std::vector<std::string> made_{};
    bool exist_{};
};

/// Prints why a test is skipped; as root with CI=true it fails: root can do all of it on a machine that permits
/// namespaces, and a skip would hide a fault.
void skip(const std::string& reason);

} // namespace nodes
