// Service definitions: read from JSIDL files, written as schema headers.
#include <jauscat/jsidl/impl/check.ipp>
#include <jauscat/jsidl/impl/facts.ipp>
#include <jauscat/jsidl/impl/names.ipp>
#include <jauscat/jsidl/impl/read_jsidl.ipp>
#include <jauscat/jsidl/impl/write_schemas.ipp>
