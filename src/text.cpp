// Messages as text.
#include <jauscat/text/impl/from_text.ipp>
#include <jauscat/text/impl/input.ipp>
#include <jauscat/text/impl/print.ipp>
