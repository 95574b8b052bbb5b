// JAUS messages over UDP.
#include <jauscat/net/link/impl/udp_transport.ipp>
