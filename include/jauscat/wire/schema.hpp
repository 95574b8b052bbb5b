// All headers needed to declare a schema.
#pragma once
#include <jauscat/wire/array.hpp>
#include <jauscat/wire/bit_fields.hpp>
#include <jauscat/wire/bit_set.hpp>
#include <jauscat/wire/field.hpp>
#include <jauscat/wire/gated_by.hpp>
#include <jauscat/wire/layout.hpp>
#include <jauscat/wire/nested.hpp>
#include <jauscat/wire/presence.hpp>
#include <jauscat/wire/repeated.hpp>
#include <jauscat/wire/scalar.hpp>
#include <jauscat/wire/scaled.hpp>
#include <jauscat/wire/selected.hpp>
#include <jauscat/wire/string.hpp>
#include <jauscat/wire/tree.hpp>
#include <jauscat/wire/view.hpp> // a count inside a nested structure is read through a view
