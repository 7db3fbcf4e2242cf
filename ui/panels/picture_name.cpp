#include "ui/panels/picture_name.h"

#include <ctime>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <optional>

namespace hanei {
namespace {

std::optional<std::string> value_of(std::string_view key, const NameParts& parts) {
    const std::time_t seconds = std::chrono::system_clock::to_time_t(parts.when);
    std::tm local{};
    localtime_r(&seconds, &local);
    if (key == "project") return parts.project;
    if (key == "view") return parts.view;
    if (key == "part") return parts.part;
    if (key == "date") return fmt::format("{:%Y-%m-%d}", local);
    if (key == "time") return fmt::format("{:%H-%M-%S}", local);
    if (key == "size") return fmt::format("{}x{}", parts.width, parts.height);
    if (key == "number") return std::to_string(parts.number);
    return std::nullopt;
}

/// No slash, no control characters, nothing that other systems refuse; one blank at a time, none at the ends.
std::string clean(std::string_view text) {
    std::string name;
    for (const char letter : text) {
        const bool refused =
            static_cast<unsigned char>(letter) < 0x20 || std::string_view("/\\:*?\"<>|\x7f").find(letter) != text.npos;
        const char kept = refused ? '-' : letter;
        if (kept == ' ' && (name.empty() || name.back() == ' ')) continue;
        name += kept;
    }
    while (!name.empty() && name.back() == ' ') name.pop_back();
    return name;
}

}  // namespace

PictureName picture_name(std::string_view name_template, const NameParts& parts) {
    constexpr std::size_t longest = 200;  // bytes; file systems end at 255
    std::string text;
    for (std::size_t at = 0; at < name_template.size();) {
        if (name_template[at] != '{') {
            text += name_template[at++];
            continue;
        }
        const std::size_t end = name_template.find('}', at);
        if (end == std::string_view::npos) return {{}, "a \"{\" has no \"}\""};
        const std::string_view key = name_template.substr(at + 1, end - at - 1);
        const std::optional<std::string> value = value_of(key, parts);
        if (!value)
            return {{},
                    fmt::format("{{{}}} means nothing; there are {{project}}, {{view}}, {{part}}, {{date}}, "
                                "{{time}}, {{size}} and {{number}}",
                                key)};
        text += *value;
        at = end + 1;
    }
    std::string name = clean(text);
    if (name.size() >= 4 && name.compare(name.size() - 4, 4, ".png") == 0) name.resize(name.size() - 4);
    name = clean(name);
    if (name.find_first_not_of(". ") == std::string::npos) return {{}, "the name is empty"};
    if (name.size() > longest) return {{}, fmt::format("the name has {} bytes, allowed are {}", name.size(), longest)};
    return {name + ".png", {}};
}

}  // namespace hanei
