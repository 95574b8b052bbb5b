// The core service of every component, as Report Services lists it.
#pragma once
#include <jauscat/schema/jaus/dynamic_configuration.hpp>

#include <array>

namespace jauscat::jaus::core_messages {

/// Messages accepted by a component with a described_component. RA 3.3 part 3, core subgroup, and the queries of the
/// dynamic configuration subgroup that every component answers.
inline constexpr std::array<supported_message, 17> input{{{0x0001},
                                                          {0x0002},
                                                          {0x0003},
                                                          {0x0004},
                                                          {0x0005},
                                                          {0x0006},
                                                          {0x0007},
                                                          {0x000D},
                                                          {0x000E},
                                                          {0x0011, 0x03},
                                                          {0x2001},
                                                          {0x2002},
                                                          {0x200D},
                                                          {0x2011},
                                                          {0x2202},
                                                          {0x2B00},
                                                          {0x2B03}}};
/// Messages sent.
inline constexpr std::array<supported_message, 9> output{
    {{0x000F}, {0x0010}, {0x4001}, {0x4002}, {0x400D}, {0x4011, 0x03}, {0x4202}, {0x4B00}, {0x4B03}}};
/// The service type of what every component can do is 0.
inline constexpr offered_service service{0, input, output};
/// The services of a component that has no other.
inline constexpr std::array services{service};

} // namespace jauscat::jaus::core_messages
