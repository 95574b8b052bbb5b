// Sockets and configuration files, all of it: what stands above the I/O line.
#pragma once

#include <jauscat/net/access_list.hpp>
#include <jauscat/net/cycle_timer.hpp>
#include <jauscat/net/datagram_gate.hpp>
#include <jauscat/net/drop_privileges.hpp>
#include <jauscat/net/jaus_config.hpp>
#include <jauscat/net/jaus_node.hpp>
#include <jauscat/net/jaus_node_options.hpp>
#include <jauscat/net/jausip.hpp>
#include <jauscat/net/latency_histogram.hpp>
#include <jauscat/net/limited_log.hpp>
#include <jauscat/net/multicast.hpp>
#include <jauscat/net/next_hop.hpp>
#include <jauscat/net/open_error.hpp>
#include <jauscat/net/outcome.hpp>
#include <jauscat/net/rate_limit.hpp>
#include <jauscat/net/raw_link.hpp>
#include <jauscat/net/read_jaus_config.hpp>
#include <jauscat/net/run_cycle.hpp>
#include <jauscat/net/run_master.hpp>
#include <jauscat/net/run_until.hpp>
#include <jauscat/net/udp_counters.hpp>
#include <jauscat/net/udp_link.hpp>
#include <jauscat/net/udp_options.hpp>
#include <jauscat/net/udp_transport.hpp>
#include <jauscat/net/verdict.hpp>
