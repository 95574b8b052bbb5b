// A bridge as the application has it.
#include <jauscat/app/impl/bridge.ipp>
