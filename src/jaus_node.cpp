// The sockets of a JAUS node.
#include <jauscat/net/node/impl/jaus_node.ipp>
