#include "ui/panels/photometry_rows.h"

#include "engine/report/photometry_report.h"
#include "engine/scene/intensity.h"
#include "ui/panels/icon.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui_internal.h>

namespace hanei {
namespace {

/// A row that is only read: closer to the next than a field is.
void figure(const char* label, const std::string& text, const char* help = "") {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextColored(style::colour(style::quiet_text), "%s", tr(label));
    tooltip(help);
    ImGui::TableNextColumn();
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    tooltip(help);
}

std::string percent(double share) { return fmt::format("{:.1f} %", 100.0 * share); }

/// "100.0 %", with what the file declares beside it where it does.
std::string share_text(const std::optional<double>& computed, const std::optional<double>& declared) {
    std::string text = computed ? percent(*computed) : tr("not available");
    if (declared) text += say(" (file: {})", percent(*declared));
    return text;
}

std::string peak_text(const Photometry& photometry, const PhotometryFigures& figures) {
    const char* plane = photometry.type == PhotometricType::C   ? "C"
                        : photometry.type == PhotometricType::B ? "H "
                                                                : "X ";
    const char* angle = photometry.type == PhotometricType::C   ? "γ "
                        : photometry.type == PhotometricType::B ? "V "
                                                                : "Y ";
    return say("{:.1f} cd at {}{:g}, {}{:g}°", figures.peak.value, plane, figures.peak_at.horizontal_deg, angle,
               figures.peak_at.vertical_deg);
}

std::string span_text(const std::optional<AngleSpan>& span) {
    if (!span) return tr("none");
    const auto angle = [](double degrees) {
        return fmt::format("{}{:.1f}", degrees < -0.05 ? "−" : "", std::abs(degrees));
    };
    return say("{:.1f}°  ({} to {}{})", span->width_deg(), angle(span->from_deg), angle(span->to_deg),
               span->cut ? tr(", cut") : "");
}

void span_rows(const PhotometryFigures& figures, bool alike) {
    const auto rows = [](const PlaneFigures& plane, const char* beam, const char* field) {
        const std::string from =
            plane.upward ? tr(" Counted from the zenith: the plane's peak is above the horizontal.") : "";
        figure(beam, span_text(plane.beam), (tr("Between the directions of 50 % of the plane's peak.") + from).c_str());
        figure(field, span_text(plane.field),
               (tr("Between the directions of 10 % of the plane's peak; cut where it still is above that at the "
                   "horizontal.") +
                from)
                   .c_str());
    };
    if (alike) return rows(figures.plane_0, "Beam 50 %", "Field 10 %");
    rows(figures.plane_0, "Beam C0", "Field C0");
    rows(figures.plane_90, "Beam C90", "Field C90");
}

}  // namespace

bool hangs_together(const Photometry& photometry) {
    const auto rising = [](const std::vector<double>& angles) {
        return std::adjacent_find(angles.begin(), angles.end(), [](double a, double b) { return !(a < b); }) ==
               angles.end();
    };
    return !photometry.horizontal_deg.empty() && photometry.vertical_deg.size() > 1 &&
           photometry.candela.size() == photometry.horizontal_deg.size() * photometry.vertical_deg.size() &&
           rising(photometry.horizontal_deg) && rising(photometry.vertical_deg) &&
           std::all_of(photometry.candela.begin(), photometry.candela.end(),
                       [](double value) { return std::isfinite(value) && value >= 0.0; });
}

std::string candela_text(double value) {
    if (value >= 99.95 || value == 0.0) return fmt::format("{:.0f}", value);
    return value >= 9.995 ? fmt::format("{:.1f}", value) : fmt::format("{:.2f}", value);
}

std::string lamp_text(const LampSet& lamps) {
    std::string text = lamps.type.empty() ? tr("Lamp") : lamps.type;
    if (std::abs(lamps.count) != 1.0) text = fmt::format("{:g} × {}", std::abs(lamps.count), text);
    if (lamps.lumens > 0.0) text += fmt::format(", {:g} lm", lamps.lumens);
    if (lamps.watts > 0.0) text += fmt::format(", {:g} W", lamps.watts);
    return text;
}

std::string opening_text(const Photometry& photometry) {
    const MeasuredOpeningSize& size = photometry.opening;
    const std::string shape(tr(name_of(size.shape)));
    if (size.shape == OpeningShape::point) return tr("point, no extent");
    if (size.shape == OpeningShape::circle) return say("circle, Ø {:g} m", size.extent_0);
    std::string text = fmt::format("{}, {:g} × {:g}", shape, size.extent_0, size.extent_90);
    if (size.height > 0.0) text += fmt::format(" × {:g}", size.height);
    return text + " m";
}

bool photometry_title(const Photometry& photometry, WidgetRegistry& widgets) {
    ImGui::PushFont(style::fonts().strong);
    ImGui::TextWrapped("%s", (photometry.name.empty() ? photometry.source_file : photometry.name).c_str());
    ImGui::PopFont();
    const char* const replace = tr("Replace...");
    const float button = ImGui::CalcTextSize(replace).x + 2.0F * ImGui::GetStyle().FramePadding.x;
    const float room = ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 text{low.x, low.y + ImGui::GetStyle().FramePadding.y};
    const ImVec2 high{low.x + room, low.y + ImGui::GetFrameHeight()};
    ImGui::PushStyleColor(ImGuiCol_Text, style::quiet_text);
    ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), text, high, high.x, high.x, photometry.source_file.c_str(),
                              nullptr, nullptr);
    ImGui::PopStyleColor();
    ImGui::Dummy({room, ImGui::GetFrameHeight()});
    tooltip(photometry.source_file);
    ImGui::SameLine();
    const bool wished = ImGui::Button(replace);
    widgets.note("photometry.replace");
    tooltip("Hang the light of another file in its place");
    const std::size_t remarks = photometry.warnings.size();
    if (remarks > 0) {
        const char* const words = remarks == 1 ? "{} remark on this file, below" : "{} remarks on this file, below";
        icon_item(Icon::note, style::warning);
        ImGui::TextColored(style::colour(style::warning), "%s", say(words, remarks).c_str());
    }
    return wished;
}

bool flux_rows(Luminaire& luminaire, const Photometry& photometry, Form& form) {
    const double measured = luminous_flux(photometry).value;
    if (!(measured > 0.0)) {
        form.remark("The file is dark: there is no flux to set.", true);
        return false;
    }
    const auto* set = std::get_if<LuminousFlux>(&luminaire.output);
    double lumens = set != nullptr ? set->value : measured;
    const char* help = "At full output: as measured, or typed here. The shape of the light stays";
    if (form.number({"luminaire.flux", "Luminous flux", "lm", help, 0.0, 1e7, 10.0, 0}, lumens)) {
        luminaire.output = LuminousFlux{lumens};
        return true;
    }
    if (set == nullptr) {
        form.remark("As measured", false);
        return false;
    }
    form.remark(say("{:.1f} % of the {:.0f} lm measured", 100.0 * lumens / measured, measured), false);
    if (!form.button("luminaire.as_measured", "As measured", "Takes the flux of the file again")) return false;
    luminaire.output = AsMeasured{};
    return true;
}

void figure_rows(const Photometry& photometry, const PhotometryFigures& figures, Form& form) {
    form.heading("Figures");
    figure("Luminous flux", fmt::format("{:.1f} lm", figures.flux.value),
           "Integral of the intensities over all directions");
    figure("Zone average", fmt::format("{:.1f} lm", figures.zone_average_flux.value),
           "The flux as North American test reports add it up");
    if (figures.declared_flux)
        figure("Declared", fmt::format("{:.1f} lm", figures.declared_flux->value), "What the file states");
    figure("Output ratio",
           photometry.absolute ? tr("absolute photometry")
                               : share_text(figures.output_ratio, photometry.declared_output_ratio),
           "Luminous flux of the luminaire over that of its lamps");
    figure("Downward", share_text(figures.downward_share, photometry.declared_downward_share),
           "Share of the luminous flux below the horizontal");
    figure("Efficacy", figures.efficacy ? fmt::format("{:.1f} lm/W", *figures.efficacy) : tr("not available"));
    figure("Power", photometry.input_watts > 0.0 ? fmt::format("{:g} W", photometry.input_watts) : tr("not stated"));
    figure("Peak", peak_text(photometry, figures));
    span_rows(figures, figures.symmetry_found == PhotometricSymmetry::rotational);
    figure("Symmetry", std::string(tr(name_of(figures.symmetry_found))),
           "As the intensities show it, to 1 % of the peak");
    figure("Opening", opening_text(photometry), "Along plane 0, along plane 90, and its height");
    figure("As a point",
           figures.point_distance ? say("beyond {:.2f} m: error ≤ {:g} %", *figures.point_distance, 100.0 * point_error)
                                  : tr("at no distance"),
           "From where on the opening may be taken for a point, proved from the table: the error is a share of peak "
           "intensity over distance squared");
    figure("Format", say("{}, type {}", photometry.format, name_of(photometry.type)));
    const std::size_t planes = photometry.horizontal_deg.size();
    figure("Table", say(planes == 1 ? "{} angles in {} plane" : "{} angles in {} planes",
                        photometry.vertical_deg.size(), planes));
    for (const std::string& difference : figures.differences) form.remark(difference, true);
    if (!photometry.warnings.empty()) form.heading("Remarks");
    for (const std::string& text : photometry.warnings) form.remark(text, true);
}

void keyword_rows(const Photometry& photometry, Form& form) {
    if (photometry.keywords.empty()) return;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, style::text);
    const bool open = ImGui::TreeNodeEx(
        "keywords", ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanFullWidth, "%s", tr("Keywords"));
    ImGui::PopStyleColor();
    form.widgets().note("photometry.keywords");
    ImGui::TableNextColumn();
    ImGui::TextColored(style::colour(style::quiet_text), "%s",
                       say("{} in the file", photometry.keywords.size()).c_str());
    if (!open) return;
    for (const auto& [key, text] : photometry.keywords) figure(key.c_str(), text, key.c_str());
}

}  // namespace hanei
