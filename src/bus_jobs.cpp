// What an EtherCAT bus does to find and to watch slaves.
#include <jauscat/app/impl/bus_jobs.ipp>
