// The part of the library that is no template, compiled once: the target jauscat::compiled.
#include <jauscat/src.hpp>
