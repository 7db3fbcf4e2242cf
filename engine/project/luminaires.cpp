#include "engine/project/luminaires.h"

#include "engine/project/luminaire_file.h"

#include <utility>

namespace hanei {
namespace {

LuminairesRead alone(LuminaireFileRead read) {
    LuminairesRead result{{}, std::move(read.findings)};
    if (read.photometry) {
        std::string name = read.photometry->name;
        result.luminaires.push_back({std::move(name), std::move(*read.photometry)});
    }
    return result;
}

}  // namespace

LuminairesRead read_luminaires(const std::filesystem::path& file) { return alone(read_luminaire_file(file)); }

LuminairesRead read_luminaires(std::string_view bytes, std::string_view name) {
    return alone(read_luminaire_text(bytes, name));
}

}  // namespace hanei
