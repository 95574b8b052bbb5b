// How a master's job ended, for a log.
#pragma once
#include <jauscat/ethercat/code_texts.hpp>
#include <jauscat/ethercat/master/master_errc.hpp>
#include <jauscat/text/hex.hpp>

#include <stdexcept>
#include <string>

namespace example {

inline std::string explain(const jauscat::ethercat::outcome& result) {
    std::string why{describe(result.error)};
    if (const auto detail = describe_detail(result); !detail.empty())
        why += ": " + std::string{detail} + " (" + jauscat::text::hex_number(result.detail, 8) + ")";
    return why;
}

/// For programs that cannot go on without it.
inline void require(const jauscat::ethercat::outcome& result, const std::string& what) {
    if (!result) throw std::runtime_error{what + ": " + explain(result)};
}

} // namespace example
