#include "ui/panels/button_row.h"

#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <fmt/format.h>

namespace hanei {

int button_row(const char* label, std::span<const ButtonText> buttons, Form& form) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(style::colour(style::quiet_text), "%s", tr(label));
    ImGui::TableNextColumn();
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    const float gap = 4.0F * style::scale();
    int pressed = -1;
    for (std::size_t k = 0; k < buttons.size(); ++k) {
        const ButtonText& button = buttons[k];
        const std::string text(tr(std::string_view(button.label)));
        const float width = ImGui::CalcTextSize(text.c_str()).x + 2.0F * ImGui::GetStyle().FramePadding.x;
        if (k > 0 && ImGui::GetItemRectMax().x + gap + width <= right) ImGui::SameLine(0.0F, gap);
        if (ImGui::Button(fmt::format("{}##{}", text, button.name).c_str())) pressed = static_cast<int>(k);
        form.widgets().note(button.name);
        tooltip(button.help);
    }
    return pressed;
}

}  // namespace hanei
