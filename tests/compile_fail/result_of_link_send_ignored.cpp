// expect: ignoring return
#include <jauscat/ethercat/slave/loopback_link.hpp>

void pass_on(jauscat::ethercat::loopback_link& link, std::span<const std::byte> frame) { link.send(frame); }
