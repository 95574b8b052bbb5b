// A JAUS node without sockets.
#include <jauscat/net/node/impl/node_machine.ipp>
