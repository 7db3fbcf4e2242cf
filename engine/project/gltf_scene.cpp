#include "engine/project/gltf_scene.h"

#include "engine/project/luminaire_axes.h"
#include "engine/project/mesh_part.h"
#include "engine/project/mesh_room.h"
#include "engine/project/text_file.h"
#include "engine/project/tidy.h"
#include "engine/scene/colour.h"
#include "engine/scene/faces.h"
#include "engine/scene/placement.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

Vec3 middle_of(const TriangleShell& shell) {
    Vec3 sum{0.0};
    for (const Vec3& vertex : shell.vertices) sum += vertex;
    return sum / static_cast<double>(shell.vertices.size());
}

/// Whether the meshes still show the room that was written.
bool is_same_shape(const Room& a, const Room& b) {
    constexpr double single_precision = 1e-5;  // m
    if (a.plan.size() != b.plan.size()) return false;
    if (std::abs(a.floor_height - b.floor_height) > single_precision) return false;
    if (std::abs(a.height - b.height) > single_precision) return false;
    return std::all_of(a.plan.begin(), a.plan.end(), [&](const Vec2& corner) {
        return std::any_of(b.plan.begin(), b.plan.end(),
                           [&](const Vec2& other) { return glm::distance(corner, other) <= single_precision; });
    });
}

}  // namespace

GltfScene::GltfScene(GltfDocument& document, GltfKind kind, std::optional<Scene> own)
    : document_(document), kind_(kind) {
    if (!own) return;
    scene_ = std::move(*own);
    own_room_ = std::exchange(scene_.room, std::nullopt);
}

ObjectId GltfScene::material_in_scene(Material material) {
    for (const Material& known : scene_.materials)
        if (known.name == material.name && known.reflectance == material.reflectance && known.tint == material.tint)
            return known.id;
    material.id = scene_.new_id();
    scene_.materials.push_back(std::move(material));
    return scene_.materials.back().id;
}

int GltfScene::label_of(std::optional<std::size_t> material) {
    const auto [known, is_new] = labels_.try_emplace(material, static_cast<int>(materials_.size()));
    if (!is_new) return known->second;
    materials_.push_back(material ? read_gltf_material(document_, *material) : unstated_gltf_material());
    Material& reflecting = materials_.back().material;
    reflecting.id = material_in_scene(reflecting);
    return known->second;
}

ObjectId GltfScene::photometry_in_scene(Photometry photometry) {
    for (const Photometry& known : scene_.photometries) {
        photometry.id = known.id;
        if (known == photometry) return known.id;
    }
    photometry.id = scene_.new_id();
    scene_.photometries.push_back(std::move(photometry));
    return scene_.photometries.back().id;
}

void GltfScene::add(std::vector<GltfLight> lights) {
    for (GltfLight& light : lights) {
        Luminaire luminaire;
        luminaire.id = scene_.new_id();
        luminaire.name = light.luminaire.name;
        luminaire.position = tidy_place(light.position);
        aim(luminaire, light.nadir, light.plane_0);
        for (double* const angle : {&luminaire.yaw, &luminaire.tilt, &luminaire.roll}) *angle = tidy_angle(*angle);
        luminaire.opening = MeasuredOpening{};
        luminaire.output = AsMeasured{};
        luminaire.colour_temperature = stated_colour_temperature(light.luminaire.photometry).value_or(0.0);
        luminaire.distribution = Measured{photometry_in_scene(std::move(light.luminaire.photometry))};
        scene_.luminaires.push_back(std::move(luminaire));
    }
    for (const Luminaire& luminaire : scene_.luminaires) light_places_.push_back(luminaire.position);
}

void GltfScene::tell(const GltfObject& object, Severity severity, const std::string& sentence) {
    document_.reading().findings.push_back(about_file(severity, document_.reading().file, object.line, object.path,
                                                      fmt::format("\"{}\": {}", object.name, sentence)));
}

const TriangleShell* GltfScene::find_room(const std::vector<GltfObject>& objects) {
    std::vector<const TriangleShell*> shells;
    for (const GltfObject& object : objects)
        for (const MeshObject& mesh : object.meshes)
            for (const TriangleShell& shell : mesh.shells) {
                if (object.own.kind == "room" && shell.closed) return &shell;
                if (object.own.kind.empty()) shells.push_back(&shell);
            }
    if (kind_ == GltfKind::furniture) return nullptr;
    const auto found = room_among(shells, light_places_, kind_ == GltfKind::room);
    if (!found && kind_ == GltfKind::room)
        document_.reading().warn(document_.root(), "nodes",
                                 "no closed shell could be the room; its faces stand free as surfaces");
    return found ? shells[*found] : nullptr;
}

void GltfScene::add(const std::vector<GltfObject>& objects) {
    room_ = find_room(objects);
    for (const GltfObject& object : objects) {
        GltfObject rest = object;
        for (std::size_t m = 0; m < object.meshes.size(); ++m) {
            rest.meshes[m].shells.clear();
            for (const TriangleShell& shell : object.meshes[m].shells) {
                if (&shell == room_)
                    make_room(object, object.meshes[m], shell);
                else
                    rest.meshes[m].shells.push_back(shell);
            }
        }
        add_object(std::move(rest));
    }
}

void GltfScene::make_room(const GltfObject& object, const MeshObject& mesh, const TriangleShell& shell) {
    std::optional<Room> room = room_of(shell, mesh, materials_);
    if (room && own_room_ && object.own.kind == "room" && is_same_shape(*own_room_, *room)) {
        scene_.room = std::move(own_room_);
        return;
    }
    if (room) {
        room->id = scene_.new_id();
        tell(object, Severity::note,
             fmt::format("it is the room: a plan of {} corners, {:.4g} m high", room->plan.size(), room->height));
        scene_.room = std::move(room);
        return;
    }
    std::vector<FreeSurface> sheets = inward_sheets(shell, mesh, materials_);
    tell(object, Severity::note,
         fmt::format("it encloses the rest but is no plan extruded upright: its {} faces become surfaces that look "
                     "inward",
                     sheets.size()));
    for (FreeSurface& sheet : sheets) add_sheet(std::move(sheet));
}

void GltfScene::add_sheet(FreeSurface sheet) {
    sheet.id = scene_.new_id();
    scene_.surfaces.push_back(std::move(sheet));
}

void GltfScene::add_object(GltfObject object) {
    std::vector<MeshSolid> solids;
    for (MeshObject& mesh : object.meshes) {
        const std::size_t around = std::erase_if(mesh.shells, [&](const TriangleShell& shell) {
            return room_ != nullptr && shell.closed && shell.volume > room_->volume &&
                   winding_number(shell, middle_of(*room_)) > 0.5;
        });
        if (around > 0) tell(object, Severity::note, "what lies around the room is left out");
        if (mesh.shells.empty() && mesh.repairs.without_area == 0) continue;
        MeshShapes shapes = shapes_of(mesh, materials_);
        const bool own = !object.own.kind.empty();
        for (const auto& [severity, sentence] : shapes.remarks)
            if (!own) tell(object, severity, sentence);
        std::move(shapes.solids.begin(), shapes.solids.end(), std::back_inserter(solids));
        for (FreeSurface& sheet : shapes.sheets) {
            if (object.own.kind == "surface") sheet.own_exitance = object.own.own_exitance;
            add_sheet(std::move(sheet));
        }
    }
    if (!solids.empty()) add_furniture(object, std::move(solids));
}

void GltfScene::add_furniture(const GltfObject& object, std::vector<MeshSolid> solids) {
    Furniture furniture;
    furniture.id = scene_.new_id();
    furniture.name = object.name;
    furniture.rotation = tidy_angle(object.rotation);
    const Mat3 back = glm::transpose(placement(furniture).rotation);
    Vec3 low{HUGE_VAL}, high{-HUGE_VAL};
    for (MeshSolid& solid : solids)
        for (Vec3& vertex : solid.shape.vertices) {
            vertex = back * (vertex - object.origin);
            low = glm::min(low, vertex);
            high = glm::max(high, vertex);
        }
    const bool own = object.own.kind == "furniture";
    const Vec3 foot = own ? Vec3{0.0} : Vec3{0.5 * (low.x + high.x), 0.5 * (low.y + high.y), low.z};
    furniture.position = tidy_place(object.origin + placement(furniture).rotation * foot);
    for (MeshSolid& solid : solids) {
        for (Vec3& vertex : solid.shape.vertices) vertex -= foot;
        furniture.parts.push_back(part_of(std::move(solid.shape), solid.material));
    }
    scene_.furniture.push_back(std::move(furniture));
}

void GltfScene::finish(GltfImport& result) {
    for (const Furniture& furniture : scene_.furniture) result.solids += static_cast<int>(furniture.parts.size());
    result.sheets = static_cast<int>(scene_.surfaces.size());
    result.luminaires = static_cast<int>(scene_.luminaires.size());
    if (!scene_.room && result.solids + result.sheets + result.luminaires == 0) {
        document_.reading().error(document_.root(), "nodes", "the scene shows no triangles and no lights");
        return;
    }
    constexpr std::size_t many = 5000;
    const std::size_t faces = faces_of(scene_).size();
    if (faces > many)
        document_.reading().warn(document_.root(), "meshes",
                                 fmt::format("its {} faces make {} patches at least, and the study slow; simplify the "
                                             "model if you can",
                                             faces, faces));
    result.scene = std::move(scene_);
}

}  // namespace hanei
