#pragma once

namespace hanei {

struct PixelSize {
    int width = 0, height = 0;
    bool operator==(const PixelSize&) const = default;
    double aspect() const { return height > 0 ? static_cast<double>(width) / height : 1.0; }
};

}  // namespace hanei
