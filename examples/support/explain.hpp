// How a master's job ended, for a log.
#pragma once
#include <jauscat/ethercat/master/master_errc.hpp>
#include <jauscat/text/master_error_text.hpp>

#include <stdexcept>
#include <string>

namespace example {

using jauscat::text::explain;

/// For programs that cannot continue without it.
template <class T> void require(const jauscat::ethercat::master_result<T>& result, const std::string& what) {
    if (!result) throw std::runtime_error{what + ": " + explain(result.error())};
}

} // namespace example
