// The node manager of a JAUS node.
#include <jauscat/net/node/impl/own_manager.ipp>
