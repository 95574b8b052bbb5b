// An EtherCAT bus of the application, and its slaves.
#include <jauscat/app/impl/bus.ipp>
#include <jauscat/app/impl/bus_error.ipp>
#include <jauscat/app/impl/bus_state.ipp>
#include <jauscat/app/impl/slave.ipp>
