#include "engine/edit/edit.h"
#include "engine/edit/plan_shape.h"
#include "ui/panels/furnishing.h"
#include "ui/panels/language.h"
#include "ui/panels/property_rows.h"
#include "ui/panels/start_page.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace hanei {
namespace {

constexpr std::array shapes{"box", "L", "T", "U"};

bool dialog_button(const char* label, const char* name, WidgetRegistry& widgets) {
    const bool pressed = ImGui::Button(fmt::format("{}##{}", tr(label), name).c_str(), {110.0F * style::scale(), 0.0F});
    widgets.note(name);
    return pressed;
}

bool key_pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false); }

enum class Answer { none, yes, no };

/// Enter says yes unless a figure is being typed, which it only finishes.
Answer answer(const char* yes, const char* name, bool possible, WidgetRegistry& widgets) {
    const float space = ImGui::GetStyle().ItemSpacing.x;
    ImGui::Dummy({0.0F, 6.0F * style::scale()});
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 220.0F * style::scale() - space);
    const bool typing = ImGui::GetIO().WantTextInput || ImGui::IsAnyItemActive();
    Answer given = Answer::none;
    if (dialog_button("Cancel", fmt::format("{}.cancel", name).c_str(), widgets) ||
        (!typing && key_pressed(ImGuiKey_Escape)))
        given = Answer::no;
    ImGui::SameLine();
    ImGui::BeginDisabled(!possible);
    if (dialog_button(yes, fmt::format("{}.ok", name).c_str(), widgets) ||
        (possible && !typing && key_pressed(ImGuiKey_Enter)))
        given = Answer::yes;
    ImGui::EndDisabled();
    return given;
}

/// The plan in outline, so that the shape's name needs no words.
void draw_plan(const std::vector<Vec2>& plan, float height) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::Dummy({width, height});
    if (plan.empty()) return;
    Vec2 end{0.0};
    for (const Vec2& corner : plan) end = glm::max(end, corner);
    const double scale = 0.9 * std::min(static_cast<double>(width) / end.x, static_cast<double>(height) / end.y);
    std::vector<ImVec2> outline;
    for (const Vec2& corner : plan)
        outline.emplace_back(low.x + 0.5F * width + static_cast<float>(scale * (corner.x - 0.5 * end.x)),
                             low.y + 0.5F * height - static_cast<float>(scale * (corner.y - 0.5 * end.y)));
    ImGui::GetWindowDrawList()->AddPolyline(outline.data(), static_cast<int>(outline.size()), style::accent,
                                            ImDrawFlags_Closed, 2.0F * style::scale());
}

bool count_row(const char* name, const char* label, const char* help, int low, int high, int& count, Form& form) {
    double value = count;
    if (!form.number({name, label, "", help, static_cast<double>(low), static_cast<double>(high), 0.05, 0}, value))
        return false;
    count = static_cast<int>(std::lround(value));
    return true;
}

}  // namespace

void Furnishing::ask(Question question) {
    question_ = question;
    opening_ = true;
}

void Furnishing::ask_new_room() {
    offers_ = false;
    begins_with_ = 0;
    ask(Question::new_room);
}

void Furnishing::ask_new_project(std::vector<std::filesystem::path> examples) {
    offers_ = true;
    examples_ = std::move(examples);
    begins_with_ = 0;
    ask(Question::new_room);
}

void Furnishing::ask_circle(const Vec2& middle) {
    circle_.middle = middle;
    ask(Question::circle);
}

void Furnishing::close() {
    question_ = Question::none;
    ImGui::CloseCurrentPopup();
}

/// Beside the room rather than over it: its effect is to be seen.
bool Furnishing::begin(const char* title, float width) {
    const std::string label = fmt::format("{}###furnishing", tr(title));
    const bool over = question_ == Question::new_room;
    if (opening_) ImGui::OpenPopup(label.c_str());
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float x = over ? 0.5F : 0.02F, y = over ? 0.5F : 0.12F;
    ImGui::SetNextWindowPos({x * screen.x, y * screen.y}, opening_ ? ImGuiCond_Always : ImGuiCond_Appearing,
                            over ? ImVec2{0.5F, 0.5F} : ImVec2{0.0F, 0.0F});
    ImGui::SetNextWindowSize({std::min(width * style::scale(), screen.x - 40.0F), 0.0F});
    opening_ = false;
    if (!over) ImGui::PushStyleColor(ImGuiCol_ModalWindowDimBg, style::none);
    const bool drawn = ImGui::BeginPopupModal(label.c_str(), nullptr, ImGuiWindowFlags_NoResize);
    if (!over) ImGui::PopStyleColor();
    if (!drawn) question_ = Question::none;
    return drawn;
}

Furnishing::Wish Furnishing::questions(const Scene& scene, const Selection& selection, Form& form) {
    switch (question_) {
        case Question::none:
            return {};
        case Question::new_room:
            return new_room_question(form);
        case Question::array:
            return array_question(scene, selection, form);
        case Question::circle:
            return circle_question(scene, selection, form);
    }
    return {};
}

/// True when it is a room of sizes.
bool Furnishing::begin_with(Form& form) {
    if (!offers_) return true;
    std::vector<std::string> names{tr("A room of these sizes"), tr("The plain room")};
    for (const std::filesystem::path& example : examples_) names.push_back(title_of_example(example));
    form.choice("new.begin", "Begin with", "What the new project holds at first", names, begins_with_);
    return begins_with_ == 0;
}

Furnishing::Wish Furnishing::new_room_question(Form& form) {
    Wish wish;
    if (!begin(offers_ ? "New project" : "New room", 420.0F)) return wish;
    form.begin("new room");
    const bool has_sizes = begin_with(form);
    if (has_sizes) sizes(form);
    form.end();
    if (has_sizes) draw_plan(usual_plan(new_room_.shape, new_room_.length, new_room_.width), 90.0F * style::scale());
    const Answer given = answer("Create", "new", true, form.widgets());
    if (given != Answer::none) close();
    ImGui::EndPopup();
    if (given != Answer::yes) return wish;
    constexpr int plain_room = 1;
    if (begins_with_ > plain_room) {
        wish.begins_from = examples_[static_cast<std::size_t>(begins_with_ - plain_room - 1)];
        return wish;
    }
    wish.scene = begins_with_ == plain_room ? empty_room() : new_room(new_room_);
    wish.begins_anew = true;
    return wish;
}

void Furnishing::sizes(Form& form) {
    const std::vector<std::string> names{"Box", "L", "T", "U"};
    int shape = static_cast<int>(std::find(shapes.begin(), shapes.end(), new_room_.shape) - shapes.begin());
    if (form.choice("new.shape", "Plan", "The outline of the floor", names, shape))
        new_room_.shape = shapes[static_cast<std::size_t>(shape)];
    form.number({"new.length", "Length", "m", "Along x", 0.5, 1000.0, 0.02, 2}, new_room_.length);
    form.number({"new.width", "Width", "m", "Along y", 0.5, 1000.0, 0.02, 2}, new_room_.width);
    form.number({"new.height", "Height", "m", "Clear height from floor to ceiling", 0.5, 100.0, 0.01, 2},
                new_room_.height);
    form.number({"new.floor", "Floor at", "m", "Height of the floor", -1e3, 1e3, 0.01, 2}, new_room_.floor_height);
    std::vector<std::string> presets;
    int chosen = -1;
    for (const ReflectancePreset& preset : reflectance_presets()) {
        if (preset.values == new_room_.reflectances) chosen = static_cast<int>(presets.size());
        presets.emplace_back(preset.name);
    }
    if (form.choice("new.reflectances", "Reflectances", "Of ceiling, walls and floor, in percent", presets, chosen))
        new_room_.reflectances = reflectance_presets()[static_cast<std::size_t>(chosen)].values;
}

Furnishing::Wish Furnishing::preview(AddedSeveral made, bool changed, std::string step, WidgetRegistry& widgets) {
    Wish wish;
    const Answer given = answer("Create", "copies", true, widgets);
    if (given != Answer::none) close();
    ImGui::EndPopup();
    wish.abandons = given == Answer::no;
    wish.settles = given == Answer::yes;
    wish.previews = changed && given == Answer::none;
    if (!wish.settles && !wish.previews) return wish;
    wish.scene = std::move(made.scene);
    wish.step = std::move(step);
    if (wish.settles) wish.chosen = std::move(made.objects);
    return wish;
}

Furnishing::Wish Furnishing::array_question(const Scene& scene, const Selection& selection, Form& form) {
    bool changed = opening_;
    if (!begin("Copies in rows and columns", 330.0F)) return {};
    form.begin("array");
    const int most = most_copies;
    changed |= count_row("array.columns", "Columns", "How many side by side, the original included", 1,
                         std::max(1, most / std::max(1, array_.rows)), array_.columns, form);
    changed |= form.number(
        {"array.column_step", "Spacing", "m", "From one column to the next, along x", -1000.0, 1000.0, 0.01, 2},
        array_.column_step.x);
    changed |= count_row("array.rows", "Rows", "How many one behind the other, the original included", 1,
                         std::max(1, most / std::max(1, array_.columns)), array_.rows, form);
    changed |=
        form.number({"array.row_step", "Spacing", "m", "From one row to the next, along y", -1000.0, 1000.0, 0.01, 2},
                    array_.row_step.y);
    form.end();
    return preview(arrayed(scene, selection.ids(), array_), changed, "Array", form.widgets());
}

Furnishing::Wish Furnishing::circle_question(const Scene& scene, const Selection& selection, Form& form) {
    bool changed = opening_;
    if (!begin("Copies in a circle", 330.0F)) return {};
    form.begin("circle");
    changed |= count_row("circle.count", "Count", "How many, the original included", 1, 200, circle_.count, form);
    changed |= form.number({"circle.x", "Middle  x", "m", "Of the circle", -1e4, 1e4, 0.01, 2}, circle_.middle.x);
    changed |= form.number({"circle.y", "y", "m", "Of the circle", -1e4, 1e4, 0.01, 2}, circle_.middle.y);
    changed |= angle_row({"circle.angle", "Angle", "°", "From the first to beyond the last: 360° closes the circle",
                          -360.0, 360.0, 0.5, 1},
                         circle_.angle, form);
    changed |= form.toggle("circle.turns", "Turn along", "Each copy is turned with its place", circle_.turns);
    form.end();
    return preview(circled(scene, selection.ids(), circle_), changed, "Circular array", form.widgets());
}

}  // namespace hanei
