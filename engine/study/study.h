/// The order of stages from a scene to its solution, and what of it is still valid.
#pragma once

#include "engine/base/progress.h"
#include "engine/solution/solution.h"
#include "engine/study/contributions.h"

#include <functional>
#include <memory>
#include <vector>

namespace hanei {

/// What is to be computed beyond the values themselves.
struct StudyRequest {
    bool display = false;     ///< the display mesh for pictures
    bool unshadowed = false;  ///< and its part without shadows (the paper's Fig. 4e)
    bool shadows = false;     ///< classes of patches and outlines of shadows
    bool live = false;        ///< the scene is being dragged: from the last solution on, sooner
    bool energy = false;      ///< where the flux goes
    bool mesh_error = true;   ///< the mesh part of the error bars (a second, coarser solution)
    bool refine = true;       ///< method linear cuts patches finer where the light asks for it
    bool operator==(const StudyRequest&) const = default;
};

/// Runs studies, keeping every stage's value until what it was made from changes.
///
/// Needs     a scene without errors (check_scene).
/// Holds     the last value of each stage; one thread may use it at a time.
class Study {
public:
    Study();
    ~Study();

    /// `publish`, when given, is handed results on the way (complete == false): direct light first.
    /// Returns   null when stopped.
    SolutionSnapshot run(SceneSnapshot scene, const Settings& settings, const StudyRequest& request, const Work& work,
                         const std::function<void(SolutionSnapshot)>& publish = nullptr);

    /// Where the light at a place comes from. What run() kept is used; a solution that is not the last
    /// one given out is computed anew first, from all of it that still holds.
    /// Needs     a complete solution; a unit normal.
    /// Returns   empty when stopped.
    /// Cost      a product with the rows a reflection and group, and one row: some 20 ms for 1000 patches.
    std::optional<Contributions> contributions(SolutionSnapshot solution, const Vec3& position, const Vec3& normal,
                                               const Work& work);

private:
    struct Stages;
    std::unique_ptr<Stages> stages_;
};

/// The value at any place, from a finished solution: exact direct light and one gather over the
/// solved exitance. Cost: about 0.1 us a patch. Any thread.
PointValue value_at(const Solution& solution, const Vec3& position, const Vec3& normal);

/// Form factor between two regions past the scene's occluders (for reference cases).
double form_factor_between(const Scene& scene, const Region& from, const Region& to);

}  // namespace hanei
