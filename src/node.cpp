// The node of an application.
#include <jauscat/app/impl/node_state.ipp>
