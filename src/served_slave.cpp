// The slaves of a bridge.
#include <jauscat/app/impl/served_slave.ipp>
