/// What came out: values with their error bars, and the request they answer.
#pragma once

#include "engine/base/progress.h"
#include "engine/mesh/mesh.h"
#include "engine/plan/plan.h"
#include "engine/solution/shadows.h"

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace hanei {

/// How wrong a value may be, by cause, lx. `iteration` (with rounding) and `skipped` are bounds, `mesh` is an
/// estimate from two resolutions. `sampling` is what integrating measured openings over sample points
/// leaves, or taking them for points (99 of 100 values are within it: opening_integral.h); 0 where all
/// direct light is exact. It says nothing about the model (diffuse surfaces) nor about the input.
struct ErrorBar {
    double iteration = 0.0;
    double mesh = 0.0;
    double skipped = 0.0;
    double sampling = 0.0;
    double total() const { return iteration + mesh + skipped + sampling; }
};

/// Illuminance at a place, by the way the light came.
struct PointValue {
    Illuminance direct;
    Illuminance interreflected;
    ErrorBar error;
    bool inside_solid = false;  ///< then all is 0 and means nothing
    Illuminance total() const { return direct + interreflected; }
};

struct PointResult {
    ObjectId point;  ///< the authored point
    Vec3 position{0.0};
    Vec3 normal{0.0, 0.0, 1.0};
    PointValue value;
};

struct GridResult {
    ObjectId grid;
    int columns = 0, rows = 0;        ///< along, across
    std::vector<PointResult> points;  ///< row by row
};

/// Figures of a grid over its points outside solids.
struct GridFigures {
    double mean = 0.0, min = 0.0, max = 0.0;  ///< lx
    double uniformity = 0.0;                  ///< min / mean (EN 12464-1 U0); 0 when the mean is 0
    double largest_error = 0.0;               ///< lx
    int points = 0;
};
GridFigures figures_of(const GridResult& grid);

/// Where the points of a grid lie: cell centres, round(length / spacing) cells a side, at least 1.
GridResult layout_of(const CalculationGrid& grid);

/// What a picture draws: cells with a value at every corner, interpolated bilinearly on screen
/// (the paper's equation 6). Patches, cut finer where direct light bends.
struct DisplayCell {
    std::uint32_t corner[4] = {};  ///< into DisplayMesh::vertices, counter-clockwise; a triangle repeats the last
    std::uint32_t face = 0;        ///< into Mesh::faces
    std::uint32_t patch = 0;       ///< into Mesh::patches
};
struct DisplayVertex {
    Vec3 position{0.0};
    float direct = 0.0F;          ///< lx
    float interreflected = 0.0F;  ///< lx
    float unshadowed = 0.0F;      ///< lx, total with no shadows at all; 0 unless asked for
};
struct DisplayMesh {
    std::vector<DisplayVertex> vertices;
    std::vector<DisplayCell> cells;
    /// Total illuminance in the three colour bands, one a vertex, whose luminance is the vertex's total;
    /// empty when the scene is neutral (colour.h): then every band is the total.
    std::vector<std::array<float, 3>> tinted;
    bool has_unshadowed = false;
};

/// Where the flux went, lm. Each part is counted by itself, none as what the others leave.
struct EnergyBalance {
    double emitted = 0.0;        ///< by luminaires and surfaces that emit by themselves
    double absorbed = 0.0;       ///< by surfaces
    double on_luminaires = 0.0;  ///< straight from one luminaire onto another that is opaque: it reflects nothing
    double escaped = 0.0;        ///< left for where no surface is seen: openings, surfaces' backs, opaque luminaires
    /// What patches and directions fail to account for.
    double imbalance() const { return emitted - absorbed - on_luminaires - escaped; }
};

struct StageTime {
    Stage stage = Stage::idle;
    double ms = 0.0;
    bool reused = false;  ///< the stage's inputs were those of the study before
};

/// A finished (or so far computed) answer. Immutable; anyone may keep it.
struct Solution {
    SceneSnapshot scene;  ///< the request: stale means that these differ from the present ones
    Settings settings;
    EffectsPlan plan;

    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const OccluderSet> occluders;
    std::vector<double> patch_direct;          ///< lx, mean over each patch
    std::vector<double> patch_interreflected;  ///< lx

    double patch_width = 0.0;  ///< m, wished for in the end: that of the settings, or the least that can be solved

    /// What points gather light from: one value a patch, or four of a linear patch (transport/nodes.h).
    int nodes_a_patch = 1;
    std::vector<double> exitance;             ///< lm/m2, solved
    std::vector<double> exitance_half_width;  ///< lm/m2, a bound

    /// The second, coarser solution that the mesh part of the error bars is estimated from; null
    /// when it was not asked for.
    std::shared_ptr<const Mesh> coarse_mesh;
    std::vector<double> coarse_exitance;  ///< lm/m2, at the nodes of the coarse mesh
    double typical_mesh_error = 0.0;      ///< lx, root mean square difference of the two at all points

    std::vector<PointResult> points;
    std::vector<GridResult> grids;
    std::map<SurfaceRef, PointValue> face_means;  ///< area means of every face
    std::shared_ptr<const DisplayMesh> display;
    std::shared_ptr<const Shadows> shadows;  ///< null unless asked for

    EnergyBalance energy;
    int bounces = 0;
    bool converged = false;        ///< the iteration reached the accuracy asked for
    bool complete = false;         ///< false for a result published on the way
    double iteration_bound = 0.0;  ///< lx, greatest iteration error of any patch
    double greatest_row_sum = 0.0;
    double closure = 0.0;  ///< share of the light between surfaces that patches alone gained or lost; made up for
    double reflected_error =
        0.0;  ///< share of interreflected light that making up for it may have misplaced; an estimate
    std::vector<StageTime> times;
    std::string refusal;             ///< why interreflection has no answer: then light is direct only; else empty
    std::vector<std::string> notes;  ///< what the user must know ("reflectance 1 in a closed room ...")
};

/// Mean illuminance of all patches by area, lx.
double mean_illuminance(const Solution& solution);

using SolutionSnapshot = std::shared_ptr<const Solution>;

}  // namespace hanei
