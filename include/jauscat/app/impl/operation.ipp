// How the handler of an operation is called.
#pragma once
#include <jauscat/app/detail/operation.hpp>

#include <boost/asio/post.hpp>

#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

JAUSCAT_DECL handler_call::handler_call(const handler_executor& executor) : work_{executor} {}

JAUSCAT_DECL void handler_call::call_later(std::shared_ptr<handler_call> self) {
    boost::asio::post(work_.get_executor(), [self = std::move(self)] { self->call(); });
    work_.reset();
}

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
