// Messages as text, and by their names.
#include <jauscat/catalogue/impl/entry.ipp>
#include <jauscat/catalogue/impl/list.ipp>
#include <jauscat/text/impl/annotate.ipp>
#include <jauscat/text/impl/from_text.ipp>
#include <jauscat/text/impl/input.ipp>
#include <jauscat/text/impl/print.ipp>
