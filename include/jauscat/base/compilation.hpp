// How the part of the library that is no template is compiled: in each source that includes it, or once.
#pragma once

/// Define JAUSCAT_SEPARATE_COMPILATION for all sources of a program, and include <jauscat/src.hpp> in one of them; the
/// CMake target jauscat::compiled does both. Without it the library is header-only.
///
/// The names of the classes concerned differ (`jauscat::header_only::node`, `jauscat::compiled_once::node`), so that a
/// program that mixes both ways does not link. State machines keep their names: their functions, declared with
/// JAUSCAT_FUNCTION, or JAUSCAT_CONSTEXPR if they are constexpr where the library is header-only, have names of their
/// own in the object file (`ring::on_time[abi:compiled_once]`). So a program may link a library that uses them
/// header-only.
///
/// Virtual functions are declared with JAUSCAT_DECL in their class too: g++ writes the table of a class whose first
/// virtual function is not inline there into each program, and with it all that the functions call (300 KB for the
/// bridge and the bus, in a program that has neither).
#ifdef JAUSCAT_SEPARATE_COMPILATION
#    define JAUSCAT_DECL
#    define JAUSCAT_FUNCTION __attribute__((abi_tag("compiled_once")))
#    define JAUSCAT_CONSTEXPR JAUSCAT_FUNCTION
#    define JAUSCAT_WAY compiled_once
#else
#    define JAUSCAT_DECL inline
#    define JAUSCAT_FUNCTION __attribute__((abi_tag("header_only"))) inline
#    define JAUSCAT_CONSTEXPR __attribute__((abi_tag("header_only"))) constexpr
#    define JAUSCAT_WAY header_only
#endif
