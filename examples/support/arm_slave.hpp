// What the robot arm's slave says of itself, for the arm and for its ESI file.
#pragma once
#include <jauscat/ethercat/sii_image.hpp>

namespace example {

inline constexpr jauscat::ethercat::slave_description arm_slave{.vendor = 0x4A430000,
                                                                .product = 0x0021,
                                                                .mailbox_out_size = 1486,
                                                                .mailbox_in_size = 1486,
                                                                .name = "JausCat robot arm"};

} // namespace example
