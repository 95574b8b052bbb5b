// Boost's headers of cancellation slots, from Boost 1.77 on.
#pragma once
#include <boost/version.hpp>
#if BOOST_VERSION >= 107700
#    include <boost/asio/bind_cancellation_slot.hpp>
#    include <boost/asio/cancellation_signal.hpp>
#endif
