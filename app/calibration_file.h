/// What this machine's studies taught, as a file: calibration.json in the user's state folder.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/study/calibration.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace hanei {

struct CalibrationRead {
    Calibration calibration;
    Diagnostics findings;  ///< warnings alone: what cannot be used is left out
};

/// `file` is what remarks call the text. A study whose fields are missing, of another kind or out of
/// range is left out with a remark; of many faults the first are told.
CalibrationRead calibration_of_text(std::string_view json, const std::filesystem::path& file);

/// A missing file gives an empty calibration without a remark.
CalibrationRead read_calibration(const std::filesystem::path& file);

std::string calibration_text(const Calibration& calibration);

/// Makes the folder when it is not there; the file is written whole or not at all.
std::optional<Diagnostic> write_calibration(const Calibration& calibration, const std::filesystem::path& file);

/// Adds what was learned to the file, as it is by now. A disk that refuses is told and fails nothing.
std::optional<Diagnostic> add_learned(const std::vector<CalibrationSample>& learned, const std::filesystem::path& file);

/// Of the user: below XDG_STATE_HOME, else HOME; empty when there is none.
std::filesystem::path calibration_path();

/// That of the user, with remarks on stderr; empty without one.
Calibration known_calibration();

/// Adds what was learned to the user's file, as it is by now. A disk that refuses is told on stderr and
/// fails nothing: results do not depend on it.
void keep_learned(const std::vector<CalibrationSample>& learned);

}  // namespace hanei
