/// Reference cases: geometry, measuring points and expected values (hanei-reference/1).
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hanei {

struct ReferenceGrade {
    double relative = 0.0;
    double absolute = 0.0;  ///< lx; 0 when not given
};

struct ReferencePoint {
    std::string id;
    std::string set;  ///< furnished scenes: which receivers; empty elsewhere
    Vec3 position{0.0};
    Vec3 normal{0.0, 0.0, 1.0};
    double expected = 0.0;     ///< lx
    double uncertainty = 0.0;  ///< lx
    ReferenceGrade top, pass;
};

struct ReferenceFormFactor {
    std::string id;
    Region from, to;
    double expected = 0.0;
    std::optional<double> reverse;
    double uncertainty = 0.0;
    ReferenceGrade top, pass;
};

/// The mean illuminance of a surface, by the object id of its FreeSurface; id 0: of all surfaces together.
struct ReferenceMean {
    ObjectId surface;
    std::string name;
    double expected = 0.0;
    double uncertainty = 0.0;
    ReferenceGrade top, pass;
};

/// One scene with what it must give. A case with variants becomes several of these.
struct ReferenceCase {
    std::string id;        ///< "P-G3 rho=0.05"
    std::string category;  ///< "a. point source"
    std::string title;
    Scene scene;
    std::vector<ReferencePoint> points;
    std::vector<ReferenceFormFactor> form_factors;
    std::vector<ReferenceMean> means;
    std::string unsupported;  ///< why the case cannot be computed; empty when it can
};

struct ReferenceRead {
    std::vector<ReferenceCase> cases;
    Diagnostics findings;
};

ReferenceRead read_reference(const std::filesystem::path& file);
/// Every case that is supported has a scene without errors (check_scene).
/// `file` is what messages call the text, and what photometric files are beside.
ReferenceRead read_reference_text(std::string_view json, const std::filesystem::path& file);

/// A file itself; a folder's *.json files downwards, sorted, index files left out.
std::vector<std::filesystem::path> reference_files(const std::filesystem::path& path);

}  // namespace hanei
