// expect: apeared
#include <jauscat/net/config/jaus_node_options.hpp>

namespace net = jauscat::net;

const net::jaus_node_options options{.apeared = [](const jauscat::jaus::address&) {}};
