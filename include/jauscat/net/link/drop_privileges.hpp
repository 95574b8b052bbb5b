// Drops the privileges that a program needed to open a raw socket, so that later faults have those of an ordinary user.
#pragma once

#include <jauscat/net/error.hpp>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <grp.h>
#include <linux/capability.h>
#include <optional>
#include <string>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace jauscat::net {

namespace detail {

/// A positive number from the environment.
inline std::optional<unsigned> id_from_environment(const char* name) {
    const char* const text = std::getenv(name);
    if (!text) return {};
    unsigned id{};
    const auto* const end = text + std::strlen(text);
    const auto [stop, error] = std::from_chars(text, end, id);
    return error == std::errc{} && stop == end && id != 0 ? std::optional{id} : std::nullopt;
}

using capability_sets = std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3>;

/// glibc has no function for these.
[[nodiscard]] inline bool get_capabilities(capability_sets& sets) noexcept {
    __user_cap_header_struct head{.version = _LINUX_CAPABILITY_VERSION_3, .pid = 0};
    return ::syscall(SYS_capget, &head, sets.data()) == 0;
}
[[nodiscard]] inline bool set_capabilities(const capability_sets& sets) noexcept {
    __user_cap_header_struct head{.version = _LINUX_CAPABILITY_VERSION_3, .pid = 0};
    return ::syscall(SYS_capset, &head, sets.data()) == 0;
}

inline error not_dropped(const char* what) {
    const std::error_code reason{errno, std::generic_category()};
    return {.code = errc::privileges_kept,
            .reason = reason,
            .message = std::string{"privileges cannot be dropped: "} + what + ": " + reason.message()};
}

} // namespace detail

/// Drops all capabilities, including CAP_NET_RAW, irrevocably, also for started programs. A program started by sudo
/// becomes the user who called it (SUDO_UID, SUDO_GID), without supplementary groups; one with the set-user-ID bit the
/// user who started it. Root without sudo stays user 0 without capabilities, and can still change that user's files.
/// Without privileges the call succeeds and changes nothing.
///
/// Open sockets are not affected; a raw_link continues, also when its interface returns. Call it after everything that
/// needs privileges (raw sockets, real-time priority, locked memory, ports below 1024) and before threads are started,
/// because Linux keeps capabilities for each thread. If it fails, the program should end.
[[nodiscard]] inline result<void, error> drop_privileges() {
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return detail::not_dropped("no_new_privs");
    ::prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0); // older kernels have none
    if (::geteuid() == 0) {
        // The variables of sudo are trusted only if no other user can have set them.
        const bool by_root = ::getuid() == 0;
        const auto user = by_root ? detail::id_from_environment("SUDO_UID") : std::optional{::getuid()};
        const auto group = by_root ? detail::id_from_environment("SUDO_GID") : std::optional{::getgid()};
        if (by_root && user && group && ::setgroups(0, nullptr) != 0) return detail::not_dropped("groups");
        if (user && group && ::setresgid(*group, *group, *group) != 0) return detail::not_dropped("group");
        if (user && group && ::setresuid(*user, *user, *user) != 0) return detail::not_dropped("user");
    }
    if (!detail::set_capabilities({})) return detail::not_dropped("capabilities");
    detail::capability_sets left{};
    if (!detail::get_capabilities(left)) return detail::not_dropped("capabilities");
    for (const auto& set : left)
        if ((set.effective | set.permitted | set.inheritable) != 0)
            return error{.code = errc::privileges_kept,
                         .reason = {},
                         .message = "privileges cannot be dropped: capabilities are left"};
    return {};
}

} // namespace jauscat::net
