/// How many patches a width makes, before any is made.
#pragma once

#include "engine/scene/faces.h"

#include <span>

namespace hanei {

/// On the faces' smallest rectangles, before anything is cut off or out: at least one a face. A double,
/// for it may be beyond any integer.
double patch_count(std::span<const Face> faces, double max_patch);

/// The width nearest to the wished one, and not below it, that makes no more than `most` patches; where
/// one a face is already more, the width from which on every face has but one.
double width_for(std::span<const Face> faces, double wished, double most);

}  // namespace hanei
