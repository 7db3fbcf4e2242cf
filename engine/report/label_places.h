/// Places for labels beside points of a plot, where they cover neither each other nor the points.
#pragma once

#include <vector>

namespace hanei {

struct LabelPlace {
    double left = 0.0, top = 0.0;
    double anchor_x = 0.0, anchor_y = 0.0;  ///< of the label, where a line from the point would end
    bool is_far = false;                    ///< so far from its point that a line should say whose it is
};

/// Pixels, down positive.
class LabelPlaces {
public:
    struct Box {
        double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
    };
    explicit LabelPlaces(Box within) : within_(within) {}

    void avoid(double x, double y, double radius);
    void avoid_line(double x, double y, double to_x, double to_y);  ///< level or upright

    /// Tries around the point, ever farther; of all the place that covers least.
    LabelPlace place(double x, double y, double width, double height);

private:
    double covered(const Box& box) const;

    Box within_;
    std::vector<Box> points_, labels_;
};

}  // namespace hanei
