// The codec, all of it.
#pragma once
#include <jauscat/wire/bits.hpp>
#include <jauscat/wire/clamp.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/diagnose.hpp>
#include <jauscat/wire/encode.hpp>
#include <jauscat/wire/field.hpp>
#include <jauscat/wire/layout.hpp>
#include <jauscat/wire/nested.hpp>
#include <jauscat/wire/presence.hpp>
#include <jauscat/wire/raw.hpp>
#include <jauscat/wire/result.hpp>
#include <jauscat/wire/scalar.hpp>
#include <jauscat/wire/scaled.hpp>
#include <jauscat/wire/view.hpp>
#include <jauscat/wire/visit.hpp>
