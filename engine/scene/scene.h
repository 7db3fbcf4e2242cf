/// Everything the user authored and nothing that follows from it.
///
/// A plain value: compare it, copy it, put it on the undo stack. Metres, radians, lumens; z is up.
/// Objects carry an ObjectId that is unique within the scene and never used again, so that a
/// selection, a cache or a result can name an object while the lists around it change.
#pragma once

#include "engine/base/quantity.h"
#include "engine/base/vector.h"
#include "engine/scene/photometry.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace hanei {

/// Fields of a project file that this version does not know: the text of a JSON object, kept with
/// the object it was read with and written back as it was. Empty when there are none.
using UnknownFields = std::string;

/// A perfectly diffuse surface colour.
struct Material {
    ObjectId id;
    std::string name;
    double reflectance = 0.5;  ///< 0 to 1, of the luminous flux of neutral light
    UnknownFields unknown;
    Vec3 tint{1.0};  ///< times reflectance: that of the three colour bands; its luminance is 1 (colour.h)
    bool operator==(const Material&) const = default;
};

/// A rectangle on a room face with a reflectance of its own: a door, a window pane, a board.
/// In face coordinates: for wall k, x runs along the plan edge from its first point and y up from
/// the floor; for floor and ceiling, x and y are the plan's own.
struct SubArea {
    ObjectId id;
    std::string name;
    int face = 0;  ///< Room::floor_face, Room::ceiling_face or Room::wall_face(k)
    Vec2 low{0.0};
    Vec2 high{1.0};
    ObjectId material;
    UnknownFields unknown;
    bool operator==(const SubArea&) const = default;
};

/// A plan (any simple polygon, counter-clockwise seen from above) extruded from floor to ceiling.
struct Room {
    ObjectId id;
    std::string name;
    std::vector<Vec2> plan;
    double floor_height = 0.0;  ///< m, z of the floor
    double height = 2.8;        ///< m, clear height
    ObjectId floor_material;
    ObjectId ceiling_material;
    std::vector<ObjectId> wall_materials;  ///< one a plan edge; wall k stands on plan[k] to plan[k+1]
    std::vector<SubArea> sub_areas;        ///< where two overlap, the later one is seen
    UnknownFields unknown;
    bool operator==(const Room&) const = default;

    static constexpr int floor_face = 0;
    static constexpr int ceiling_face = 1;
    static constexpr int wall_face(int k) { return 2 + k; }
};

/// A box standing on its local z = 0, centred on its local z axis.
struct BoxShape {
    Vec3 size{1.0};
    bool operator==(const BoxShape&) const = default;
};

/// A closed solid of any shape; faces are loops of vertex numbers, counter-clockwise seen from outside.
struct SolidShape {
    std::vector<Vec3> vertices;
    std::vector<std::vector<int>> faces;
    bool operator==(const SolidShape&) const = default;
};

/// One solid piece of furniture, placed within it.
struct Part {
    std::variant<BoxShape, SolidShape> shape;
    Vec3 position{0.0};     ///< m, in the furniture's frame
    double rotation = 0.0;  ///< rad, about z, counter-clockwise seen from above
    ObjectId material;
    UnknownFields unknown;
    bool operator==(const Part&) const = default;
};

/// One size of a furniture model, by the name the library gives it ("width").
struct ModelSize {
    std::string name;
    double metres = 1.0;
    bool operator==(const ModelSize&) const = default;
};

/// What of the furniture library a piece was made from (engine/edit/furniture_library.h). Its parts
/// follow from it when a size is changed; parts edited by themselves lose the model.
struct FurnitureModel {
    std::string kind;              ///< "desk"; empty: of no model
    std::vector<ModelSize> sizes;  ///< those that differ from the library's are enough
    bool operator==(const FurnitureModel&) const = default;
};

/// A desk, a shelf, a machine: a group of solid parts moved as one.
struct Furniture {
    ObjectId id;
    std::string name;
    Vec3 position{0.0};
    double rotation = 0.0;  ///< rad, about z
    std::vector<Part> parts;
    UnknownFields unknown;
    FurnitureModel model{};
    bool operator==(const Furniture&) const = default;
};

/// A free-standing planar surface. It reflects (and may emit by itself) on its front; it is opaque
/// from both sides. Screens, blinds, imported geometry and reference cases are made of these.
struct FreeSurface {
    ObjectId id;
    std::string name;
    Region region;
    ObjectId material;
    LuminousExitance own_exitance;  ///< emitted diffusely whether or not light arrives
    UnknownFields unknown;
    bool operator==(const FreeSurface&) const = default;
};

// The luminous opening, in the luminaire's frame: x is plane C0, y plane C90, nadir is -z.

struct PointOpening {
    bool operator==(const PointOpening&) const = default;
};
/// A thin diffuse tube: an element ds shines I1 sin(a) ds at the angle a to the line, all around.
struct LineOpening {
    Vec3 from{-0.5, 0.0, 0.0};
    Vec3 to{0.5, 0.0, 0.0};
    bool operator==(const LineOpening&) const = default;
};
/// Shines from the front of a planar polygon; any simple outline, holes allowed.
struct PolygonOpening {
    Region region;
    bool operator==(const PolygonOpening&) const = default;
};
/// A closed solid all of whose faces shine outward. `relative_luminance` is one weight a face;
/// empty means all faces alike.
struct PolyhedronOpening {
    std::vector<Vec3> vertices;
    std::vector<std::vector<int>> faces;
    std::vector<double> relative_luminance;
    bool operator==(const PolyhedronOpening&) const = default;
};
/// The opening stated by the luminaire's photometric file.
struct MeasuredOpening {
    bool operator==(const MeasuredOpening&) const = default;
};
using Opening = std::variant<PointOpening, LineOpening, PolygonOpening, PolyhedronOpening, MeasuredOpening>;

// How the intensity of the luminaire, or of every element of its opening, depends on direction.

/// Lambertian from a surface, uniform in all directions from a point, I1 sin(a) from a line.
struct Diffuse {
    bool operator==(const Diffuse&) const = default;
};
/// I = I0 cos^m(angle from nadir) below the horizon, 0 above it. Point openings only.
struct CosinePower {
    double exponent = 1.0;
    bool operator==(const CosinePower&) const = default;
};
/// As a photometric file says. From a polygon every element radiates the file's distribution.
struct Measured {
    ObjectId photometry;
    bool operator==(const Measured&) const = default;
};
using Distribution = std::variant<Diffuse, CosinePower, Measured>;

/// The output of a luminaire at full dimmer: its flux, its luminance (diffuse polygons and
/// polyhedra: the luminance of a face of relative weight 1), or what its photometric file says.
struct AsMeasured {
    bool operator==(const AsMeasured&) const = default;
};
using Output = std::variant<LuminousFlux, Luminance, AsMeasured>;

struct Luminaire {
    ObjectId id;
    std::string name;
    Vec3 position{0.0};
    double yaw = 0.0;   ///< rad, about z
    double tilt = 0.0;  ///< rad, turns nadir towards plane C0
    double roll = 0.0;  ///< rad, about the luminaire's own x axis
    Opening opening = PointOpening{};
    Distribution distribution = Diffuse{};
    Output output = LuminousFlux{1000.0};
    double dimming = 1.0;             ///< 0 to 1, share of the full output
    double colour_temperature = 0.0;  ///< K, of its light; 0: neutral, white as the project's pictures show it
    bool opaque = false;              ///< its opening hides what lies behind it, and reflects nothing
    ObjectId group;                   ///< the ControlGroup that dims it; may be none
    UnknownFields unknown;
    bool operator==(const Luminaire&) const = default;
};

/// Luminaires that are dimmed together: a dimmer on the wall.
struct ControlGroup {
    ObjectId id;
    std::string name;
    double dimming = 1.0;             ///< 0 to 1, times the dimming of each of its luminaires
    double colour_temperature = 0.0;  ///< K, of all its luminaires; 0: each keeps its own
    UnknownFields unknown;
    bool operator==(const ControlGroup&) const = default;
};

/// A preset of dimmers: "Lecture", "Cleaning". Recalled, it sets the groups it names.
struct LightScene {
    struct Level {
        ObjectId group;
        double dimming = 1.0;  ///< 0 to 1
        bool operator==(const Level&) const = default;
    };
    ObjectId id;
    std::string name;
    std::vector<Level> levels;
    UnknownFields unknown;
    bool operator==(const LightScene&) const = default;
};

// How an arrangement places its luminaires. Heights are the z of each luminaire's own place.

/// `count` luminaires from the first place to the last.
struct LineLayout {
    Vec3 from{0.0}, to{1.0, 0.0, 0.0};
    int count = 2;
    bool operator==(const LineLayout&) const = default;
};
/// Rows x columns over a parallelogram, half a spacing from its borders.
struct FieldLayout {
    Vec3 corner{0.0};
    Vec3 along{1.0, 0.0, 0.0};   ///< m, the side that the columns divide
    Vec3 across{0.0, 1.0, 0.0};  ///< m, the side that the rows divide
    int columns = 2, rows = 2;
    bool operator==(const FieldLayout&) const = default;
};
/// `count` luminaires at equal angles about a middle.
struct CircleLayout {
    Vec3 middle{0.0};
    double radius = 1.0;
    int count = 6;
    double first_angle = 0.0;   ///< rad
    bool face_outward = false;  ///< each is turned by its angle
    bool operator==(const CircleLayout&) const = default;
};
using Layout = std::variant<LineLayout, FieldLayout, CircleLayout>;

/// Luminaires that hang as a layout says. They are ordinary luminaires of the scene; their places
/// follow from the layout when it is changed. A luminaire moved by itself leaves the arrangement.
struct Arrangement {
    ObjectId id;
    std::string name;
    Layout layout;
    double yaw = 0.0;                  ///< rad, of every luminaire
    std::vector<ObjectId> luminaires;  ///< one a place of the layout, in its order; none where a place is empty
    UnknownFields unknown;
    bool operator==(const Arrangement&) const = default;
};

/// Objects that are chosen and moved as one.
struct ObjectGroup {
    ObjectId id;
    std::string name;
    std::vector<ObjectId> members;  ///< furniture, surfaces, luminaires, grids, points; each in one group at most
    UnknownFields unknown;
    bool operator==(const ObjectGroup&) const = default;
};

/// Points at the centres of the cells of a parallelogram.
struct CalculationGrid {
    ObjectId id;
    std::string name;
    Vec3 corner{0.0};
    Vec3 along{1.0, 0.0, 0.0};   ///< m, first side
    Vec3 across{0.0, 1.0, 0.0};  ///< m, second side; along x across points to the lit side
    double spacing = 0.25;       ///< m, wished distance of points
    UnknownFields unknown;
    bool operator==(const CalculationGrid&) const = default;
};

struct CalculationPoint {
    ObjectId id;
    std::string name;
    Vec3 position{0.0};
    Vec3 normal{0.0, 0.0, 1.0};  ///< unit
    UnknownFields unknown;
    bool operator==(const CalculationPoint&) const = default;
};

/// A plane that a picture is cut at: the half space dot(normal, x) > offset is left out.
struct Cut {
    Vec3 normal{0.0, 0.0, 1.0};  ///< unit
    double offset = 0.0;         ///< m
    bool operator==(const Cut&) const = default;
};

/// A saved camera.
struct View {
    ObjectId id;
    std::string name;
    Vec3 eye{0.0};
    Vec3 target{0.0};
    double field_of_view = 0.9;  ///< rad, vertical
    bool orthographic = false;   ///< then the picture is as high as the field of view at the target
    UnknownFields unknown;
    bool hides_ceiling = false;  ///< looked into from above, as into a doll's house
    std::optional<Cut> cut{};    ///< only what lies behind it is drawn
    bool operator==(const View&) const = default;
};

/// How figures become colours in every picture of the project: one scale, so that pictures compare.
struct ColourScale {
    double low = 10.0, high = 1000.0;  ///< lx
    std::string steps = "log";         ///< log, linear, en (the steps of EN 12464-1)
    bool marks_clipped = false;        ///< what lies outside the range is shown hatched
    std::vector<double> isolux{};      ///< lx, rising: the lines of equal illuminance; none: the steps of the scale
    UnknownFields unknown{};
    bool operator==(const ColourScale&) const = default;
};

struct Scene {
    std::string title;
    std::vector<Material> materials;
    std::optional<Room> room;
    std::vector<Furniture> furniture;
    std::vector<FreeSurface> surfaces;
    std::vector<Photometry> photometries;
    std::vector<Luminaire> luminaires;
    std::vector<CalculationGrid> grids;
    std::vector<CalculationPoint> points;
    std::vector<View> views;
    double maintenance_factor = 1.0;  ///< 0 to 1, multiplies every luminaire's output
    std::uint32_t last_id = 0;        ///< the greatest ObjectId ever given
    UnknownFields unknown;
    std::vector<ControlGroup> control_groups;
    std::vector<LightScene> light_scenes;
    std::vector<Arrangement> arrangements;
    std::vector<ObjectGroup> object_groups;
    std::optional<ColourScale> colour_scale;  ///< none: fitted to the light
    bool operator==(const Scene&) const = default;

    ObjectId new_id() { return ObjectId{++last_id}; }
};

/// Safe to read from any thread, for as long as anybody holds it.
using SceneSnapshot = std::shared_ptr<const Scene>;

}  // namespace hanei
