// A raw link, and nothing else that takes privileges: "privileges eth0". Without an interface it only gives them up.
// [includes]
#include <jauscat/net/link/drop_privileges.hpp>
#include <jauscat/net/link/raw_link.hpp>

#include <iostream>
// [includes end]

namespace {

int report(const std::string& problem) {
    std::cerr << problem << '\n';
    return 1;
}

int open_and_drop(const std::string& interface) {
    // [drop]
    jauscat::net::raw_link link{interface};
    // set real-time priority and lock memory here, if needed
    if (const auto dropped = jauscat::net::drop_privileges(); !dropped) return report(dropped.error().message);
    // start threads here
    // [drop end]
    return link.problem().empty() ? 0 : report(link.problem());
}

} // namespace

int main(int argc, char** argv) try {
    if (argc > 1) return open_and_drop(argv[1]);
    if (const auto dropped = jauscat::net::drop_privileges(); !dropped) return report(dropped.error().message);
    std::cout << "no privileges\n";
} catch (const jauscat::net::open_error& e) {
    return report(e.what());
}
