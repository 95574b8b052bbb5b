// CiA 402 axes and the emulated drive.
#include <jauscat/ethercat/cia402/impl/axis.ipp>
#include <jauscat/ethercat/cia402/impl/axis_places.ipp>
#include <jauscat/ethercat/cia402/impl/emulated_axis.ipp>
#include <jauscat/ethercat/cia402/impl/start_up.ipp>
