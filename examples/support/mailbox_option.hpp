// The option --mailbox-size of programs that are, or describe, the robot arm's slave.
#pragma once
#include "support/arm_slave.hpp"
#include "support/program.hpp"
#include <jauscat/schema/ethercat/mailbox.hpp>

#include <cstdint>

namespace example {

inline void add_mailbox_option(boost::program_options::options_description& options) {
    namespace po = boost::program_options;
    options.add_options()("mailbox-size", po::value<std::uint16_t>()->default_value(arm_slave.mailbox_in_size),
                          "bytes of each mailbox, 24 to 1486; larger objects are segmented");
}
/// Throws usage_error for a size that no mailbox has.
inline std::uint16_t mailbox_size_of(const boost::program_options::variables_map& values) {
    const auto size = values["mailbox-size"].as<std::uint16_t>();
    if (size < jauscat::ethercat::min_mailbox_size || size > jauscat::ethercat::max_mailbox_size)
        throw usage_error{"--mailbox-size must be 24 to 1486"};
    return size;
}

} // namespace example
