// jauscat::net links and opens a socket.
#include <jauscat/net/link/udp_transport.hpp>

int main() {
    boost::asio::io_context context;
    jauscat::net::udp_transport udp{context, {boost::asio::ip::address_v4::loopback(), 0}};
    return udp.local().port() != 0 ? 0 : 1;
}
