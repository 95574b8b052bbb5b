// The state machines of a component of the application.
#include <jauscat/app/impl/component.ipp>
#include <jauscat/app/impl/component_state.ipp>
