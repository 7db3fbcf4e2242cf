#include "engine/project/reference_case.h"

#include "engine/project/json_text.h"
#include "engine/project/reference_reader.h"
#include "engine/project/text_file.h"
#include "engine/scene/scene_check.h"

#include <algorithm>

namespace hanei {
namespace {

void take_grades(Fields& fields, ReferenceGrade& top, ReferenceGrade& pass) {
    fields.optional("tol_top_rel", top.relative);
    fields.optional("tol_pass_rel", pass.relative);
    fields.optional("tol_top_abs_lx", top.absolute);
    fields.optional("tol_pass_abs_lx", pass.absolute);
}

void read_points(ReferenceCase& target, Fields& parent) {
    for_each_object(parent, "measure", [&](Fields& fields, std::size_t) {
        ReferencePoint point;
        fields.require("id", point.id, "a text");
        fields.optional("set", point.set);
        fields.require("position", point.position, "three numbers [x, y, z]");
        fields.require("normal", point.normal, "three numbers [x, y, z]");
        fields.require("expected_lx", point.expected, "lux");
        fields.optional("uncertainty_lx", point.uncertainty);
        take_grades(fields, point.top, point.pass);
        target.points.push_back(std::move(point));
    });
}

void read_form_factors(ReferenceCase& target, Fields& parent) {
    for_each_object(parent, "form_factors", [&](Fields& fields, std::size_t) {
        ReferenceFormFactor factor;
        double reverse = 0.0;
        fields.require("id", factor.id, "a text");
        fields.require("from", factor.from.outline, "points [x, y, z]");
        fields.require("to", factor.to.outline, "points [x, y, z]");
        fields.require("expected", factor.expected, "a number from 0 to 1");
        if (fields.optional("reverse", reverse)) factor.reverse = reverse;
        fields.optional("uncertainty", factor.uncertainty);
        take_grades(fields, factor.top, factor.pass);
        target.form_factors.push_back(std::move(factor));
    });
}

/// The tolerances of a case with a single class of them: what applies to values that carry none.
ReferenceMean graded_by_case(Fields& root) {
    ReferenceMean mean;
    const JsonValue* const classes = root.take("tolerance");
    if (classes == nullptr || classes->items.size() != 1 || !classes->is(JsonValue::Kind::object)) return mean;
    Fields fields(root.reading(), classes->items[0], root.path_of("tolerance") + '.' + classes->keys[0]);
    fields.optional("top_class_rel", mean.top.relative);
    fields.optional("pass_rel", mean.pass.relative);
    return mean;
}

/// Means by surface: `key` holds an object with a member a surface, `figure` is the illuminance.
void read_means(ReferenceCase& target, Fields& parent, std::string_view key, std::string_view figure,
                const ReferenceMean& start) {
    const JsonValue* const surfaces = parent.take(key);
    if (surfaces == nullptr) return;
    const Fields check(parent.reading(), *surfaces, parent.path_of(key));
    for (std::size_t i = 0; i < surfaces->keys.size(); ++i) {
        Fields fields(parent.reading(), surfaces->items[i], check.path_of(surfaces->keys[i]));
        const FreeSurface* const surface = find_surface(target.scene, surfaces->keys[i]);
        if (surface == nullptr) {
            parent.error(key, "there is no surface " + json_quoted(surfaces->keys[i]));
            continue;
        }
        ReferenceMean mean = start;
        mean.surface = surface->id;
        mean.name = surface->name;
        fields.require(figure, mean.expected, "lux");
        fields.optional("uncertainty_lx", mean.uncertainty);
        take_grades(fields, mean.top, mean.pass);
        target.means.push_back(std::move(mean));
    }
}

/// The mean over all surfaces together.
void read_whole_mean(ReferenceCase& target, Fields& variant) {
    const JsonValue* const value = variant.take("expected");
    if (value == nullptr) return;
    Fields fields(variant.reading(), *value, variant.path_of("expected"));
    ReferenceMean mean;
    double share = 0.0;
    mean.name = "all surfaces";
    fields.require("average_total_lx", mean.expected, "lux");
    fields.optional("uncertainty_rel", share);
    mean.uncertainty = share * mean.expected;
    take_grades(fields, mean.top, mean.pass);
    target.means.push_back(std::move(mean));
}

void override_reflectances(ReferenceScene& built, Fields& variant) {
    double all = 0.0;
    if (variant.optional("reflectance_all", all))
        for (FreeSurface& surface : built.scene.surfaces) surface.material = built.material(all);
    const JsonValue* const by_surface = variant.take("reflectance");
    if (by_surface == nullptr) return;
    for (std::size_t i = 0; i < by_surface->keys.size(); ++i) {
        FreeSurface* const surface = find_surface(built.scene, by_surface->keys[i]);
        double reflectance = 0.0;
        const std::string path = variant.path_of("reflectance") + '.' + by_surface->keys[i];
        if (!take_value(variant.reading(), by_surface->items[i], path, reflectance)) continue;
        if (surface == nullptr)
            variant.error("reflectance", "there is no surface " + json_quoted(by_surface->keys[i]));
        else
            surface->material = built.material(reflectance);
    }
}

std::string variant_name(Fields& variant, std::size_t index) {
    std::string name;
    if (variant.optional("name", name)) return name;
    const JsonValue* const all = variant.take("reflectance_all");
    return all != nullptr ? "rho=" + one_line(*all) : "variant " + std::to_string(index + 1);
}

void read_variants(ReferenceRead& read, const ReferenceCase& whole, const ReferenceScene& built, Fields& root) {
    for_each_object(root, "variants", [&](Fields& variant, std::size_t index) {
        ReferenceCase target = whole;
        ReferenceScene scene = built;
        target.id += ' ' + variant_name(variant, index);
        if (variant.has("opening_vertices") && target.unsupported.empty())
            target.unsupported = "variants with openings of their own are not supported";
        if (target.unsupported.empty()) {
            override_reflectances(scene, variant);
            target.scene = std::move(scene.scene);
            read_points(target, variant);
            read_means(target, variant, "surface_average", "total_lx", {});
            read_whole_mean(target, variant);
        }
        read.cases.push_back(std::move(target));
    });
}

ReferenceScene read_scene(JsonReading& reading, Fields& root, const std::filesystem::path& folder) {
    ReferenceScene built{reading, folder, {}, {}, {}, {}};
    const JsonValue* const value = root.take("scene");
    if (value == nullptr) {
        root.missing("scene", "an object with \"surfaces\" and \"sources\"");
        return built;
    }
    Fields fields(reading, *value, "scene");
    if (fields.has("sky"))
        built.unsupported = "light from the sky is not simulated";
    else if (fields.has("ground"))
        built.unsupported = "light from the ground outside is not simulated";
    else {
        read_reference_surfaces(built, fields);
        read_reference_sources(built, fields);
    }
    return built;
}

void read_case(ReferenceRead& read, Fields& root, const std::filesystem::path& folder) {
    ReferenceCase whole;
    root.require("id", whole.id, "a text");
    root.require("category", whole.category, "a text");
    root.optional("title", whole.title);
    ReferenceScene built = read_scene(root.reading(), root, folder);
    built.scene.title = whole.title;
    whole.scene = built.scene;
    whole.unsupported = built.unsupported;
    if (root.has("variants")) return read_variants(read, whole, built, root);
    if (whole.unsupported.empty()) {
        read_points(whole, root);
        read_form_factors(whole, root);
        read_means(whole, root, "surface_expected", "average_illuminance_lx", graded_by_case(root));
    }
    read.cases.push_back(std::move(whole));
}

/// What keeps a case from being computed. Variants share their faults: each is told once.
void check_scenes(ReferenceRead& read, JsonReading& reading) {
    Diagnostics faults;
    for (const ReferenceCase& target : read.cases) {
        if (!target.unsupported.empty()) continue;
        for (Diagnostic& finding : check_scene(target.scene)) {
            finding.place.file = reading.file;
            const bool told = std::find(faults.begin(), faults.end(), finding) != faults.end();
            if (finding.severity == Severity::error && !told) faults.push_back(std::move(finding));
        }
    }
    reading.findings.insert(reading.findings.end(), faults.begin(), faults.end());
}

}  // namespace

ReferenceRead read_reference(const std::filesystem::path& file) {
    Diagnostics findings;
    const std::optional<std::string> text = read_text_file(file, findings);
    if (!text.has_value()) return {{}, std::move(findings)};
    return read_reference_text(*text, file);
}

ReferenceRead read_reference_text(std::string_view json, const std::filesystem::path& file) {
    ReferenceRead read;
    JsonReading reading{file.string(), {}};
    const std::optional<JsonValue> root = parse_json(json, reading.file, reading.findings);
    if (root.has_value()) {
        Fields fields(reading, *root, "");
        const JsonValue* const schema = fields.take("schema");
        if (schema == nullptr || schema->text != "hanei-reference/1")
            fields.error("schema", "this is no reference case: the field must be \"hanei-reference/1\"");
        else
            read_case(read, fields, file.parent_path());
    }
    if (!has_errors(reading.findings)) check_scenes(read, reading);
    if (has_errors(reading.findings)) read.cases.clear();
    read.findings = std::move(reading.findings);
    return read;
}

std::vector<std::filesystem::path> reference_files(const std::filesystem::path& path) {
    if (!std::filesystem::is_directory(path)) return {path};
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
        const std::filesystem::path& file = entry.path();
        if (entry.is_regular_file() && file.extension() == ".json" && file.filename() != "index.json")
            files.push_back(file);
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace hanei
