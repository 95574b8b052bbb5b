// The description of the robot arm's slave, for the arm and for its ESI file.
#pragma once
#include <jauscat/ethercat/slave/image_entries.hpp>
#include <jauscat/ethercat/slave/slave_description.hpp>
#include <jauscat/schema/translation/wrench_effort_image.hpp>

namespace example {

/// All messages that steer the arm fit its mailbox; larger ones, such as those with long texts, go in segments. A
/// mailbox is sent whole each time: 128 bytes take 12 us on a wire, 1486 take 120.
inline constexpr jauscat::ethercat::slave_description arm_slave{
    .vendor = 0x4A430000,
    .product = 0x0021,
    .mailbox_out_size = 128,
    .mailbox_in_size = 128,
    .name = "JausCat robot arm",
    .outputs = jauscat::ethercat::image_entries<jauscat::translation::wrench_effort_image,
                                                jauscat::ethercat::image_objects::outputs>,
    .inputs = jauscat::ethercat::image_entries<jauscat::translation::wrench_effort_image,
                                               jauscat::ethercat::image_objects::inputs>,
    .error_register = true,
    .hardware_version = "emulated",
    .software_version = "1",
    .synchronization = true};

} // namespace example
