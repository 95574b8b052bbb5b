// A CiA 402 drive on a bus.
#include <jauscat/app/impl/drive.ipp>
