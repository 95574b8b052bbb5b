// expect: std::function<void
#include <jauscat/net/config/jaus_node_options.hpp>

namespace net = jauscat::net;

const net::jaus_node_options options{.appeared = [](const jauscat::jaus::header&) {}};
