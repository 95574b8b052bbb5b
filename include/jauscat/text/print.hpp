// Any message as text, a field a line:
//
//     number_of_joints = 1
//     number_of_poses = 1
//     pose[0]
//       pose_time = 2.5 s (raw 1789570)
//       joint[0]
//         joint_position = 0.785398 rad (raw 2214592510)
//
// The names are those of from_text; see annotate.hpp for the bytes beside them.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/text/describe.hpp>

#include <cstddef>
#include <string>

namespace jauscat::text {

inline namespace JAUSCAT_WAY {
/// The fields of a message or structure, a line each; `indent` spaces before them.
[[nodiscard]] JAUSCAT_DECL std::string to_text(const structure& type, const void* object, std::size_t indent = 2);
} // namespace JAUSCAT_WAY
/// The same for a typed message.
template <wire::message T> [[nodiscard]] std::string to_text(const T& message, std::size_t indent = 2) {
    return to_text(describe<T>(), &message, indent);
}

} // namespace jauscat::text

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/text/impl/print.ipp>
#endif
