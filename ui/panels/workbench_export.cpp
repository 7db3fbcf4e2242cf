#include "engine/base/stoppable.h"
#include "engine/base/whole_file.h"
#include "engine/report/report.h"
#include "ui/panels/checks.h"
#include "ui/panels/language.h"
#include "ui/panels/workbench.h"
#include "ui/view/picture_text.h"
#include "ui/view/screen_picture.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <stdexcept>

namespace hanei {
namespace {

/// The saved view that is looked through, as a file name calls it.
std::string name_of_view(const Scene& scene, const Camera& camera) {
    for (std::size_t k = 0; k < scene.views.size(); ++k) {
        if (camera_of(scene.views[k]) != camera) continue;
        return scene.views[k].name.empty() ? fmt::format("view {}", k + 1) : scene.views[k].name;
    }
    return "view";
}

Diagnostic error_of(std::string sentence) {
    Diagnostic finding;
    finding.message = std::move(sentence);
    return finding;
}

}  // namespace

PictureRequest Workbench::picture_request() const {
    const PixelSize size{1600, static_cast<int>(1600.0 / viewport_.aspect())};
    PictureRequest request{viewport_.state.camera, viewport_.state.options, size, true, {}};
    request.options.shadows_of = selection_.primary();
    request.length = preferences_.length;
    return request;
}

PictureRequest Workbench::pictured_request() const {
    PictureRequest request = picture_request();
    if (!readings_.snapshots.shows_kept()) return request;
    request.caption = readings_.snapshots.title();
    if (readings_.snapshots.shows_difference())
        request.options = as_difference(std::move(request.options), readings_.snapshots.range_of(request.options.part));
    return request;
}

void Workbench::draw_export() {
    if (!export_dialog_.is_open()) return;
    ExportDialog::Context context{document_.title(),
                                  name_of_view(*document_.shown(), viewport_.state.camera),
                                  viewport_.state.options.part,
                                  viewport_.state.panes.shows_parts(),
                                  {}};
    if (const ScreenRect* view = widgets_.find("view"))
        context.view_size = {static_cast<int>(view->right - view->left), static_cast<int>(view->bottom - view->top)};
    if (auto jobs = export_dialog_.draw(context, form_)) {
        preferences_.picture_name = export_dialog_.name_template();
        export_.start(std::move(*jobs));
    }
}

SolutionSnapshot Workbench::pictured() const {
    return readings_.snapshots.shows_kept() ? readings_.snapshots.shown() : study_.solution();
}

std::string Workbench::project_hash() const {
    if (!door_.text) return {};
    return short_hash(door_.text(document_.content()));
}

void Workbench::copy_picture() {
    if (!door_.copy_picture)
        return tell("Export", error_of("pictures cannot be copied from here: export them instead"));
    try {
        const SolutionSnapshot solution = pictured();
        const PictureRequest request = captioned(pictured_request(), *solution);
        const Image image = render_picture(solution, request);
        const std::string png = png_bytes(
            image, picture_text(*solution, request.options, project_hash(), std::chrono::system_clock::now()));
        if (const auto reason = door_.copy_picture(png)) return tell("Export", error_of(*reason));
        message_ = "Copied the picture";
    } catch (const std::runtime_error& fault) {
        tell("Export", error_of(fault.what()));
    }
}

void Workbench::tell(const std::string& source, const Diagnostic& finding) {
    messages_.note(source, finding);
    dialogs_.show_findings("That did not work", {finding});
}

void Workbench::ask_for_values() {
    browser_.open(
        {"Export the values of grids and points", "Export", {".csv"}, true, folder(), document_.title() + ".csv"},
        [this, solution = study_.answer()](const std::filesystem::path& file) {
            if (const auto reason = write_whole_file(file, values_csv(*solution)))
                return tell("Export", error_of(file.string() + ": " + *reason));
            message_ = say("Exported {}", file.filename().string());
        });
}

void Workbench::toggle_recording() {
    if (recording_.is_on()) {
        recording_.stop(how_.patience);
        follow_recording();
    } else {
        std::error_code failure;
        const auto where = folder().empty() ? std::filesystem::current_path(failure) : folder();
        if (const auto reason = recording_.start(where, document_.title())) return tell("Recording", error_of(*reason));
        recorded_scene_.reset();
        recorded_solution_.reset();
        message_ = "Recording: drag something, or let it compute";
    }
}

/// What comes of the pictures that are written after the recording was stopped.
void Workbench::follow_recording() {
    const std::string fault = recording_.take_fault();
    if (!fault.empty()) {
        recording_.stop(how_.patience);
        tell("Recording", error_of(fault));
    }
    if (recording_.take_end() && fault.empty())
        message_ = say("Recorded {} pictures in {}", recording_.taken(), recording_.folder().string());
}

/// A picture whenever what is shown is another than before, and of every frame in which the view moves.
void Workbench::record_frame() {
    follow_recording();
    if (!recording_.is_on()) return;
    const bool same = recorded_scene_ == document_.shown() && recorded_solution_ == study_.solution();
    const ScreenRect* view = widgets_.find("view");
    if ((same && !viewport_.moving()) || view == nullptr) return;
    recorded_scene_ = document_.shown();
    recorded_solution_ = study_.solution();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const auto whole = [](float pixels) { return static_cast<int>(std::lround(pixels)); };
    Image picture = picture_of_screen({whole(screen.x), whole(screen.y)}, whole(view->left), whole(view->top),
                                      {whole(view->right - view->left), whole(view->bottom - view->top)});
    recording_.take(std::move(picture), document_.in_gesture() ? "while it is changed"
                                        : study_.fresh()       ? fmt::format("complete, iteration error <= {:.2g} lx",
                                                                             study_.solution()->iteration_bound)
                                                               : std::string(name_of(study_.progress().stage())));
}

void Workbench::after_frame() {
    exact_.after_frame();
    if (const std::string fault = exact_.take_failure(); !fault.empty()) tell("Export", error_of(fault));
    record_frame();
    if (copies_) copy_picture();
    copies_ = false;
    if (!export_.busy()) return;
    const bool is_whole = readings_.snapshots.shows_kept() || study_.fresh();
    const PictureExport::Outcome outcome =
        export_.step(pictured(), is_whole, pictured_request(), [this] { return project_hash(); });
    if (outcome.fault) tell("Export", *outcome.fault);
    if (!outcome.message.empty()) message_ = outcome.message;
}

void Workbench::save_exact() {
    const auto picture = std::make_shared<const Image>(*exact_.shown());
    const auto text =
        picture_text(*study_.solution(), viewport_.state.options, project_hash(), std::chrono::system_clock::now());
    browser_.open({"Save the exact picture", "Save", {".png"}, true, folder(), document_.title() + " exact.png"},
                  [this, picture, text](const std::filesystem::path& file) {
                      file_work_.start(say("Saving {}", file.filename().string()), [=, this](const Work& work) {
                          const std::string bytes = png_bytes(*picture, text);
                          if (work.stop.stop_requested()) throw Stopped{};
                          const std::optional<std::string> reason = write_whole_file(file, bytes);
                          return [this, file, reason] {
                              if (reason) return tell("Export", error_of(file.string() + ": " + *reason));
                              message_ = say("Saved {}", file.filename().string());
                          };
                      });
                  });
}

bool Workbench::is_busy() const {
    return study_.busy() || exact_.busy() || file_work_.busy() || export_.busy() || recording_.is_writing() ||
           checks_->validation.busy() || checks_->trust.busy() || readings_.study.busy() || readings_.effects.busy();
}

std::optional<Task> Workbench::running_task() {
    if (file_work_.busy()) return file_work_.task();
    if (export_.busy()) {
        Task task = export_.task();
        if (how_.repeatable) task.left.clear();
        return task;
    }
    if (exact_.busy()) return exact_.task();
    if (recording_.is_on())
        return Task{
            "recording", say("Recording, {} pictures", recording_.taken()), 0.0F, {}, [this] { toggle_recording(); }};
    if (recording_.is_writing()) return recording_.task();
    if (readings_.study.busy()) {
        Task task = readings_.study.task();
        if (how_.repeatable) task.left.clear();
        return task;
    }
    if (readings_.effects.busy()) {
        Task task = readings_.effects.task();
        if (how_.repeatable) task.left.clear();
        return task;
    }
    if (!study_.is_cancellable()) return std::nullopt;
    const float fraction = study_.progress().fraction();
    const Stage stage = study_.progress().stage();
    return Task{"study", std::string(name_of(stage)), fraction,
                how_.repeatable ? std::string() : study_left_.text(stage, fraction), [this] { study_.cancel(); }};
}

}  // namespace hanei
