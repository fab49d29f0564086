#pragma once

// Velarium: glTF scenes in, physically based pictures out. This header is the whole public interface.

#include <velarium/compare.hpp>
#include <velarium/engine.hpp>
#include <velarium/error.hpp>
#include <velarium/files.hpp>
#include <velarium/log.hpp>
#include <velarium/look_at.hpp>
#include <velarium/median.hpp>
#include <velarium/options.hpp>
#include <velarium/picture.hpp>
#include <velarium/reference.hpp>
#include <velarium/scene.hpp>
#include <velarium/scene_description.hpp>
#include <velarium/settings.hpp>
#include <velarium/version.hpp>
