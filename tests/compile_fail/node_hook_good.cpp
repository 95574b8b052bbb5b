// expect: no error
#include <jauscat/net/config/jaus_node_options.hpp>

namespace net = jauscat::net;

const net::jaus_node_options options{.log = [](std::string_view) {}, .appeared = [](const jauscat::jaus::address&) {}};
