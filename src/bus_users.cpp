// Bridges on a bus, and slaves in operation.
#include <jauscat/app/impl/bus_users.ipp>
