// The SAE transport.
#include <jauscat/sae/transport/impl/duplicate_filter.ipp>
#include <jauscat/sae/transport/impl/fragments.ipp>
#include <jauscat/sae/transport/impl/packet_queue.ipp>
#include <jauscat/sae/transport/impl/peer_table.ipp>
#include <jauscat/sae/transport/impl/transport.ipp>
