// The commands and queries of one component that are carried by process data.
#pragma once
#include <jauscat/bridge/image_exchange.hpp>
#include <jauscat/schema/translation/wrench_effort_image.hpp>

namespace jauscat::bridging {

/// Messages carried by process data: `command_table` into the outputs, `report_table` from the inputs, `query` requests
/// the report, `component` is their JAUS component ID.
struct wrench_effort_path {
    using command_table = translation::set_wrench_effort_table;
    using report_table = translation::report_wrench_effort_table;
    using query = jaus::query_wrench_effort;
    static constexpr std::uint8_t component = 33; // Primitive Driver
};

} // namespace jauscat::bridging
