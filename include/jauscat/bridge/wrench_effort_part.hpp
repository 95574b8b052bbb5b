// Set and Report Wrench Effort by process data.
#pragma once
#include <jauscat/bridge/image_part.hpp>
#include <jauscat/schema/translation/wrench_effort_image.hpp>

namespace jauscat::bridging {

/// The slave has the image wrench_effort_image in both directions.
using wrench_effort_part = image_part<translation::set_wrench_effort_table, translation::report_wrench_effort_table>;

} // namespace jauscat::bridging
