#include "ui/panels/effects_panel.h"

#include "ui/panels/background_work.h"
#include "ui/panels/elided.h"
#include "ui/panels/form.h"
#include "ui/panels/icon.h"
#include "ui/panels/illuminance_text.h"
#include "ui/panels/language.h"
#include "ui/panels/probe.h"
#include "ui/panels/table_cells.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace hanei {
namespace {

std::string milliseconds(double value) { return value < 0.0 ? "–" : short_figure(value) + " ms"; }

std::string bound_figure(double lux) {
    return lux < 0.0 ? std::string("–") : std::isfinite(lux) ? illuminance_figure(lux) : std::string(tr("none"));
}

/// Its mark tells the state by shape, its word in letters, its colour besides.
void state_cell(EffectState state) {
    const bool simulated = state == EffectState::simulated, skipped = state == EffectState::skipped;
    const ImU32 ink = simulated ? style::good : skipped ? style::warning : style::quiet_text;
    ImGui::TableNextColumn();
    icon_item(simulated ? Icon::done : skipped ? Icon::hidden : Icon::none, ink);
    ImGui::TextColored(style::colour(ink), "%s", std::string(tr(name_of(state))).c_str());
}

/// Who decides: the plan, or the user.
void choice_cell(Effect effect, Settings& settings, WidgetRegistry& widgets) {
    ImGui::TableNextColumn();
    const EffectOption* const option = option_of(effect);
    if (option == nullptr) return;
    constexpr const char* names[] = {"By its bound", "Always", "Never"};
    EffectChoice& choice = settings.*option->member;
    const std::string widget = "effects." + std::string(option->name);
    ImGui::SetNextItemWidth(-1.0F);
    if (ImGui::BeginCombo(("###" + widget).c_str(), tr(names[static_cast<std::size_t>(choice)]))) {
        for (const EffectChoice each : effect_choices) {
            const char* const name = names[static_cast<std::size_t>(each)];
            if (ImGui::Selectable(tr(name), each == choice)) choice = each;
            widgets.note(widget + "." + std::string(name_of(each)));
        }
        ImGui::EndCombo();
    } else {
        tooltip(
            "By its bound: skipped while all that is skipped adds no more than the tolerance (Calculation). "
            "Never: skipped however much it may add, and that is in every error bar");
    }
    widgets.note(widget);
}

/// What was measured without it: how much light that changed, and the time it saved.
void measured_cells(const EffectTrial* trial, double predicted_ms, double took_ms, bool measured) {
    cell(trial ? illuminance_figure(trial->change_lux) : "–");
    if (trial)
        tooltip(say("Leaving it out changes the calculation points by {} {} in the mean",
                    illuminance_figure(trial->mean_change_lux), illuminance_unit_name())
                    .c_str());
    if (!measured) return cell("–");
    if (trial) return cell(milliseconds(std::max(0.0, trial->saved_ms)));
    cell(took_ms >= 0.0 ? milliseconds(took_ms) : "≈ " + milliseconds(predicted_ms));
}

/// Which row the pointer is over: rows end where the next begins.
class PointedRow {
public:
    using Bounds = std::vector<double>;
    void begin(const Bounds* of_next) {
        const float top = ImGui::GetCursorScreenPos().y, at = ImGui::GetIO().MousePos.y;
        if (present_ && ImGui::IsWindowHovered() && at >= top_ && at < top) pointed_ = present_;
        present_ = of_next;
        top_ = top;
    }
    const Bounds* pointed() const { return pointed_; }

private:
    const Bounds* present_ = nullptr;
    const Bounds* pointed_ = nullptr;
    float top_ = 0.0F;
};

/// Pieces of furniture, the dimmest first.
std::optional<ObjectId> piece_rows(const PlannedEffect& row, bool measured, PointedRow& pointed,
                                   WidgetRegistry& widgets) {
    std::optional<ObjectId> clicked;
    std::vector<const PlannedPiece*> pieces;
    for (const PlannedPiece& piece : row.pieces) pieces.push_back(&piece);
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const PlannedPiece* a, const PlannedPiece* b) { return a->bound_lux < b->bound_lux; });
    for (const PlannedPiece* piece : pieces) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        pointed.begin(&piece->bound_at_points);
        ImGui::PushID(static_cast<int>(piece->object.value));
        ImGui::Indent();
        if (ImGui::Selectable("###piece", false)) clicked = piece->object;
        widgets.note("effects.piece." + piece->name);
        ImGui::SameLine(0.0F, 0.0F);
        elided_text(piece->name, 0.0F, Elide::middle);
        ImGui::Unindent();
        ImGui::PopID();
        state_cell(piece->state);
        cell(bound_figure(piece->bound_lux));
        measured_cells(nullptr, piece->predicted_ms, -1.0, measured);
        ImGui::TableNextColumn();
        cell(say("Reflectance {} on {} m²: what the paper decides by", short_figure(piece->reflectance),
                 short_figure(piece->area)),
             style::quiet_text);
    }
    return clicked;
}

void quiet(const std::string& text) {
    ImGui::SameLine(0.0F, 12.0F * style::scale());
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, style::quiet_text);
    elided_text(text);
    ImGui::PopStyleColor();
}

}  // namespace

struct EffectsPanel::Parts {
    std::function<void()> wake;
    std::unique_ptr<BackgroundWork> work;
    std::string failure;
    EffectTrials trials;
    SceneSnapshot scene;  ///< that the trials are of
    Settings settings;
    std::vector<double> pointed;
};

EffectsPanel::EffectsPanel() : parts_(std::make_unique<Parts>()) {}
EffectsPanel::~EffectsPanel() = default;

void EffectsPanel::connect(std::function<void()> wake) {
    parts_->wake = std::move(wake);
    parts_->work = std::make_unique<BackgroundWork>([this] { parts_->wake(); }, 0.0,
                                                    [this](const std::string& fault) { parts_->failure = fault; });
}

const EffectTrials& EffectsPanel::trials() const { return parts_->trials; }
const std::vector<double>& EffectsPanel::pointed() const { return parts_->pointed; }
bool EffectsPanel::busy() const { return parts_->work && parts_->work->busy(); }

void EffectsPanel::cancel() {
    if (parts_->work) parts_->work->cancel();
}

void EffectsPanel::begin_frame() {
    parts_->pointed.clear();
    if (parts_->work) parts_->work->follow();
}

Task EffectsPanel::task() {
    Task task = parts_->work->task();
    task.id = "effects";
    task.cancel = [this] { cancel(); };
    return task;
}

void EffectsPanel::start(const SceneSnapshot& scene, const Settings& settings) {
    if (!parts_->work) return;
    parts_->scene = scene;
    parts_->settings = settings;
    parts_->trials = {};
    parts_->failure.clear();
    parts_->work->start(tr("With and without each effect"), [this, scene, settings](const Work& work) {
        auto trials = try_effects(scene, settings, work);
        return BackgroundWork::Finish([this, trials = std::move(trials)] {
            if (trials) parts_->trials = *trials;
        });
    });
}

/// Null when nothing was measured, or it was measured of something else.
const EffectTrials* EffectsPanel::trials_of(const Solution& solution, const Settings& settings) const {
    const bool same = parts_->scene && (parts_->scene == solution.scene || *parts_->scene == *solution.scene);
    return same && parts_->settings == settings && parts_->trials.everything_ms > 0.0 ? &parts_->trials : nullptr;
}

void EffectsPanel::headline(const Solution& solution, const EffectTrials* trials, bool measured, Outcome& outcome,
                            WidgetRegistry& widgets) {
    if (busy()) {
        if (ImGui::Button(tr("Cancel"))) cancel();
        widgets.note("effects.cancel");
    } else {
        ImGui::BeginDisabled(solution.points.empty() && solution.grids.empty());
        outcome.starts = ImGui::Button(tr("Measure each effect"));
        ImGui::EndDisabled();
        widgets.note("effects.measure");
        tooltip("Solve the room with and without each effect: what it really adds and takes here");
    }
    if (!parts_->failure.empty()) return quiet(parts_->failure);
    if (solution.points.empty() && solution.grids.empty())
        return quiet(tr("It needs calculation grids or points to compare at: Add > Calculation grid."));
    if (!trials) return quiet(tr("Bounds hold for any light; what an effect really adds is usually far less."));
    const std::string all = measured ? milliseconds(trials->everything_ms) : "–";
    const EffectTrial* const planned = trials->of(std::nullopt);
    quiet(planned ? say("Everything: {}. The plan: {}, off by {} {} at most where {} was allowed for.", all,
                        measured ? milliseconds(planned->without_ms) : "–", illuminance_figure(planned->change_lux),
                        illuminance_unit_name(), bound_figure(planned->bound_lux))
                  : say("Everything: {}. The plan skips nothing.", all));
}

EffectsPanel::Outcome EffectsPanel::table(const Solution& solution, const Settings& settings, bool measured,
                                          WidgetRegistry& widgets) {
    constexpr Column columns[] = {
        {"Effect", 2.0F, "What light does that may be simulated"},
        {"State", 1.1F, "Skipped effects are bounded, and counted in every error bar"},
        {"Bound  lx", 1.0F,
         "What skipping leaves out, or would, at any calculation point at most; of direct shadows, penumbra and "
         "openings: of light straight from luminaires"},
        {"Found  lx", 1.0F, "The greatest change at a calculation point when it was left out"},
        {"Cost", 0.9F, "Predicted, or measured once it ran"},
        {"Choice", 1.5F, "Who decides: the plan by its bounds, or you"},
        {"Why", 4.7F, ""},
    };
    Outcome outcome;
    const EffectTrials* const trials = trials_of(solution, settings);
    headline(solution, trials, measured, outcome, widgets);
    if (!ImGui::BeginTable("effects", 7, table_look)) return outcome;
    header(columns);
    Settings wished = settings;
    PointedRow pointed;
    for (const PlannedEffect& row : solution.plan.effects) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        pointed.begin(&row.bound_at_points);
        bool open = false;
        if (row.pieces.empty()) {
            elided_text(std::string(tr(name_of(row.effect))));
        } else {
            open =
                ImGui::TreeNodeEx("###pieces", ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth,
                                  "%s", std::string(tr(name_of(row.effect))).c_str());
            widgets.note("effects.pieces");
        }
        state_cell(row.state);
        cell(row.may_be_skipped || row.bound_lux > 0.0 ? bound_figure(row.bound_lux) : "–");
        measured_cells(trials ? trials->of(row.effect) : nullptr, row.predicted_ms, row.measured_ms, measured);
        choice_cell(row.effect, wished, widgets);
        ImGui::TableNextColumn();
        ImGui::TextWrapped("%s", row.why.c_str());
        if (open)
            if (const auto clicked = piece_rows(row, measured, pointed, widgets)) outcome.clicked = clicked;
    }
    pointed.begin(nullptr);
    if (pointed.pointed()) parts_->pointed = *pointed.pointed();
    ImGui::EndTable();
    if (wished != settings) outcome.settings = wished;
    return outcome;
}

void EffectsPanel::draw(const PaneSight& sight, WidgetRegistry& /*widgets*/) {
    const std::vector<double>& bounds = parts_->pointed;
    if (bounds.empty() || !sight.answer) return;
    std::vector<Vec3> places;
    for (const PointResult& point : sight.answer->points) places.push_back(point.position);
    for (const GridResult& grid : sight.answer->grids)
        for (const PointResult& point : grid.points) places.push_back(point.position);
    const auto most = std::max_element(bounds.begin(), bounds.end());
    if (places.size() != bounds.size() || !(*most > 0.0) || !std::isfinite(*most)) return;
    constexpr unsigned most_vertices = 40'000;  // of the 65,536 that a list holds: the least bounds are left out
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float scale = style::scale();
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return bounds[a] > bounds[b]; });
    std::vector<std::optional<ImVec2>> seen;
    for (const Vec3& place : places) seen.push_back(sight.pane.on_screen(place));
    for (const std::size_t k : order) {
        if (list._VtxCurrentIdx > most_vertices) break;
        if (!seen[k]) continue;
        float room = 11.0F * scale;  // in dense grids up to the next point
        for (const std::size_t next : {k - 1, k + 1})
            if (next < seen.size() && seen[next])
                room = std::min(room, 0.5F * std::hypot(seen[next]->x - seen[k]->x, seen[next]->y - seen[k]->y));
        const float share = static_cast<float>(std::sqrt(bounds[k] / *most));
        const float radius = std::max(room, 2.0F * scale) * (0.15F + 0.85F * share);
        list.AddCircleFilled(*seen[k], radius, (style::warning & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 165), 14);
    }
    const auto at = sight.pane.on_screen(places[static_cast<std::size_t>(most - bounds.begin())]);
    if (!at) return;
    list.AddCircle(*at, 12.5F * scale, style::text, 0, 2.0F * scale);
    const std::string text = fmt::format("≤ {} {}", illuminance_figure(*most), illuminance_unit_name());
    const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
    const ImVec2 corner{at->x - 0.5F * extent.x, at->y - extent.y - 18.0F * scale};
    list.AddRectFilled({corner.x - 7.0F * scale, corner.y - 3.0F * scale},
                       {corner.x + extent.x + 7.0F * scale, corner.y + extent.y + 4.0F * scale}, style::card,
                       4.0F * scale);
    list.AddText(corner, style::text, text.c_str());
}

}  // namespace hanei
