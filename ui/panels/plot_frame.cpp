#include "ui/panels/plot_frame.h"

#include "ui/panels/photometry_plot.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

constexpr float left_room = 52.0F, bottom_room = 34.0F, top_room = 18.0F, right_room = 14.0F;  // for figures

ImU32 faint() { return ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.28F); }
ImU32 quiet() { return ImGui::GetColorU32(ImGuiCol_TextDisabled); }

void small_text(ImVec2 at, ImVec2 anchor, const std::string& text, ImU32 colour) {
    ImFont* font = style::fonts().small;
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e4F, 0.0F, text.c_str());
    ImGui::GetWindowDrawList()->AddText(font, font->FontSize,
                                        {std::floor(at.x - anchor.x * size.x), std::floor(at.y - anchor.y * size.y)},
                                        colour, text.c_str());
}

}  // namespace

std::vector<double> round_figures(const PlotAxis& axis, int count) {
    std::vector<double> figures;
    if (!(axis.high > axis.low) || !std::isfinite(axis.high - axis.low) || count < 1) return figures;
    if (axis.logarithmic) {
        const bool sparse = std::log10(axis.high / axis.low) > count / 2.0;
        for (double decade = std::pow(10.0, std::floor(std::log10(axis.low))); decade <= axis.high; decade *= 10.0)
            for (const double digit : {1.0, 2.0, 5.0})
                if ((digit == 1.0 || !sparse) && digit * decade >= axis.low * 0.999 &&
                    digit * decade <= axis.high * 1.001)
                    figures.push_back(digit * decade);
        return figures;
    }
    const double span = (axis.high - axis.low) / count, decade = std::pow(10.0, std::floor(std::log10(span)));
    double step = 10.0 * decade;
    for (const double digit : {5.0, 2.0, 1.0})
        if (digit * decade >= span) step = digit * decade;
    for (double k = std::ceil(axis.low / step - 1e-9); k * step <= axis.high + 1e-9 * step; k += 1.0)
        figures.push_back(k == 0.0 ? 0.0 : k * step);
    return figures;
}

PlotFrame::PlotFrame(const char* name, PlotAxis across, PlotAxis up, float height, WidgetRegistry& widgets)
    : across_(std::move(across)), up_(std::move(up)) {
    const float scale = style::scale();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size{std::max(1.0F, ImGui::GetContentRegionAvail().x), std::max(1.0F, height)};
    ImGui::InvisibleButton(name, size);
    widgets.note(name);
    low_ = {corner.x + left_room * scale, corner.y + top_room * scale};
    high_ = {corner.x + size.x - right_room * scale, corner.y + size.y - bottom_room * scale};
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (ImGui::IsItemHovered() && has_room() && mouse.x >= low_.x && mouse.x <= high_.x) pointed_ = x_at(mouse.x);
    if (has_room()) draw_axes();
}

double PlotFrame::share(const PlotAxis& axis, double value) const {
    if (!axis.logarithmic) return (value - axis.low) / (axis.high - axis.low);
    return std::log(std::max(value, 1e-12) / axis.low) / std::log(axis.high / axis.low);
}

ImVec2 PlotFrame::at(double x, double y) const {
    return {low_.x + static_cast<float>(share(across_, x)) * (high_.x - low_.x),
            high_.y - static_cast<float>(share(up_, y)) * (high_.y - low_.y)};
}

double PlotFrame::x_at(float screen_x) const {
    const double part = static_cast<double>((screen_x - low_.x) / (high_.x - low_.x));
    if (across_.logarithmic) return across_.low * std::pow(across_.high / across_.low, part);
    return across_.low + part * (across_.high - across_.low);
}

void PlotFrame::draw_axes() const {
    const float scale = style::scale();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const int columns = std::max(2, static_cast<int>((high_.x - low_.x) / (70.0F * scale)));
    const int rows = std::max(2, static_cast<int>((high_.y - low_.y) / (26.0F * scale)));
    float last = -1e9F;
    for (const double figure : round_figures(across_, columns)) {
        const float x = at(figure, up_.low).x;
        list.AddLine({x, low_.y}, {x, high_.y}, faint());
        if (x - last < 34.0F * scale) continue;
        last = x;
        small_text({x, high_.y + 3.0F * scale}, {0.5F, 0.0F}, figure_on_axis(figure), quiet());
    }
    for (const double figure : round_figures(up_, rows)) {
        const float y = at(across_.low, figure).y;
        list.AddLine({low_.x, y}, {high_.x, y}, faint());
        small_text({low_.x - 5.0F * scale, y}, {1.0F, 0.5F}, figure_on_axis(figure), quiet());
    }
    list.AddLine({low_.x, high_.y}, high_, quiet());
    list.AddLine(low_, {low_.x, high_.y}, quiet());
    small_text({high_.x, high_.y + 17.0F * scale}, {1.0F, 0.0F}, across_.title, quiet());
    small_text({low_.x, low_.y - 3.0F * scale}, {0.0F, 1.0F}, up_.title, quiet());
}

void plot_card(const PlotFrame& frame, ImVec2 at, const std::vector<std::string>& lines) {
    const float scale = style::scale(), line = ImGui::GetTextLineHeight();
    float width = 0.0F;
    for (const std::string& text : lines) width = std::max(width, ImGui::CalcTextSize(text.c_str()).x);
    const ImVec2 size{width + 16.0F * scale, line * static_cast<float>(lines.size()) + 10.0F * scale};
    const bool fits_right = at.x + 12.0F * scale + size.x < frame.high().x;
    const ImVec2 low{fits_right ? at.x + 12.0F * scale : at.x - 12.0F * scale - size.x,
                     std::clamp(at.y - 0.5F * size.y, frame.low().y, std::max(frame.low().y, frame.high().y - size.y))};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + size.x, low.y + size.y}, style::card, 5.0F * scale);
    for (std::size_t k = 0; k < lines.size(); ++k)
        list.AddText({low.x + 8.0F * scale, low.y + 5.0F * scale + static_cast<float>(k) * line}, style::text,
                     lines[k].c_str());
}

}  // namespace hanei
