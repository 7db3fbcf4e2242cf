#include "ui/panels/study_panel.h"

#include "engine/report/sweep_report.h"
#include "ui/panels/background_work.h"
#include "ui/panels/elided.h"
#include "ui/panels/form.h"
#include "ui/panels/language.h"
#include "ui/panels/study_plot.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <mutex>

namespace hanei {
namespace {

constexpr float facts_width = 250.0F;

/// What the thread has found so far.
struct Found {
    std::mutex guard;
    Sweep sweep;
    bool is_new = false;
};

void wrapped(const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, style::quiet_text);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
}

}  // namespace

struct StudyPanel::Parts {
    UserDoor door;
    std::function<void()> wake;
    std::unique_ptr<BackgroundWork> work;
    std::shared_ptr<Found> found;
    Calibration calibration;
    Sweep sweep;
    SceneSnapshot scene;  ///< that the sweep is of
    double budget = 60.0;
    std::string failure;
};

StudyPanel::StudyPanel() : parts_(std::make_unique<Parts>()) {}
StudyPanel::~StudyPanel() = default;

void StudyPanel::connect(const UserDoor& door, std::function<void()> wake) {
    parts_->door = door;
    parts_->wake = std::move(wake);
    if (door.open_calibration) parts_->calibration = door.open_calibration();
    parts_->work = std::make_unique<BackgroundWork>([this] { parts_->wake(); }, 0.0,
                                                    [this](const std::string& fault) { parts_->failure = fault; });
}

bool StudyPanel::busy() const { return parts_->work && parts_->work->busy(); }
const Sweep& StudyPanel::sweep() const { return parts_->sweep; }
const Calibration& StudyPanel::calibration() const { return parts_->calibration; }

void StudyPanel::start(const SceneSnapshot& scene, const Settings& settings) {
    if (!parts_->work) return;
    const auto found = std::make_shared<Found>();
    parts_->found = found;
    parts_->scene = scene;
    parts_->sweep = {};
    parts_->failure.clear();
    SweepWish wish;
    wish.budget = parts_->budget;
    wish.calibration = parts_->calibration;
    wish.on_way = [found, wake = parts_->wake](const Sweep& so_far) {
        const std::scoped_lock lock(found->guard);
        found->sweep = so_far;
        found->is_new = true;
        wake();
    };
    parts_->work->start(tr("Accuracy against time"), [this, scene, settings, wish](const Work& work) {
        Sweep sweep = accuracy_sweep(scene, settings, wish, work);
        return BackgroundWork::Finish([this, sweep = std::move(sweep)] {
            for (const CalibrationSample& sample : sweep.learned) parts_->calibration.learn(sample);
            if (parts_->door.keep_learned) parts_->door.keep_learned(sweep.learned);
            parts_->sweep = sweep;
        });
    });
}

void StudyPanel::cancel() {
    if (parts_->work) parts_->work->cancel();
    parts_->sweep.stopped = true;
}

void StudyPanel::follow() {
    if (!parts_->work) return;
    if (parts_->work->busy() && parts_->found) {
        const std::scoped_lock lock(parts_->found->guard);
        if (parts_->found->is_new) parts_->sweep = parts_->found->sweep;
        parts_->found->is_new = false;
    }
    parts_->work->follow();
}

Task StudyPanel::task() {
    Task task = parts_->work->task();
    task.id = "sweep";
    task.cancel = [this] { cancel(); };
    return task;
}

StudyPanel::Outcome StudyPanel::table(const SceneSnapshot& scene, const Settings& present, bool measured,
                                      WidgetRegistry& widgets) {
    Outcome outcome;
    const float scale = style::scale();
    ImGui::BeginChild("study.facts", {facts_width * scale, 0.0F});
    const bool can_start = !scene->points.empty() || !scene->grids.empty();
    if (busy()) {
        if (ImGui::Button(tr("Cancel"))) cancel();
        widgets.note("study.cancel");
        tooltip(tr("End it; what was found so far stays"));
    } else {
        ImGui::BeginDisabled(!can_start);
        outcome.starts = ImGui::Button(tr("Compare methods"));
        widgets.note("study.start");
        ImGui::EndDisabled();
        tooltip(tr("Run all methods, patch widths and numbers of interreflections on this room"));
    }
    ImGui::SameLine();
    ImGui::SetNextItemWidth(58.0F * scale);
    double budget = parts_->budget;
    if (ImGui::InputDouble("##budget", &budget, 0.0, 0.0, "%.0f"))
        parts_->budget = std::isfinite(budget) ? std::clamp(budget, 1.0, 86'400.0) : parts_->budget;
    widgets.note("study.budget");
    tooltip(tr("Seconds for all runs: those predicted to go beyond are left out"));
    ImGui::SameLine(0.0F, 4.0F * scale);
    quiet_words("s");
    const Sweep& sweep = parts_->sweep;
    if (!parts_->failure.empty()) wrapped(parts_->failure);
    if (!can_start) wrapped(tr("It needs calculation grids or points to compare at: Add > Calculation grid."));
    if (sweep.points.empty()) {
        if (busy())
            wrapped(tr("First comes the finest run, which all others are compared with."));
        else if (sweep.budget_s > 0.0 && !sweep.stopped)
            wrapped(tr("No run fits into this time: allow more, or take wider patches."));
        else if (can_start)
            wrapped(tr("How exact each method is and how long it takes, on this room. Then click a point to use it."));
    } else {
        if (parts_->scene != scene && *parts_->scene != *scene) wrapped(tr("The room has changed since."));
        wrapped(tr("Click a point to use it."));
        if (!sweep.uncertainty.set.empty() && measured)
            wrapped(say("Errors are against the finest run, which is uncertain itself by {}.",
                        percent_text(sweep.uncertainty.p95)));
        if (sweep.lumen.refusal.empty() && measured)
            wrapped(say("Lumen method: {:.0f} lx on the working plane, {} off.", sweep.lumen.predicted,
                        percent_text(sweep.lumen.error())));
        if (!sweep.left_out.empty()) wrapped(say("{} runs were left out: too long.", sweep.left_out.size()));
    }
    ImGui::EndChild();
    ImGui::SameLine(0.0F, 14.0F * scale);
    ImGui::BeginChild("study.child", {0.0F, 0.0F});
    if (!sweep.points.empty()) outcome.use = study_plot(sweep, present, widgets);
    ImGui::EndChild();
    return outcome;
}

}  // namespace hanei
