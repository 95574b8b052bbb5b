// What a bus has its master do.
#include <jauscat/app/impl/bus_jobs.ipp>
