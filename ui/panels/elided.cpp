#include "ui/panels/elided.h"

#include "ui/panels/form.h"

#include <imgui.h>
#include <vector>

namespace hanei {
namespace {

constexpr std::string_view dots = "…";

float width_of(std::string_view text) { return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x; }

/// Where letters begin: a cut elsewhere would leave half a letter.
std::vector<std::size_t> letters_of(std::string_view text) {
    std::vector<std::size_t> starts;
    for (std::size_t k = 0; k < text.size(); ++k)
        if ((static_cast<unsigned char>(text[k]) & 0xC0U) != 0x80U) starts.push_back(k);
    starts.push_back(text.size());
    return starts;
}

std::string shortened(std::string_view text, const std::vector<std::size_t>& starts, std::size_t kept, Elide elide) {
    const std::size_t letters = starts.size() - 1;
    const std::size_t tail = elide == Elide::middle ? kept / 2 : 0;
    std::string shown(text.substr(0, starts[kept - tail]));
    while (!shown.empty() && shown.back() == ' ') shown.pop_back();
    shown += dots;
    shown += text.substr(starts[letters - tail]);
    return shown;
}

}  // namespace

std::string elided(std::string_view text, float room, Elide elide) {
    if (width_of(text) <= room) return std::string(text);
    if (width_of(dots) > room) return {};
    const std::vector<std::size_t> starts = letters_of(text);
    std::size_t fits = 0, too_many = starts.size() - 1;
    while (too_many > fits + 1) {
        const std::size_t middle = (fits + too_many) / 2;
        (width_of(shortened(text, starts, middle, elide)) <= room ? fits : too_many) = middle;
    }
    return shortened(text, starts, fits, elide);
}

void elided_text(std::string_view text, float room, Elide elide) {
    const float left = room > 0.0F ? room : ImGui::GetContentRegionAvail().x;
    const std::string shown = elided(text, left, elide);
    ImGui::TextUnformatted(shown.c_str(), shown.c_str() + shown.size());
    if (shown.size() != text.size()) tooltip(std::string(text));
}

void quiet_words(const char* text) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%s", text);
    ImGui::PopStyleColor();
}

}  // namespace hanei
