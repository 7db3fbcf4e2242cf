#include "ui/panels/form.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace hanei {
namespace {

std::string digits_of(const Vec3& srgb) {
    const auto byte = [](double share) { return std::lround(255.0 * std::clamp(share, 0.0, 1.0)); };
    return fmt::format("#{:02X}{:02X}{:02X}", byte(srgb.x), byte(srgb.y), byte(srgb.z));
}

/// Nothing for a text that is not six hexadecimal digits, with or without #.
std::optional<Vec3> colour_of(std::string_view text) {
    if (text.starts_with('#')) text.remove_prefix(1);
    unsigned packed = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), packed, 16);
    if (text.size() != 6 || fault != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return Vec3(packed >> 16U, (packed >> 8U) & 0xFFU, packed & 0xFFU) / 255.0;
}

}  // namespace

bool Form::colour(const char* name, const char* label_text, const char* help, Vec3& srgb) {
    if (!shared_.draws()) return shared_.row(name, srgb);
    label(label_text, help);
    const std::string popup = std::string(name) + ".popup";
    const std::string digits_name = std::string(name) + ".digits";
    const ImVec4 patch{static_cast<float>(srgb.x), static_cast<float>(srgb.y), static_cast<float>(srgb.z), 1.0F};
    constexpr int plain = ImGuiColorEditFlags_NoAlpha | ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop;
    const float height = ImGui::GetFrameHeight();
    if (ImGui::ColorButton((std::string("##") + name).c_str(), patch, plain, {2.0F * height, height})) {
        picked_ = srgb;
        ImGui::OpenPopup(popup.c_str());
    }
    widgets_.note(name);
    tooltip(help);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-FLT_MIN);
    bool changed = false;
    std::string digits = digits_of(srgb);
    if (typed(digits_name.c_str(), "Its six hexadecimal digits in sRGB", digits, false)) {
        const std::optional<Vec3> read = colour_of(digits);
        changed = read.has_value();
        srgb = read.value_or(srgb);
        if (changed) shared_.note_change(name, srgb);
    }
    const ImVec2 corner = ImGui::GetItemRectMax();
    ImGui::SetNextWindowPos({corner.x, corner.y + 4.0F * style::scale()}, ImGuiCond_Always, {1.0F, 0.0F});
    if (!ImGui::BeginPopup(popup.c_str())) return changed;
    float primaries[3] = {static_cast<float>(picked_.x), static_cast<float>(picked_.y), static_cast<float>(picked_.z)};
    constexpr int bare = ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoLabel;
    ImGui::SetNextItemWidth(220.0F * style::scale());
    if (ImGui::ColorPicker3("##picker", primaries, bare)) {
        srgb = picked_ = Vec3(static_cast<double>(primaries[0]), static_cast<double>(primaries[1]),
                              static_cast<double>(primaries[2]));
        changed = true;
        shared_.note_change(name, srgb);
    }
    widgets_.note(std::string(name) + ".picker");
    ImGui::EndPopup();
    return changed;
}

}  // namespace hanei
