#include "ui/panels/photometry_panel.h"

#include "engine/scene/intensity.h"
#include "ui/panels/language.h"
#include "ui/panels/photometry_plot.h"
#include "ui/panels/photometry_rows.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

/// One of two words of which one is on.
bool word(const char* label, bool on, const char* name, const char* help, WidgetRegistry& widgets) {
    ImGui::PushStyleColor(ImGuiCol_Button, on ? ImU32(style::chosen) : style::none);
    ImGui::PushStyleColor(ImGuiCol_Text, on ? style::accent : style::text);
    const bool pressed = ImGui::Button(fmt::format("{}##{}", tr(label), name).c_str());
    ImGui::PopStyleColor(2);
    widgets.note(name);
    tooltip(help);
    return pressed;
}

float width_of(const char* label) { return ImGui::CalcTextSize(tr(label)).x + 2.0F * ImGui::GetStyle().FramePadding.x; }

std::string plane_name(double plane_deg) { return fmt::format("C{:g} – C{:g}", plane_deg, plane_deg + 180.0); }

/// The combination of a stroke as in the plot and the plane it stands for.
void plane_choice(const char* name, double& plane, const std::vector<double>& planes, const PlaneCurve& look,
                  float width, Form& form) {
    const float scale = style::scale();
    const float sample = 22.0F * scale;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float middle = at.y + 0.5F * ImGui::GetFrameHeight();
    stroke(*ImGui::GetWindowDrawList(), {{at.x, middle}, {at.x + sample, middle}}, look);
    ImGui::Dummy({sample, ImGui::GetFrameHeight()});
    ImGui::SameLine(0.0F, 6.0F * scale);
    ImGui::SetNextItemWidth(width - sample - 6.0F * scale);
    const bool open = ImGui::BeginCombo((std::string("##") + name).c_str(), plane_name(plane).c_str(),
                                        ImGuiComboFlags_NoArrowButton | ImGuiComboFlags_HeightLarge);
    form.widgets().note(name);
    if (!open) return tooltip("Which plane this curve shows");
    for (const double offered : planes) {
        if (ImGui::Selectable(plane_name(offered).c_str(), offered == plane)) plane = offered;
        form.widgets().note(fmt::format("{}.{:g}", name, offered));
    }
    ImGui::EndCombo();
}

}  // namespace

void PhotometryPanel::look_at(const Photometry& photometry) {
    Photometry own = photometry;
    own.quarter_turns = 0;
    if (own != shown_) {
        shown_ = std::move(own);
        figures_ = photometry_figures(shown_);
        planes_ = offered_planes(shown_);
        factor_ = per_kilolumen(shown_);
        curve_plane_ = other_curve_plane_ = -1.0;
        const auto offered = [this](double plane) {
            return std::find(planes_.begin(), planes_.end(), plane) != planes_.end();
        };
        if (!offered(plane_)) plane_ = 0.0;
        if (!offered(other_)) other_ = planes_.size() > 1 ? 90.0 : 0.0;
        if (planes_.size() > 1 && other_ == plane_) other_ = 90.0;
    }
    if (curve_plane_ != plane_) curve_ = plane_curve(shown_, curve_plane_ = plane_);
    if (other_curve_plane_ != other_) other_curve_ = plane_curve(shown_, other_curve_plane_ = other_);
}

void PhotometryPanel::plot(Form& form) {
    WidgetRegistry& widgets = form.widgets();
    if (word("Polar", !cartesian_, "photometry.polar", "Intensity as distance from the middle", widgets))
        cartesian_ = false;
    ImGui::SameLine(0.0F, 2.0F * style::scale());
    if (word("Cartesian", cartesian_, "photometry.cartesian", "Intensity over the angle", widgets)) cartesian_ = true;
    const float units = width_of("cd") + width_of("cd/klm") + 2.0F * style::scale();
    ImGui::SameLine();
    const float before = ImGui::GetCursorPosX(), from_right = ImGui::GetContentRegionMax().x - units;
    if (from_right < before) ImGui::NewLine();  // no room beside the words
    ImGui::SetCursorPosX(from_right);
    if (word("cd", !per_kilolumen_, "photometry.cd", "Candela, as the file says", widgets)) per_kilolumen_ = false;
    ImGui::SameLine(0.0F, 2.0F * style::scale());
    const char* help = shown_.absolute ? "Candela per 1000 lm of the luminaire" : "Candela per 1000 lm of the lamps";
    if (word("cd/klm", per_kilolumen_, "photometry.klm", help, widgets)) per_kilolumen_ = true;

    PlotRequest request;
    request.peak = figures_.peak.value;
    request.factor = per_kilolumen_ ? factor_ : 1.0;
    request.curves.push_back({plane_, false, style::accent, curve_});
    if (other_ != plane_) request.curves.push_back({other_, true, style::second, other_curve_});
    request.upward = shines_upward(curve_, request.peak) || shines_upward(other_curve_, request.peak);
    const HoveredGamma hovered = cartesian_ ? cartesian_plot(request, widgets) : polar_plot(request, widgets);
    readout_.clear();
    if (hovered) {
        readout_ = fmt::format("γ {:g}°", std::abs(*hovered));
        for (const PlaneCurve& curve : request.curves) {
            const double half_plane = curve.plane_deg + (*hovered < 0.0 ? 180.0 : 0.0);
            const double value = candela_at(shown_, curve.plane_deg, *hovered) * request.factor;
            readout_ += fmt::format("    C{:g}  {}", half_plane, candela_text(value));
        }
        readout_ += per_kilolumen_ ? " cd/klm" : " cd";
    }
    ImGui::PushFont(style::fonts().small);
    const bool quiet = readout_.empty();
    const std::string line = quiet ? tr("Point at the curves to read them.") : readout_;
    ImGui::TextColored(style::colour(quiet ? style::quiet_text : style::text), "%s", line.c_str());
    ImGui::PopFont();
    plane_choices(form);
}

void PhotometryPanel::plane_choices(Form& form) {
    if (planes_.size() < 2) {
        ImGui::TextColored(style::colour(style::quiet_text), "%s", tr("All planes are alike."));
        return;
    }
    const float gap = 10.0F * style::scale();
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - gap);
    plane_choice("photometry.plane", plane_, planes_, {plane_, false, style::accent, {}}, half, form);
    ImGui::SameLine(0.0F, gap);
    plane_choice("photometry.other", other_, planes_, {other_, true, style::second, {}}, half, form);
}

void PhotometryPanel::actions(const Scene& scene, const Luminaire& luminaire, const Photometry& photometry, Form& form,
                              Outcome& outcome) {
    const auto wish = [&](Photometry wished, const char* step) {
        outcome.edit = SceneEdit{with_photometry(scene, luminaire.id, std::move(wished), all_), step};
    };
    form.heading("Output");
    if (Luminaire wished = luminaire; flux_rows(wished, photometry, form)) {
        const bool as_measured = std::holds_alternative<AsMeasured>(wished.output);
        outcome.edit = SceneEdit{scene, as_measured ? "Use flux as measured" : "Set luminous flux"};
        *std::find(outcome.edit->scene.luminaires.begin(), outcome.edit->scene.luminaires.end(), luminaire) = wished;
    }
    if (photometry.lamp_sets.size() > 1) {
        std::vector<std::string> names;
        for (const LampSet& set : photometry.lamp_sets) names.push_back(lamp_text(set));
        int chosen = static_cast<int>(photometry.lamp_set);
        if (form.choice("photometry.lamps", "Lamps", "The file's lamp sets are alternatives: choose the one fitted",
                        names, chosen))
            wish(with_lamp_set(photometry, static_cast<std::size_t>(chosen)), "Choose lamp set");
    }
    if (form.button("luminaire.turn", "Turn luminaire by 90°",
                    "Housing and light together, about the vertical, counter-clockwise from above  (T)"))
        outcome.edit = SceneEdit{turned_by_a_quarter(scene, luminaire.id), "Turn luminaire by 90 degrees"};
    if (form.button("photometry.turn", "Turn intensities by 90°",
                    "The light alone, against the housing: for files that count planes from the other side. Four turns "
                    "are none  (Shift+T)"))
        wish(turned_by_a_quarter(photometry), "Turn intensities by 90 degrees");
    if (photometry.quarter_turns != 0)
        form.remark(say("Intensities stand {}° from the housing.", 90 * photometry.quarter_turns), false);
    const int users = users_of(scene, photometry.id);
    if (users > 1) {
        const std::string label = say("All {} alike", users);
        form.toggle("photometry.all", label.c_str(),
                    "Lamps, turned intensities and another file go to every luminaire of this file, or to this one "
                    "alone",
                    all_);
    }
}

PhotometryPanel::Outcome PhotometryPanel::draw(const Scene& scene, ObjectId id, Form& form) {
    Outcome outcome;
    readout_.clear();
    const Luminaire* luminaire = find_luminaire(scene, id);
    const Photometry* photometry = luminaire != nullptr ? photometry_of(scene, *luminaire) : nullptr;
    ImGui::Dummy({0.0F, 2.0F * style::scale()});
    if (photometry == nullptr) {
        ImGui::PushStyleColor(ImGuiCol_Text, style::quiet_text);
        ImGui::TextWrapped("%s", luminaire == nullptr
                                     ? tr("Choose a luminaire, or drop a luminaire file on the room.")
                                     : tr("This luminaire is not measured: its light follows a formula. Drop a "
                                          "luminaire file on it to give it measured light."));
        ImGui::PopStyleColor();
        return outcome;
    }
    if (!hangs_together(*photometry)) {
        ImGui::TextWrapped("%s", tr("The table of this photometry does not hang together: see Messages."));
        return outcome;
    }
    look_at(*photometry);
    outcome.replaces_file = photometry_title(*photometry, form.widgets());
    plot(form);
    form.begin("photometry");
    actions(scene, *luminaire, *photometry, form, outcome);
    figure_rows(*photometry, figures_, form);
    keyword_rows(*photometry, form);
    form.end();
    return outcome;
}

}  // namespace hanei
