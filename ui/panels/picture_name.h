/// Names of exported files from a template.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace hanei {

struct NameParts {
    std::string project, view, part;
    int width = 0, height = 0;
    int number = 1;
    std::chrono::system_clock::time_point when;
};

inline constexpr std::string_view usual_name_template = "{project} {view} {part} {date}.png";

/// "{project} {view} {part} {date}.png" with {project}, {view}, {part}, {date} (2026-11-22), {time} (15-04-05),
/// {size} (1280x800) and {number} replaced. Characters that no file name may hold become "-", blanks beside
/// nothing melt into one, and ".png" is added where it is missing.
struct PictureName {
    std::string name;
    std::string fault;  ///< a sentence when the template makes no sense; then there is no name
};
PictureName picture_name(std::string_view name_template, const NameParts& parts);

}  // namespace hanei
