// The part of the library that is no template, for the one source of a program that compiles it: see
// base/compilation.hpp. The CMake target jauscat::compiled compiles the same in several sources, each with less memory.
#pragma once
#ifndef JAUSCAT_SEPARATE_COMPILATION
#    error "define JAUSCAT_SEPARATE_COMPILATION for all sources of the program, or do not include <jauscat/src.hpp>"
#endif
#include <jauscat/app/impl/bridge.ipp>
#include <jauscat/app/impl/bridge_state.ipp>
#include <jauscat/app/impl/bus.ipp>
#include <jauscat/app/impl/bus_error.ipp>
#include <jauscat/app/impl/bus_state.ipp>
#include <jauscat/app/impl/clients.ipp>
#include <jauscat/app/impl/component.ipp>
#include <jauscat/app/impl/component_state.ipp>
#include <jauscat/app/impl/error.ipp>
#include <jauscat/app/impl/node_state.ipp>
#include <jauscat/app/impl/search.ipp>
#include <jauscat/app/impl/slave.ipp>
#include <jauscat/esi/impl/check_esi.ipp>
#include <jauscat/esi/impl/emulated_device.ipp>
#include <jauscat/esi/impl/make_device.ipp>
#include <jauscat/esi/impl/read_esi.ipp>
#include <jauscat/esi/impl/text_values.ipp>
#include <jauscat/esi/impl/write_esi.ipp>
#include <jauscat/net/config/impl/read_jaus_config.ipp>
#include <jauscat/net/link/impl/any_link.ipp>
#include <jauscat/net/link/impl/raw_link.ipp>
#include <jauscat/net/link/impl/udp_link.ipp>
#include <jauscat/net/link/impl/udp_transport.ipp>
#include <jauscat/net/node/impl/jaus_node.ipp>
#include <jauscat/net/node/impl/node_machine.ipp>
#include <jauscat/net/node/impl/own_manager.ipp>
#include <jauscat/text/impl/from_text.ipp>
#include <jauscat/text/impl/input.ipp>
#include <jauscat/text/impl/print.ipp>
