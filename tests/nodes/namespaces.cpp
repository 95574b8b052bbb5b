#include "nodes/namespaces.hpp"

#include <cstdio>
#include <cstdlib>
#include <unistd.h>

namespace nodes {

namespace {

/// Runs `ip`; what it has written if it fails.
std::string ip(const words& arguments) {
    program one{words{"ip"} + arguments};
    return one.wait() == 0 ? std::string{} : one.output() + "ip failed";
}
void require_ip(const words& arguments) {
    if (const auto problem = ip(arguments); !problem.empty()) FAIL(problem);
}

} // namespace

void skip(const std::string& reason) {
    const char* const ci = std::getenv("CI");
    if (::geteuid() == 0 && ci != nullptr && std::string{ci} == "true") FAIL("skipped as root: " << reason);
    std::printf("SKIPPED: %s\n", reason.c_str());
}

two_namespaces::two_namespaces()
    : master_{"jc-m-" + std::to_string(::getpid())}, slave_{"jc-s-" + std::to_string(::getpid())} {
    if (const auto reason = make(); !reason.empty()) {
        skip(reason);
        return;
    }
    require_ip({"-n", master_, "link", "set", "lo", "up"});
    require_ip({"-n", master_, "link", "set", "if_m", "up"});
    require_ip({"-n", slave_, "link", "set", "if_s", "up"});
    exist_ = true;
}
std::string two_namespaces::make() {
    if (::geteuid() != 0) return "network namespaces need root";
    if (!is_installed("ip")) return "ip (package iproute2) is missing";
    for (const auto& name : {master_, slave_}) {
        if (const auto problem = ip({"netns", "add", name}); !problem.empty())
            return "no network namespace: " + problem;
        made_.push_back(name);
    }
    const words cable{"-n", master_, "link", "add", "if_m", "type", "veth", "peer", "name", "if_s", "netns", slave_};
    const auto problem = ip(cable);
    return problem.empty() ? std::string{} : "no veth pair: " + problem;
}
two_namespaces::~two_namespaces() {
    for (const auto& name : made_) ip({"netns", "del", name});
}

std::string two_namespaces::add_cable(const std::string& interface) {
    auto name = "jc-" + std::to_string(made_.size()) + "-" + std::to_string(::getpid());
    require_ip({"netns", "add", name});
    made_.push_back(name);
    require_ip({"-n", master_, "link", "add", interface, "type", "veth", "peer", "name", "if_s", "netns", name});
    require_ip({"-n", master_, "link", "set", interface, "up"});
    require_ip({"-n", name, "link", "set", "if_s", "up"});
    return name;
}
void two_namespaces::set_slave_link(bool up) const {
    require_ip({"-n", slave_, "link", "set", "if_s", up ? "up" : "down"});
}
void two_namespaces::start_robot(robot& r) const {
    r.link = r.master_link = {"--link", "raw"};
    r.link = r.link + words{"--interface", "if_s"};
    r.master_link = r.master_link + words{"--interface", "if_m"};
    r.prefix = in_slave();
    r.start_arm();
    r.prefix = in_master();
    r.start_controller();
    robot::is_ready(r.controller());
}

} // namespace nodes
