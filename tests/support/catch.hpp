// Catch2 3 where it is installed, Catch2 2 elsewhere, under one include.
#pragma once
#if __has_include(<catch2/catch_test_macros.hpp>)
#    include <catch2/catch_approx.hpp>
#    include <catch2/catch_template_test_macros.hpp>
#    include <catch2/catch_test_macros.hpp>
using Catch::Approx;
#else
#    include <catch2/catch.hpp>
#endif
