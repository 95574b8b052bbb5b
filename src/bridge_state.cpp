// The components of a bridge.
#include <jauscat/app/impl/bridge_state.ipp>
