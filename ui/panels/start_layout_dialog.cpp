#include "ui/panels/start_layout_dialog.h"

#include "engine/edit/arrangements.h"
#include "engine/edit/luminaire_edits.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

constexpr const char* title = "Start layout";

/// What a list calls the light of a luminaire: its file's name, or its own.
std::string light_name(const Scene& scene, const Luminaire& luminaire) {
    const Photometry* const photometry = photometry_of(scene, luminaire);
    if (!photometry) return luminaire.name;
    return photometry->name.empty() ? photometry->source_file : photometry->name;
}

bool dialog_button(const char* label, const char* name, bool possible, WidgetRegistry& widgets) {
    if (!possible) ImGui::BeginDisabled();
    const bool pressed = ImGui::Button(tr(label), {130.0F * style::scale(), 0.0F});
    if (!possible) ImGui::EndDisabled();
    widgets.note(name);
    return pressed && possible;
}

}  // namespace

void StartLayoutDialog::open(ObjectId luminaire) {
    if (luminaire != luminaire_) is_other_ = true;
    luminaire_ = luminaire;
    open_ = opening_ = true;
}

/// A field that was laid out here comes back with the figures it was made from, and so does a luminaire that
/// was asked about last; columns and rows by hand are nobody else's.
void StartLayoutDialog::recall(const Scene& scene) {
    const Arrangement* const field = arrangement_of(scene, luminaire_);
    if (made_ && field && field->id == made_->arrangement) {
        if (is_other_) wish_ = made_->wish;
    } else if (is_other_) {
        wish_.columns.reset();
        wish_.rows.reset();
    }
    is_other_ = false;
}

/// One luminaire of each kind of light in the scene.
std::vector<ObjectId> StartLayoutDialog::offered(const Scene& scene) const {
    std::vector<ObjectId> list;
    std::vector<const Photometry*> seen;
    for (const Luminaire& luminaire : scene.luminaires) {
        const Photometry* const photometry = photometry_of(scene, luminaire);
        const bool again = photometry && std::find(seen.begin(), seen.end(), photometry) != seen.end();
        if (photometry) seen.push_back(photometry);
        if (!again || luminaire.id == luminaire_) list.push_back(luminaire.id);
    }
    return list;
}

void StartLayoutDialog::answer_anew(const Scene& scene) {
    const Luminaire* const luminaire = find_luminaire(scene, luminaire_);
    answer_ = {};
    if (luminaire)
        answer_ = lumen_method(scene, *luminaire, wish_);
    else
        answer_.refusal = "Choose a luminaire first.";
}

bool StartLayoutDialog::rows(const Scene& scene, Form& form) {
    bool changed =
        form.number({"layout.target", "Illuminance", "lx", "Mean over the working plane, maintained", 1.0, 1e5, 5.0, 0},
                    wish_.target);
    const std::vector<ObjectId> luminaires = offered(scene);
    std::vector<std::string> names;
    for (const ObjectId id : luminaires) names.push_back(light_name(scene, *find_luminaire(scene, id)));
    int chosen = static_cast<int>(std::find(luminaires.begin(), luminaires.end(), luminaire_) - luminaires.begin());
    if (form.choice("layout.luminaire", "Luminaire", "Which light the field is of", names, chosen)) {
        luminaire_ = luminaires[static_cast<std::size_t>(chosen)];
        changed = true;
    }
    constexpr Mounting at_ceiling[] = {Mounting::recessed, Mounting::surface, Mounting::pendant};
    std::vector<std::string> ways;
    for (const Mounting mounting : at_ceiling) ways.emplace_back(tr(name_of(mounting)));
    int way = std::min(2, static_cast<int>(wish_.mounting.mounting));
    if (form.choice("layout.mounting", "Held", "How they hang", ways, way)) {
        wish_.mounting.mounting = at_ceiling[way];
        changed = true;
    }
    if (wish_.mounting.mounting == Mounting::pendant)
        changed |= form.number(
            {"layout.suspension", "Suspension", "m", "From the ceiling to the top of the opening", 0.0, 100.0, 0.01, 2},
            wish_.mounting.suspension);
    changed |= form.number(
        {"layout.plane", "Working plane", "m", "Height above the floor: 0.75 m for desks", 0.0, 100.0, 0.01, 2},
        wish_.working_plane);
    changed |=
        form.number({"layout.border", "Border", "m",
                     "What the working plane leaves out along the walls (EN 12464-1: 0.5 m)", 0.0, 100.0, 0.01, 2},
                    wish_.border);
    bool by_hand = wish_.columns.has_value();
    if (form.toggle("layout.by_hand", "By hand", "Columns and rows by hand instead of as many as it needs", by_hand)) {
        wish_.columns = by_hand ? std::optional(std::max(1, answer_.columns)) : std::nullopt;
        wish_.rows = by_hand ? std::optional(std::max(1, answer_.rows)) : std::nullopt;
        changed = true;
    }
    const auto count = [&](const char* name, const char* label, std::optional<int>& value) {
        double shown = value.value_or(1);
        if (!form.number({name, label, "", "Luminaires in it", 1.0, 100.0, 0.05, 0}, shown)) return;
        value = static_cast<int>(std::lround(shown));
        changed = true;
    };
    if (by_hand) {
        count("layout.columns", "Columns", wish_.columns);
        count("layout.rows", "Rows", wish_.rows);
    }
    return changed;
}

void StartLayoutDialog::figures(const Scene& scene, Form& form) const {
    if (!answer_.refusal.empty()) return form.remark(answer_.refusal, true);
    form.heading("Lumen method");
    form.fact("Luminaires", fmt::format("{} in {} x {}", answer_.count(), answer_.columns, answer_.rows));
    form.fact("Predicted", fmt::format("{:.0f}", answer_.mean), "lx");
    form.fact("Utilization", fmt::format("{:.2f}  (room index {:.2f})", answer_.utilization, answer_.room_index));
    form.fact("Maintenance", fmt::format("{:.2f}", scene.maintenance_factor));
    if (answer_.watts > 0.0)
        form.fact("Power", fmt::format("{:.0f} W, {:.1f} W/m²", answer_.watts, answer_.watts_per_m2));
    form.fact("Spacing", fmt::format("{:.2f} of the height, up to {:.2f} is even", answer_.spacing_to_height,
                                     answer_.spacing_limit));
    if (answer_.spacing_to_height > answer_.spacing_limit)
        form.remark("They hang far apart for this light: it will be darker between them.", true);
    if (wish_.columns && answer_.mean < 0.95 * wish_.target)
        form.remark("These are too few for the illuminance.", true);
}

std::optional<Added> StartLayoutDialog::draw(const Scene& scene, Form& form) {
    WidgetRegistry& widgets = form.widgets();
    if (!open_) return std::nullopt;
    const std::string label = fmt::format("{}###startlayout", tr(title));
    if (opening_) {
        ImGui::OpenPopup(label.c_str());
        if (!find_luminaire(scene, luminaire_) && !scene.luminaires.empty()) luminaire_ = scene.luminaires.front().id;
        recall(scene);
        answer_anew(scene);
    }
    opening_ = false;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * screen.x, 0.5F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({std::min(400.0F * style::scale(), screen.x - 40.0F), 0.0F});
    bool stay = true;
    if (!ImGui::BeginPopupModal(label.c_str(), &stay, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
        open_ = false;
        return std::nullopt;
    }
    std::optional<Added> made;
    form.begin("layout");
    if (rows(scene, form)) answer_anew(scene);
    figures(scene, form);
    form.end();
    ImGui::Dummy({0.0F, 4.0F * style::scale()});
    const bool good = answer_.refusal.empty();
    const bool hang = dialog_button("Hang them", "layout.hang", good, widgets);
    ImGui::SameLine();
    const bool leave = dialog_button("Cancel", "layout.cancel", true, widgets) ||
                       ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
    if (hang) {
        made = with_start_layout(scene, luminaire_, wish_, answer_);
        made_ = Made{made->object, wish_, answer_.mean};
    }
    if (hang || leave || !stay) {
        open_ = false;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
    return made;
}

StartLayoutDialog::Correction StartLayoutDialog::compare(const Scene& scene, const SolutionSnapshot& answer,
                                                         Form& form) {
    Correction correction;
    const Arrangement* const field = made_ ? find_arrangement(scene, made_->arrangement) : nullptr;
    const ObjectId plane = working_plane_of(scene);
    if (!field || !plane) return correction;
    form.heading("Start layout");
    form.fact("Wanted", fmt::format("{:.0f}", made_->wish.target), "lx");
    form.fact("Predicted", fmt::format("{:.0f}", made_->predicted), "lx");
    const GridResult* computed = nullptr;
    if (answer && *answer->scene == scene)
        for (const GridResult& grid : answer->grids)
            if (grid.grid == plane) computed = &grid;
    if (!computed) {
        form.fact("Computed", "...");
        return correction;
    }
    const double mean = figures_of(*computed).mean;
    form.fact("Computed", fmt::format("{:.0f}", mean), "lx");
    constexpr double as_wanted = 0.01;
    if (!(mean > 0.0) || std::abs(mean / made_->wish.target - 1.0) < as_wanted) return correction;
    if (mean > made_->wish.target &&
        form.button("layout.dim", "Dim to what is wanted", "All luminaires of the field by one factor")) {
        correction = {with_output_scaled(scene, field->id, made_->wish.target / mean), "Dim start layout"};
        return correction;
    }
    if (!form.button("layout.recount", "Another number", "As many as are needed by what was computed"))
        return correction;
    // the method is off by a factor in this room: it aims as much beside
    LumenWish wish = made_->wish;
    wish.columns.reset();
    wish.rows.reset();
    wish.target *= made_->predicted / mean;
    const auto member = std::find_if(field->luminaires.begin(), field->luminaires.end(),
                                     [](ObjectId id) { return static_cast<bool>(id); });
    const Luminaire* const luminaire = find_luminaire(scene, *member);
    const LumenAnswer anew = lumen_method(scene, *luminaire, wish);
    if (!anew.refusal.empty()) return correction;
    made_->predicted = anew.mean * mean / made_->predicted;
    correction = {with_start_layout(scene, *member, wish, anew).scene, "Change number of luminaires"};
    return correction;
}

}  // namespace hanei
