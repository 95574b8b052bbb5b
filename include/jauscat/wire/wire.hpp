// The codec, all of it.
#pragma once
#include <jauscat/wire/clamp.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/diagnose.hpp>
#include <jauscat/wire/encode.hpp>
#include <jauscat/wire/no_schema.hpp>
#include <jauscat/wire/raw.hpp>
#include <jauscat/wire/schema.hpp>
#include <jauscat/wire/view.hpp>
#include <jauscat/wire/visit.hpp>
