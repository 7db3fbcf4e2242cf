/// Illuminances at places of a scene as somebody else found them: a meter, another program.
#pragma once

#include "engine/base/vector.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace hanei {

/// One of them. Where it is of is said by a place, or by a set and an index, or by a point's name alone.
struct MeasuredValue {
    int line = 0;                    ///< of its file
    std::string set{};               ///< name of a grid, of a point, or of nothing of ours; may be empty
    std::optional<int> index{};      ///< of a grid's point, row by row as tables list them, counted from 1
    std::optional<Vec2> plan{};      ///< m, x and y
    std::optional<double> height{};  ///< m, z; none: on the grid that is named
    std::optional<Vec3> normal{};    ///< that the place faces; none: as the grid that is named, or up
    double lux = 0.0;
    std::optional<double> uncertainty{};  ///< lx, theirs
};

struct MeasuredValues {
    std::string file;  ///< what messages call it
    std::vector<MeasuredValue> values;
    std::size_t without_value = 0;  ///< rows that leave the illuminance out
};

}  // namespace hanei
