// The queue of a bus, its slaves and its bridges.
#include <jauscat/app/impl/bus_state.ipp>
