/// The outline of triangles that are added one by one.
#pragma once

#include "engine/geometry/triangle_soup.h"

#include <map>

namespace hanei {

/// Holds     a loop in which every vertex stands once.
class GrowingLoop {
public:
    explicit GrowingLoop(const Triangle& first);

    /// Adds a triangle that shares one edge or two with the loop; false, and nothing happens, when the
    /// outline would touch itself.
    bool add(const Triangle& triangle);

    std::size_t size() const { return next_.size(); }
    std::vector<int> corners() const;  ///< the smallest vertex number first

private:
    bool runs(int from, int to) const;

    std::map<int, int> next_;
};

}  // namespace hanei
