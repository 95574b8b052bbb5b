// How a master's job ended, for a log.
#pragma once
#include <jauscat/ethercat/code_texts.hpp>
#include <jauscat/ethercat/master/master_errc.hpp>
#include <jauscat/text/hex.hpp>

#include <stdexcept>
#include <string>

namespace example {

inline std::string explain(const jauscat::ethercat::master_error& error) {
    std::string why{describe(error)};
    if (const auto reason = describe_reason(error); !reason.empty())
        why += ": " + std::string{reason} + " (" + jauscat::text::hex_number(reason_code(error), 8) + ")";
    return why;
}

/// For programs that cannot continue without it.
template <class T> void require(const jauscat::ethercat::master_result<T>& result, const std::string& what) {
    if (!result) throw std::runtime_error{what + ": " + explain(result.error())};
}

} // namespace example
