/// The graphics side knows single precision only: at a hundred kilometres its coordinates step by 8 mm.
/// What is drawn of a scene far from the origin is drawn about a place of its own.
#pragma once

#include "engine/scene/faces.h"

#include <glm/glm.hpp>

namespace hanei {

/// Makes `origin` the place that drawn() counts from, until it goes. One at a time in a thread.
class DrawnAbout {
public:
    explicit DrawnAbout(const Vec3& origin);
    ~DrawnAbout();
    DrawnAbout(const DrawnAbout&) = delete;
    DrawnAbout& operator=(const DrawnAbout&) = delete;
};

/// A place as vertices hold it.
glm::vec3 drawn(const Vec3& place);

/// Where to draw a scene of these bounds about: near it, in steps much larger than it, so that an edit
/// hardly ever changes it. The scene's own origin while that is near.
Vec3 drawing_origin(const Bounds& bounds);

}  // namespace hanei
