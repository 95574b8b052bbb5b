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
#include <jauscat/net/config/impl/read_jaus_config.ipp>
#include <jauscat/net/node/impl/jaus_node.ipp>
#include <jauscat/net/node/impl/node_machine.ipp>
#include <jauscat/net/node/impl/own_manager.ipp>
