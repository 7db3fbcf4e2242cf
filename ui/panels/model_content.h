#pragma once

#include "engine/plan/settings.h"
#include "engine/scene/scene.h"

namespace hanei {

/// How a model of another program is to be read.
struct ModelReading {
    enum class Kind { automatic, furniture, room };
    double metres_per_unit = 1.0;
    bool z_up = false;
    Kind kind = Kind::automatic;
    bool operator==(const ModelReading&) const = default;
};

struct ModelContent {
    Scene scene;
    Vec3 size{0.0};  ///< m
    int solids = 0, sheets = 0, luminaires = 0;
    std::optional<Settings> settings;  ///< of a project that was exported; none of other models
};

}  // namespace hanei
