// SAE JAUS over UDP, TCP and serial lines, and the node that has them.
#include <jauscat/net/sae/impl/jserial_link.ipp>
#include <jauscat/net/sae/impl/jtcp_link.ipp>
#include <jauscat/net/sae/impl/judp_link.ipp>
#include <jauscat/net/sae/impl/sae_node.ipp>
#include <jauscat/net/sae/impl/shared_judp.ipp>
#include <jauscat/net/sae/impl/transport_driver.ipp>
