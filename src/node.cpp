// The node of an application.
#include <jauscat/app/impl/node_context.ipp>
#include <jauscat/app/impl/node_state.ipp>
