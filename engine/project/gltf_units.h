/// Sizes that nobody builds, and the unit they were probably drawn in.
#pragma once

#include "engine/base/vector.h"

#include <optional>
#include <string>
#include <string_view>

namespace hanei {

/// Metres of a unit by its name (m, cm, mm, in, ft); none for any other word.
std::optional<double> metres_of_unit(std::string_view name);

/// "1.6 x 0.8 x 0.74 m": three digits each.
std::string size_text(const Vec3& size);

/// A sentence about a model larger than 100 m or smaller than 5 cm, with the unit that would make furniture
/// or a room of it; empty for any other.
std::string doubtful_size(const Vec3& size, double metres_per_unit);

}  // namespace hanei
