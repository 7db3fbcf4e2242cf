/// Solutions kept to be compared: A, B and others, and the difference of the two.
#pragma once

#include "ui/panels/view_tool.h"
#include "ui/view/difference.h"

#include <vector>

namespace hanei {

/// A solution with its scene, and the scale it was looked at with. Later edits leave it alone.
struct KeptSolution {
    std::string name;
    SolutionSnapshot solution;
    ColourScale scale;
};

class Snapshots : public ViewOverlay {
public:
    enum class Show { now, a, b, difference };

    /// As A or as B, under a name of its own. Keeping it anew replaces none: the older stays in the list.
    void keep_as_a(SolutionSnapshot solution, const ColourScale& scale);
    void keep_as_b(SolutionSnapshot solution, const ColourScale& scale);
    void remove(std::size_t number);
    void forget();  ///< another project

    std::vector<KeptSolution>& list() { return list_; }
    const std::vector<KeptSolution>& list() const { return list_; }
    std::optional<std::size_t> a() const { return a_; }
    std::optional<std::size_t> b() const { return b_; }
    void set_a(std::optional<std::size_t> number) { a_ = number; }
    void set_b(std::optional<std::size_t> number) { b_ = number; }

    Show show = Show::now;

    /// Once a frame: what the pictures show. While `flipped` the other one: A for now and for B and for the
    /// difference, B (or now) for A.
    /// Returns   null when what is to be shown is not kept: the present solution is meant.
    const SolutionSnapshot& follow(const SolutionSnapshot& present, bool flipped);
    bool shows_difference() const { return shown_ == Show::difference; }
    bool shows_kept() const { return shown_ != Show::now; }
    const SolutionSnapshot& shown() const { return now_shown_; }  ///< as follow() returned it
    std::string title() const;  ///< "A  ·  before", "B − A  ·  now − before"; empty for the present one

    /// A against B, or against the present solution while no B is kept. Null without both.
    SolutionSnapshot first() const;
    SolutionSnapshot second(const SolutionSnapshot& present) const;

    double range = 0.0;  ///< lx, of the difference's colours; 0: suggested
    double range_of(LightPart part) const;

    /// Which of them is shown, in the picture's corner.
    void draw(const PaneSight& sight, WidgetRegistry& widgets) override;

private:
    std::size_t keep(SolutionSnapshot solution, const ColourScale& scale);
    const SolutionSnapshot& difference(const SolutionSnapshot& present);

    std::vector<KeptSolution> list_;
    std::optional<std::size_t> a_, b_;
    int kept_ = 0;  ///< ever, for names
    Show shown_ = Show::now;
    struct Difference {
        SolutionSnapshot first, second, made;
    } difference_;
    SolutionSnapshot now_shown_;
};

}  // namespace hanei
