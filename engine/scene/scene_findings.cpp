#include "engine/scene/scene_findings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace hanei {

std::string figure(double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 6);
    return {digits.data(), end.ptr};
}

ObjectFindings::ObjectFindings(Diagnostics& findings, std::string field, std::string_view kind, std::string_view name,
                               ObjectId id)
    : findings_(findings), field_(std::move(field)), title_(kind), id_(id) {
    if (!name.empty()) title_.append(" \"").append(name).append("\"");
}

void ObjectFindings::add(Severity severity, std::string_view field, const std::string& message) {
    std::string path = field_;
    if (!path.empty() && !field.empty()) path += '.';
    path += field;
    Diagnostic finding;
    finding.severity = severity;
    finding.place.field = std::move(path);
    finding.place.object = id_.value;
    finding.message = title_;
    finding.message.append(": ").append(message);
    findings_.push_back(std::move(finding));
}

bool ObjectFindings::finite(std::string_view field, std::initializer_list<double> figures) {
    const bool good = std::all_of(figures.begin(), figures.end(), [](double value) { return std::isfinite(value); });
    if (!good) error(field, "the figure is infinite or no number; give a finite one");
    return good;
}

bool ObjectFindings::finite(std::string_view field, const std::vector<Vec3>& places) {
    return std::all_of(places.begin(), places.end(), [&](const Vec3& place) { return finite(field, place); });
}

bool ObjectFindings::within(std::string_view field, double value, double low, double high) {
    if (!finite(field, {value})) return false;
    if (value >= low && value <= high) return true;
    error(field, "found " + figure(value) + ", allowed are " + figure(low) + " to " + figure(high));
    return false;
}

bool ObjectFindings::positive(std::string_view field, double value) {
    if (!finite(field, {value})) return false;
    if (value > 0.0) return true;
    error(field, "found " + figure(value) + ", it must be greater than 0");
    return false;
}

ObjectFindings SceneChecks::about(std::string_view list, std::size_t index, std::string_view kind,
                                  std::string_view name, ObjectId id) {
    const std::string number = std::to_string(index);
    return {findings, std::string(list) + '[' + number + ']',
            name.empty() ? std::string(kind) + ' ' + number : std::string(kind), name, id};
}

void SceneChecks::check_id(ObjectFindings& object, ObjectId id) {
    if (!id)
        object.error("id", "the object has no id; give it one with Scene::new_id");
    else if (!ids.insert(id).second)
        object.error("id", "the id " + std::to_string(id.value) + " is given twice; every object needs its own");
    else if (id.value > scene.last_id)
        object.error("id", "the id " + std::to_string(id.value) + " is above the greatest ever given, " +
                               std::to_string(scene.last_id));
}

void SceneChecks::check_material(ObjectFindings& object, std::string_view field, ObjectId material) {
    const bool known = std::any_of(scene.materials.begin(), scene.materials.end(),
                                   [&](const Material& candidate) { return candidate.id == material; });
    if (!known)
        object.error(field, material ? "there is no material with the id " + std::to_string(material.value) +
                                           "; choose one of the scene's"
                                     : "it has no material; choose one of the scene's");
}

}  // namespace hanei
