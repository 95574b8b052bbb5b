// Writes to a stream of Boost.Asio in the order of the calls, with a limit for the bytes that wait.
#pragma once

#include <boost/asio/buffer.hpp>
#include <boost/asio/write.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace jauscat::net::detail {

template <class Stream> class bounded_writer {
  public:
    using error_handler = std::function<void(const boost::system::error_code&)>;

    /// `stream` must exist while a handler of it may run; `owner` expires with it.
    bounded_writer(Stream& stream, std::size_t most, error_handler failed)
        : stream_{stream}, most_{most}, failed_{std::move(failed)} {}

    /// False if the bytes exceed the limit: none of them is written.
    bool write(std::span<const std::byte> bytes, const std::shared_ptr<void>& owner) {
        if (waiting_.size() + bytes.size() > most_) return false;
        waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
        if (writing_.empty()) next(owner);
        return true;
    }

  private:
    void next(const std::weak_ptr<void>& owner) {
        std::swap(writing_, waiting_);
        boost::asio::async_write(stream_, boost::asio::buffer(writing_.data(), writing_.size()),
                                 [this, owner](const boost::system::error_code& error, std::size_t) {
                                     const auto alive = owner.lock();
                                     if (!alive) return;
                                     writing_.clear();
                                     if (error) return failed_(error);
                                     if (!waiting_.empty()) next(owner);
                                 });
    }

    Stream& stream_;
    std::size_t most_;
    error_handler failed_;
    std::vector<std::byte> waiting_{}, writing_{};
};

} // namespace jauscat::net::detail
