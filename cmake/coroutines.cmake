# JAUSCAT_HAS_COROUTINES: whether the compiler and Boost.Asio have them; clang 14 has not.
include(CheckCXXSourceCompiles)
set(CMAKE_CXX_STANDARD 20) # of the check; targets get theirs from the library
check_cxx_source_compiles("#include <utility>
#include <boost/asio/awaitable.hpp>
boost::asio::awaitable<void> nothing() { co_return; }
int main() {}" JAUSCAT_HAS_COROUTINES)
unset(CMAKE_CXX_STANDARD)
