// EtherCAT links: raw Ethernet and UDP.
#include <jauscat/net/link/impl/any_link.ipp>
#include <jauscat/net/link/impl/raw_link.ipp>
#include <jauscat/net/link/impl/udp_link.ipp>
