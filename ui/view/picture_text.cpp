#include "ui/view/picture_text.h"

#include "ui/view/legend.h"

#include <ctime>
#include <fmt/chrono.h>
#include <fmt/format.h>

namespace hanei {

std::string short_hash(std::string_view text) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const char letter : text) hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211ULL;
    return fmt::format("{:016x}", hash);
}

PngText picture_text(const Solution& solution, const ViewOptions& look, const std::string& project_hash,
                     std::chrono::system_clock::time_point when) {
    const Caption caption = caption_of(solution, look);
    std::string description = caption.detail;
    if (look.scale == Scale::false_colour && !look.shadow_classes)
        description = fmt::format("Illuminance in lx, {} scale from {:g} to {:g} lx. {}", name_of(look.steps),
                                  look.range.low, look.range.high, description);
    PngText text{{"Title", caption.title}, {"Software", "Hanei " HANEI_VERSION}, {"Description", description}};
    const std::time_t seconds = std::chrono::system_clock::to_time_t(when);
    std::tm utc{};
    gmtime_r(&seconds, &utc);
    text.emplace_back("Creation Time", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", utc));
    text.emplace_back("Hanei project", project_hash);
    return text;
}

}  // namespace hanei
