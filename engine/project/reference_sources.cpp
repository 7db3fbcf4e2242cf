#include "engine/geometry/polygon.h"
#include "engine/project/luminaire_axes.h"
#include "engine/project/luminaire_file.h"
#include "engine/project/reference_reader.h"
#include "engine/scene/faces.h"
#include "engine/scene/placement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei {
namespace {

constexpr Vec3 down{0.0, 0.0, -1.0};

/// The case counts C clockwise seen from above (C90 = nadir x C0), the house counter-clockwise.
Photometry mirrored(std::vector<double> c_deg, std::vector<std::vector<double>> candela) {
    std::vector<std::pair<double, std::size_t>> planes;
    for (std::size_t i = 0; i < c_deg.size(); ++i) planes.emplace_back(c_deg[i] == 0.0 ? 0.0 : 360.0 - c_deg[i], i);
    std::sort(planes.begin(), planes.end());
    Photometry photometry;
    for (const auto& [angle, plane] : planes) {
        photometry.horizontal_deg.push_back(angle);
        photometry.candela.insert(photometry.candela.end(), candela[plane].begin(), candela[plane].end());
    }
    photometry.absolute = true;
    return photometry;
}

void read_table(ReferenceScene& target, Fields& fields, Luminaire& luminaire) {
    std::vector<double> c_deg;
    std::vector<double> gamma_deg;
    std::vector<std::vector<double>> candela;
    Vec3 nadir = down;
    Vec3 c0{1.0, 0.0, 0.0};
    fields.require("C_deg", c_deg, "angles");
    fields.require("gamma_deg", gamma_deg, "angles");
    fields.require("cd", candela, "a list of candela values a plane");
    fields.optional("gamma0_axis", nadir);
    fields.optional("C0_axis", c0);
    const bool whole = candela.size() == c_deg.size() &&
                       std::all_of(candela.begin(), candela.end(),
                                   [&](const auto& plane) { return plane.size() == gamma_deg.size(); });
    if (!whole) return fields.error("cd", "the table has not one value for every pair of angles");
    Photometry photometry = mirrored(std::move(c_deg), std::move(candela));
    photometry.id = target.scene.new_id();
    photometry.name = luminaire.name;
    photometry.vertical_deg = std::move(gamma_deg);
    aim(luminaire, nadir, c0);
    luminaire.distribution = Measured{photometry.id};
    luminaire.output = AsMeasured{};
    target.scene.photometries.push_back(std::move(photometry));
}

void read_point(ReferenceScene& target, Fields& fields, Luminaire& luminaire) {
    fields.require("position", luminaire.position, "three numbers [x, y, z]");
    luminaire.opening = PointOpening{};
    const JsonValue* const value = fields.take("distribution");
    if (value == nullptr) return fields.missing("distribution", "an object");
    Fields distribution(fields.reading(), *value, fields.path_of("distribution"));
    std::string kind;
    distribution.require("kind", kind, "a text");
    if (kind == "table") return read_table(target, distribution, luminaire);
    LuminousFlux flux;
    distribution.require("flux_lm", flux.value, "lumens");
    luminaire.output = flux;
    if (kind == "cos_power") {
        CosinePower power;
        Vec3 axis = down;
        distribution.require("exponent", power.exponent, "a number");
        distribution.optional("axis", axis);
        aim(luminaire, axis, any_c0(axis));
        luminaire.distribution = power;
    } else if (kind != "isotropic") {
        target.unsupported = "point sources with the distribution \"" + kind + "\" are not supported";
    }
}

void read_line(Fields& fields, Luminaire& luminaire) {
    LineOpening line;
    double normal_intensity = 0.0;
    fields.require("from", line.from, "three numbers [x, y, z]");
    fields.require("to", line.to, "three numbers [x, y, z]");
    fields.require("normal_intensity_per_metre_cd_m", normal_intensity, "candela a metre");
    luminaire.opening = line;
    // the integral of I1 sin(a) over all directions is pi^2 I1 a metre
    luminaire.output =
        LuminousFlux{std::numbers::pi * std::numbers::pi * normal_intensity * glm::distance(line.from, line.to)};
}

void read_area(Fields& fields, Luminaire& luminaire) {
    Luminance luminance;
    fields.require("luminance_cd_m2", luminance.value, "cd/m2");
    luminaire.opening = PolygonOpening{take_reference_region(fields)};
    luminaire.output = luminance;
    luminaire.opaque = fields.has("reflectance");  // a source that reflects something, if little, is a body
}

void read_polyhedron(Fields& fields, Luminaire& luminaire) {
    PolyhedronOpening solid;
    double brightest = 0.0;
    for_each_object(fields, "faces", [&](Fields& face, std::size_t) {
        Polygon corners;
        double luminance = 0.0;
        face.require("vertices", corners, "points [x, y, z]");
        face.require("luminance_cd_m2", luminance, "cd/m2");
        std::vector<int>& loop = solid.faces.emplace_back();
        for (const Vec3& corner : corners) {
            const auto known = std::find(solid.vertices.begin(), solid.vertices.end(), corner);
            loop.push_back(static_cast<int>(known - solid.vertices.begin()));
            if (known == solid.vertices.end()) solid.vertices.push_back(corner);
        }
        solid.relative_luminance.push_back(luminance);
        brightest = std::max(brightest, luminance);
    });
    for (double& weight : solid.relative_luminance) weight = brightest > 0.0 ? weight / brightest : 0.0;
    luminaire.opening = std::move(solid);
    luminaire.output = Luminance{brightest};
}

ObjectId photometry_of(ReferenceScene& target, Fields& fields) {
    std::string name;
    fields.require("file", name, "the name of a luminaire file beside the case");
    const auto [place, is_new] = target.photometries.emplace(name, ObjectId{});
    if (!is_new) return place->second;
    LuminaireFileRead read = read_luminaire_file(target.folder / name);
    Diagnostics& findings = target.reading.findings;
    findings.insert(findings.end(), read.findings.begin(), read.findings.end());
    if (!read.photometry.has_value()) {
        fields.error("file", "the luminaire file " + json_quoted(name) + " cannot be used");
        return {};
    }
    place->second = target.scene.new_id();
    read.photometry->id = place->second;
    target.scene.photometries.push_back(std::move(*read.photometry));
    return place->second;
}

/// The polygon stays in room coordinates, so that they keep their bits, unless the frame is turned.
void read_photometric_area(ReferenceScene& target, Fields& fields, Luminaire& luminaire) {
    LuminousFlux flux;
    Vec3 nadir = down;
    Vec3 c0{1.0, 0.0, 0.0};
    Region region = take_reference_region(fields);
    fields.require("flux_lm", flux.value, "lumens");
    fields.optional("aim", nadir);
    fields.optional("c0", c0);
    aim(luminaire, nadir, c0);
    const Mat3 to_local = glm::transpose(placement(luminaire).rotation);
    const auto turn = [&](Polygon& polygon) {
        for (Vec3& corner : polygon) corner = to_local * corner;
    };
    turn(region.outline);
    std::for_each(region.holes.begin(), region.holes.end(), turn);
    luminaire.opening = PolygonOpening{std::move(region)};
    luminaire.distribution = Measured{photometry_of(target, fields)};
    luminaire.output = flux;
}

/// Only a beam that lights one surface, unshadowed: the surface shines as if by itself.
void read_beam(ReferenceScene& target, Fields& fields) {
    std::string lit;
    if (!fields.optional("lights_only", lit)) {
        target.unsupported = "parallel beams are supported only where they light a single surface";
        return;
    }
    FreeSurface* const surface = find_surface(target.scene, lit);
    if (surface == nullptr) return fields.error("lights_only", "there is no surface " + json_quoted(lit));
    Vec3 direction = down;
    double normal_illuminance = 0.0;
    fields.require("direction", direction, "three numbers [x, y, z]");
    fields.require("normal_illuminance_lx", normal_illuminance, "lux");
    const double cosine = std::max(0.0, -glm::dot(glm::normalize(direction), unit_normal(surface->region.outline)));
    const Material* const material = find_material(target.scene, surface->material);
    surface->own_exitance += reflected({normal_illuminance * cosine}, material->reflectance);
}

}  // namespace

void read_reference_sources(ReferenceScene& target, Fields& scene) {
    for_each_object(scene, "sources", [&](Fields& fields, std::size_t) {
        Luminaire luminaire;
        std::string type;
        fields.optional("id", luminaire.name);
        fields.require("type", type, "a text");
        if (type == "parallel_beam") return read_beam(target, fields);
        luminaire.id = target.scene.new_id();
        if (type == "point") {
            read_point(target, fields, luminaire);
        } else if (type == "line") {
            read_line(fields, luminaire);
        } else if (type == "area") {
            read_area(fields, luminaire);
        } else if (type == "polyhedron") {
            read_polyhedron(fields, luminaire);
        } else if (type == "photometric_area") {
            read_photometric_area(target, fields, luminaire);
        } else {
            target.unsupported = "sources of the type \"" + type + "\" are not supported";
            return;
        }
        fields.optional("opaque", luminaire.opaque);
        target.scene.luminaires.push_back(std::move(luminaire));
    });
}

}  // namespace hanei
