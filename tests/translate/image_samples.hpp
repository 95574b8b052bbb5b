// What the tests of translation into a process image share.
#pragma once
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/schema/translation/wrench_effort_image.hpp>
#include <jauscat/translate/diagnose_image.hpp>
#include <jauscat/translate/image_translator.hpp>

namespace jauscat::test {

using command = translate::image_translator<translation::set_wrench_effort_table>;
using report = translate::image_translator<translation::report_wrench_effort_table>;
using image = std::array<std::byte, command::image_size>;
using translation::wrench_effort_image;

inline wrench_effort_image values_of(const image& bytes) {
    wrench_effort_image values{};
    REQUIRE(wire::decode(values, bytes));
    return values;
}

} // namespace jauscat::test
