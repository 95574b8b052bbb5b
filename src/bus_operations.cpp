// The operations of an EtherCAT bus on objects.
#include <jauscat/app/impl/bus_operations.ipp>
