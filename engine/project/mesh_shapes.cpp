#include "engine/project/mesh_shapes.h"

#include "engine/geometry/flat_faces.h"
#include "engine/geometry/polygon.h"
#include "engine/scene/scene_findings.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>

namespace hanei {
namespace {

/// Whether check_scene would have nothing against it.
template <class Check>
bool passes(Check check) {
    Diagnostics findings;
    ObjectFindings object(findings, {}, {}, {}, {});
    check(object);
    return !has_errors(findings);
}

Region region_of(const std::vector<Vec3>& vertices, const FlatFace& face) {
    Region region{polygon_of(vertices, face.loop), {}};
    for (const std::vector<int>& hole : face.holes) region.holes.push_back(polygon_of(vertices, hole));
    return region;
}

Region reversed(Region region) {
    std::reverse(region.outline.begin(), region.outline.end());
    for (Polygon& hole : region.holes) std::reverse(hole.begin(), hole.end());
    return region;
}

/// A count and its noun.
std::string counted(std::size_t count, const char* one, const char* many) {
    return count == 1 ? fmt::format("1 {}", one) : fmt::format("{} {}", count, many);
}

class ShapeMaking {
public:
    ShapeMaking(const MeshObject& object, const std::vector<GltfMaterial>& materials)
        : object_(object), materials_(materials) {}

    MeshShapes make() {
        tell_repairs();
        for (const TriangleShell& shell : object_.shells) {
            if (is_hollow(shell))
                ++hollows_;
            else if (!shell.closed || shines(shell) || !add_solid(shell))
                keep_as_sheet(shell);
        }
        add_sheets();
        tell_shells();
        number_sheets();
        return std::move(result_);
    }

private:
    const GltfMaterial& material(int label) const { return materials_[static_cast<std::size_t>(label)]; }

    void note(std::string sentence) { result_.remarks.emplace_back(Severity::note, std::move(sentence)); }
    void warn(std::string sentence) { result_.remarks.emplace_back(Severity::warning, std::move(sentence)); }

    bool shines(const TriangleShell& shell) {
        const bool any = std::any_of(shell.triangles.begin(), shell.triangles.end(), [&](const Triangle& triangle) {
            return material(triangle.label).own_exitance.value > 0.0;
        });
        shining_ += any ? 1 : 0;
        return any;
    }

    /// Wound against a greater shell around it.
    bool is_hollow(const TriangleShell& shell) const {
        constexpr std::size_t most = 200;  // beyond, nobody has modelled hollows on purpose
        if (!shell.closed || object_.shells.size() > most) return false;
        const bool turned = shell.turned == shell.triangles.size();
        return std::any_of(object_.shells.begin(), object_.shells.end(), [&](const TriangleShell& other) {
            const bool other_turned = other.turned == other.triangles.size();
            return &other != &shell && other.closed && other.volume > shell.volume && turned != other_turned &&
                   winding_number(other, shell.vertices[0]) > 0.5;
        });
    }

    bool add_solid(const TriangleShell& shell) {
        const std::vector<FlatFace> faces = flat_faces(shell, {false, false, object_.distance});
        SolidShape shape;
        std::map<int, int> numbers;
        std::map<int, double> shares;
        for (const FlatFace& face : faces) {
            std::vector<int>& loop = shape.faces.emplace_back();
            shares[face.label] += face.area;
            for (const int vertex : face.loop) {
                const auto [place, is_new] = numbers.try_emplace(vertex, static_cast<int>(shape.vertices.size()));
                if (is_new) shape.vertices.push_back(shell.vertices[static_cast<std::size_t>(vertex)]);
                loop.push_back(place->second);
            }
        }
        if (!passes([&](ObjectFindings& checked) { check_solid(checked, "faces", shape.vertices, shape.faces); })) {
            ++unsound_;
            return false;
        }
        const auto less = [](const auto& a, const auto& b) { return a.second < b.second; };
        const int label = std::max_element(shares.begin(), shares.end(), less)->first;
        tell_materials(shell, label);
        turned_solids_ += shell.turned == shell.triangles.size() ? 1 : 0;
        if (shell.turned < shell.triangles.size()) turned_triangles_ += shell.turned;
        result_.solids.push_back({std::move(shape), material(label).material.id});
        return true;
    }

    void tell_materials(const TriangleShell& shell, int label) {
        std::set<int> labels;
        for (const Triangle& triangle : shell.triangles) labels.insert(triangle.label);
        if (labels.size() > 1)
            warn(fmt::format("a solid of it has {} materials; \"{}\", which covers most of it, is taken for all",
                             labels.size(), material(label).material.name));
    }

    void keep_as_sheet(const TriangleShell& shell) {
        one_sided_ = one_sided_ || shell.one_sided;
        const int first = static_cast<int>(open_.vertices.size());
        open_.vertices.insert(open_.vertices.end(), shell.vertices.begin(), shell.vertices.end());
        for (Triangle triangle : shell.triangles) {
            for (int& corner : triangle.corner) corner += first;
            open_.triangles.push_back(triangle);
        }
        turned_triangles_ += shell.closed ? 0 : shell.turned;
    }

    /// Of two-sided triangles that lie back to back one is enough.
    void drop_backs() {
        std::set<std::array<int, 3>> known;
        std::erase_if(open_.triangles, [&](const Triangle& triangle) {
            std::array<int, 3> corners = triangle.corner;
            std::sort(corners.begin(), corners.end());
            return material(triangle.label).two_sided && !known.insert(corners).second;
        });
    }

    void add_sheets() {
        if (open_.triangles.empty()) return;
        weld(open_, object_.distance);
        drop_backs();
        for (const TriangleShell& shell : shells_of(open_))
            for (const FlatFace& face : flat_faces(shell, {true, true, object_.distance})) add_sheet(shell, face);
    }

    void add_sheet(const TriangleShell& shell, const FlatFace& face) {
        FreeSurface sheet;
        sheet.region = region_of(shell.vertices, face);
        sheet.material = material(face.label).material.id;
        sheet.own_exitance = material(face.label).own_exitance;
        if (!passes([&](ObjectFindings& checked) { check_region(checked, {}, sheet.region); })) {
            ++lost_;
            return;
        }
        result_.sheets.push_back(sheet);
        if (shell.closed) return;
        ++faces_;
        if (!material(face.label).two_sided) {
            ++backless_;
            return;
        }
        sheet.region = reversed(std::move(sheet.region));
        result_.sheets.push_back(std::move(sheet));
    }

    void tell_repairs() {
        const SoupRepairs& done = object_.repairs;
        if (done.without_area > 0)
            note(counted(done.without_area, "triangle without area is", "triangles without area are") + " left out");
        if (done.repeated > 0)
            note(counted(done.repeated, "triangle that is there twice is", "triangles that are there twice are") +
                 " left out");
        if (done.split > 0)
            note(counted(done.split, "triangle is", "triangles are") +
                 " cut where a corner of another lies on its edge");
    }

    void tell_shells() {
        if (turned_solids_ > 0)
            note(
                counted(turned_solids_, "solid of it was inside out; it is", "solids of it were inside out; they are") +
                " turned round");
        if (turned_triangles_ > 0)
            note(counted(turned_triangles_, "triangle is", "triangles are") +
                 " wound against the others; turned round");
        if (hollows_ > 0)
            note(counted(hollows_, "hollow inside a solid is", "hollows inside solids are") +
                 " left out: nobody sees into it");
        if (unsound_ > 0)
            warn(counted(unsound_, "closed shell", "closed shells") +
                 " of it cannot be solid: faces cross each other; the faces stand for themselves");
        if (shining_ > 0)
            note(counted(shining_, "solid", "solids") +
                 " of it shines by itself, which surfaces alone can; its faces stand for it");
        if (one_sided_) warn("a strip of it has no two sides; its fronts are as the file has them");
        if (lost_ > 0) warn(counted(lost_, "face", "faces") + " of it that cross themselves are left out");
        if (faces_ > 0)
            warn(fmt::format("it is not closed: {} as surfaces{}",
                             counted(faces_, "face stands free", "faces stand free"),
                             backless_ == 0 ? ", lit on both sides"
                                            : "; their backs are black (make the material two-sided to change that)"));
    }

    void number_sheets() {
        for (std::size_t k = 0; k < result_.sheets.size(); ++k)
            result_.sheets[k].name =
                result_.sheets.size() == 1 ? object_.name : fmt::format("{} {}", object_.name, k + 1);
    }

    const MeshObject& object_;
    const std::vector<GltfMaterial>& materials_;
    MeshShapes result_;
    TriangleSoup open_;
    std::size_t hollows_ = 0, unsound_ = 0, shining_ = 0, turned_solids_ = 0, turned_triangles_ = 0;
    std::size_t faces_ = 0, backless_ = 0, lost_ = 0;  ///< of open shells, but for the last
    bool one_sided_ = false;
};

}  // namespace

MeshObject mesh_object(std::string name, TriangleSoup soup, double distance) {
    constexpr double share = 1e-5;             // of the object: 20 um of a desk
    constexpr double single_precision = 2e-7;  // of a coordinate, after it was turned
    constexpr double least = 1e-9;             // m
    MeshObject object;
    object.name = std::move(name);
    double farthest = 0.0;
    for (const Vec3& v : soup.vertices) farthest = std::max({farthest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    object.distance =
        distance > 0.0 ? distance : std::max({share * diameter(soup.vertices), single_precision * farthest, least});
    object.repairs = weld(soup, object.distance);
    object.shells = shells_of(soup);
    return object;
}

MeshShapes shapes_of(const MeshObject& object, const std::vector<GltfMaterial>& materials) {
    return ShapeMaking(object, materials).make();
}

std::vector<FreeSurface> inward_sheets(const TriangleShell& shell, const MeshObject& object,
                                       const std::vector<GltfMaterial>& materials) {
    std::vector<FreeSurface> sheets;
    for (const FlatFace& face : flat_faces(shell, {true, true, object.distance})) {
        const GltfMaterial& material = materials[static_cast<std::size_t>(face.label)];
        FreeSurface sheet;
        sheet.name = fmt::format("{} {}", object.name, sheets.size() + 1);
        sheet.region = reversed(region_of(shell.vertices, face));
        sheet.material = material.material.id;
        sheet.own_exitance = material.own_exitance;
        if (passes([&](ObjectFindings& checked) { check_region(checked, {}, sheet.region); }))
            sheets.push_back(std::move(sheet));
    }
    return sheets;
}

}  // namespace hanei
