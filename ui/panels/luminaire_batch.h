/// Luminaire files read one after the other, away from the frames.
#pragma once

#include "engine/base/progress.h"
#include "ui/panels/project_door.h"

#include <deque>

namespace hanei {

struct LuminaireBatch {
    std::vector<Photometry> read;
    Diagnostics faults;  ///< of files that cannot be used, and what is wrong in others
    /// Of a file with more than one luminaire, where reading stops until it is known which; empty: all was read.
    std::vector<Photometry> several;
    std::filesystem::path file;              ///< that holds them
    std::deque<std::filesystem::path> left;  ///< not read yet
};

/// For folders the luminaire files in them, by name. Says how far it is and obeys the wish to stop.
LuminaireBatch read_luminaire_files(std::deque<std::filesystem::path> files,
                                    const decltype(ProjectDoor::read_luminaires)& read, const Work& work);

/// Of luminaire files: ".ies", ".ldt", ...
std::vector<std::string> luminaire_endings();

/// In small letters, with its dot.
std::string ending_of(const std::filesystem::path& file);

}  // namespace hanei
