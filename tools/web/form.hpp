// What a form needs to know of a message: its structure as JSON.
#pragma once
#include <jauscat/text/json.hpp>
#include <jauscat/text/structure.hpp>

namespace page {

using jauscat::text::json;

/// Name, id and members, with the form of each: its kind, and what text/structure.hpp has for this kind.
json form_of(const jauscat::text::structure& type);

} // namespace page
