// The process data of a Primitive Driver.
#include <jauscat/app/impl/wrench_effort_part.ipp>
