// A bridge of the application.
#include <jauscat/app/impl/bridge.ipp>
#include <jauscat/app/impl/bridge_state.ipp>
