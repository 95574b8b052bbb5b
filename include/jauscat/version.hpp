// The version of these headers: semantic versioning, docs/packaging.md says what a step of each number may change.
// CMake and pkg-config take it from here.
#pragma once

/// Changes when programs may have to be changed.
#define JAUSCAT_VERSION_MAJOR 0
/// Changes with every addition; while the first number is 0 also when programs may have to be changed.
#define JAUSCAT_VERSION_MINOR 1
/// Changes with corrections.
#define JAUSCAT_VERSION_PATCH 0
/// All of it in one integer that grows: `#if JAUSCAT_VERSION >= 10203` asks for 1.2.3.
#define JAUSCAT_VERSION (JAUSCAT_VERSION_MAJOR * 10000 + JAUSCAT_VERSION_MINOR * 100 + JAUSCAT_VERSION_PATCH)

#define JAUSCAT_VERSION_QUOTED(major, minor, patch) #major "." #minor "." #patch
#define JAUSCAT_VERSION_EXPANDED(major, minor, patch) JAUSCAT_VERSION_QUOTED(major, minor, patch)
/// `"1.2.3"`.
#define JAUSCAT_VERSION_TEXT                                                                                           \
    JAUSCAT_VERSION_EXPANDED(JAUSCAT_VERSION_MAJOR, JAUSCAT_VERSION_MINOR, JAUSCAT_VERSION_PATCH)
