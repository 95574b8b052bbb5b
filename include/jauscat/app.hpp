// The API for applications on Linux: nodes, components, buses and bridges, without the machinery below.
#pragma once

#include <jauscat/app/bridge.hpp>
#include <jauscat/app/bus.hpp>
#include <jauscat/app/component.hpp>
#include <jauscat/app/drive.hpp>
#include <jauscat/app/node.hpp>
#include <jauscat/jaus/message/all_zero.hpp>
#include <jauscat/jaus/message/copy_present.hpp>
