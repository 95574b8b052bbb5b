// Everything below the I/O line: codec, translation, schemas, behaviour. No heap, exceptions, RTTI, clock or socket.
#pragma once
#include <jauscat/ethercat/delivery.hpp>
#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/ethercat/loopback_link.hpp>
#include <jauscat/ethercat/master.hpp>
#include <jauscat/ethercat/slave.hpp>
#include <jauscat/jaus/dispatcher.hpp>
#include <jauscat/jaus/framing.hpp>
#include <jauscat/jaus/message.hpp>
#include <jauscat/jaus/requested_fields.hpp>
#include <jauscat/schema/jaus/catalog.hpp>
#include <jauscat/schema/jaus/messages.hpp>
#include <jauscat/schema/translation/seed_table.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>
#include <jauscat/translate/translator.hpp>
#include <jauscat/wire/wire.hpp>
