/// How check_scene tells its findings: about one object at a time, by name and field.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/scene/scene.h"

#include <initializer_list>
#include <set>
#include <string>
#include <string_view>

namespace hanei {

/// Findings about one object.
class ObjectFindings {
public:
    /// `field` as in the project file ("luminaires[2]"), `kind` as people say it ("luminaire").
    ObjectFindings(Diagnostics& findings, std::string field, std::string_view kind, std::string_view name, ObjectId id);

    void error(std::string_view field, const std::string& message) { add(Severity::error, field, message); }
    void warn(std::string_view field, const std::string& message) { add(Severity::warning, field, message); }

    /// Notes an error unless all figures are finite.
    bool finite(std::string_view field, std::initializer_list<double> figures);
    bool finite(std::string_view field, const Vec3& place) { return finite(field, {place.x, place.y, place.z}); }
    bool finite(std::string_view field, const std::vector<Vec3>& places);
    /// The same, and in a range.
    bool within(std::string_view field, double figure, double low, double high);
    /// The same, and greater than 0.
    bool positive(std::string_view field, double figure);

    const std::string& title() const { return title_; }  ///< luminaire "Panel 1"

private:
    void add(Severity severity, std::string_view field, const std::string& message);

    Diagnostics& findings_;
    std::string field_;
    std::string title_;
    ObjectId id_;
};

/// What the checks of single objects share.
struct SceneChecks {
    const Scene& scene;
    Diagnostics findings;
    std::set<ObjectId> ids;

    ObjectFindings about(std::string_view list, std::size_t index, std::string_view kind, std::string_view name,
                         ObjectId id);
    void check_id(ObjectFindings& object, ObjectId id);
    void check_material(ObjectFindings& object, std::string_view field, ObjectId material);
};

/// A figure as people write it: at most six digits.
std::string figure(double value);

// Each object by itself.
void check_materials(SceneChecks& checks);
void check_room(SceneChecks& checks);
void check_furniture(SceneChecks& checks);
void check_surfaces(SceneChecks& checks);
void check_photometries(SceneChecks& checks);
void check_luminaires(SceneChecks& checks);
void check_groups(SceneChecks& checks);
void check_calculation(SceneChecks& checks);  ///< grids, points and views
void check_colour_scale(SceneChecks& checks);
void check_lighting(SceneChecks& checks);  ///< control groups, light scenes and arrangements

/// 0 for neutral light, or a temperature in kelvin.
void check_colour_temperature(ObjectFindings& object, double kelvin);

// Objects among each other; for scenes without errors so far.
void check_places(SceneChecks& checks);    ///< what lies outside the room or inside furniture
void check_overlaps(SceneChecks& checks);  ///< solids that share space

/// Planar, with area, not crossing itself; holes in its plane and wound against it.
void check_region(ObjectFindings& object, const std::string& field, const Region& region);
/// Closed, with flat faces, front outward.
void check_solid(ObjectFindings& object, const std::string& field, const std::vector<Vec3>& vertices,
                 const std::vector<std::vector<int>>& faces);

}  // namespace hanei
