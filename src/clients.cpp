// What a component asks of others, and the search for them.
#include <jauscat/app/impl/clients.ipp>
#include <jauscat/app/impl/error.ipp>
#include <jauscat/app/impl/explained.ipp>
#include <jauscat/app/impl/operation.ipp>
#include <jauscat/app/impl/search.ipp>
