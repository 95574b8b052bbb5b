// The forms of datagrams that were named in the log, by sender, so that each is named once.
#pragma once

#include <boost/asio/ip/address.hpp>

#include <cstddef>
#include <set>
#include <utility>

namespace jauscat::net::detail {

/// Remembers a limited number, so that forged senders cannot fill memory or the log; later ones are not named.
template <class Form> class named_forms {
  public:
    static constexpr std::size_t most = 256;

    /// Whether the form of this host is to be named now.
    [[nodiscard]] bool is_new(const boost::asio::ip::address& from, Form form) {
        return named_.size() < most && named_.emplace(from, form).second;
    }

  private:
    std::set<std::pair<boost::asio::ip::address, Form>> named_{};
};

} // namespace jauscat::net::detail
