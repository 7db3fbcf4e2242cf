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

}  // namespace

GltfScene::GltfScene(GltfDocument& document, GltfKind kind, std::optional<Scene> own)
    : document_(document), kind_(kind) {
    if (!own) return;
    scene_ = std::move(*own);
    own_.emplace(document_, scene_,
                 [this](int label) -> const GltfMaterial& { return materials_[static_cast<std::size_t>(label)]; });
}

ObjectId GltfScene::material_in_scene(Material material) {
    for (const Material& known : scene_.materials)
        if (known.name == material.name && known.reflectance == material.reflectance && known.tint == material.tint)
            return known.id;
    material.id = scene_.new_id();
    scene_.materials.push_back(std::move(material));
    return scene_.materials.back().id;
}

/// The material that was written, in the colour it has in the file now; none when it is not that one.
ObjectId GltfScene::own_material(const Material& material) {
    const auto written = std::find_if(scene_.materials.begin(), scene_.materials.end(),
                                      [&](const Material& known) { return own_ && known.id == material.id; });
    if (!material.id || written == scene_.materials.end()) return {};
    const bool same = written->reflectance == material.reflectance && written->tint == material.tint;
    if (same || !repainted_.insert(written->id).second) return same ? written->id : ObjectId{};
    written->reflectance = material.reflectance;
    written->tint = material.tint;
    return written->id;
}

int GltfScene::label_of(std::optional<std::size_t> material) {
    const auto [known, is_new] = labels_.try_emplace(material, static_cast<int>(materials_.size()));
    if (!is_new) return known->second;
    materials_.push_back(material ? read_gltf_material(document_, *material) : unstated_gltf_material());
    Material& reflecting = materials_.back().material;
    const ObjectId written = own_material(reflecting);
    reflecting.id = written ? written : material_in_scene(reflecting);
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
    std::vector<const GltfObject*> rest;
    if (own_)
        rest = own_->rest_of(objects);
    else
        for (const GltfObject& object : objects) rest.push_back(&object);
    room_ = find_room(objects);
    for (const GltfObject* const object : rest) add_read(*object);
    if (own_) own_->finish();
}

void GltfScene::add_read(const GltfObject& object) {
    of_object_.clear();
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
    group(object);
}

void GltfScene::make_room(const GltfObject& object, const MeshObject& mesh, const TriangleShell& shell) {
    std::optional<Room> room = room_of(shell, mesh, materials_);
    if (room) {
        tell(object, Severity::note,
             fmt::format("it is the room: a plan of {} corners, {:.4g} m high", room->plan.size(), room->height));
        Room* const written = own_ ? own_->room_of(object) : nullptr;
        room->id = written == nullptr ? scene_.new_id() : written->id;
        if (written != nullptr) room->unknown = written->unknown;
        scene_.room = std::move(room);
        return;
    }
    std::vector<FreeSurface> sheets = inward_sheets(shell, mesh, materials_);
    tell(object, Severity::note,
         fmt::format("it encloses the rest but is no plan extruded upright: its {} faces become surfaces that look "
                     "inward",
                     sheets.size()));
    for (FreeSurface& sheet : sheets) add_sheet(object, std::move(sheet));
}

void GltfScene::add_sheet(const GltfObject& object, FreeSurface sheet) {
    if (FreeSurface* const written = own_ ? own_->surface_of(object) : nullptr) {
        sheet.id = written->id;
        sheet.name = written->name;
        sheet.unknown = written->unknown;
        *written = std::move(sheet);
        of_object_.push_back(written->id);
        return;
    }
    sheet.id = scene_.new_id();
    of_object_.push_back(sheet.id);
    scene_.surfaces.push_back(std::move(sheet));
}

/// What came of one node stays together: in a group of its name, or in that the exporter's object is in.
void GltfScene::group(const GltfObject& object) {
    if (of_object_.size() < 2) return;
    for (ObjectGroup& known : scene_.object_groups)
        if (std::find(known.members.begin(), known.members.end(), of_object_[0]) != known.members.end()) {
            known.members.insert(known.members.end(), of_object_.begin() + 1, of_object_.end());
            return;
        }
    scene_.object_groups.push_back({scene_.new_id(), object.name, of_object_, {}});
}

void GltfScene::add_object(GltfObject object) {
    std::vector<MeshSolid> solids;
    std::vector<FreeSurface> sheets;
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
        std::move(shapes.sheets.begin(), shapes.sheets.end(), std::back_inserter(sheets));
    }
    if (!solids.empty()) add_furniture(object, std::move(solids));
    for (FreeSurface& sheet : sheets) add_sheet(object, std::move(sheet));
}

void GltfScene::add_furniture(const GltfObject& object, std::vector<MeshSolid> solids) {
    Furniture furniture;
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
    Furniture* const written = own_ ? own_->furniture_of(object) : nullptr;
    furniture.id = written == nullptr ? scene_.new_id() : written->id;
    of_object_.push_back(furniture.id);
    if (written == nullptr) {
        scene_.furniture.push_back(std::move(furniture));
        return;
    }
    furniture.name = written->name;
    furniture.unknown = written->unknown;
    *written = std::move(furniture);
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
