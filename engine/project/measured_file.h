/// Tables of illuminances that meters and other programs export (CSV).
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/scene/measured_values.h"

#include <filesystem>
#include <optional>
#include <string_view>

namespace hanei {

/// The first row that names a column of illuminances is the header; what stands above it is passed over.
/// Columns are found by their names in any order, whatever their case, with or without a unit ("x", "X [mm]",
/// "illuminance_lx", "E (fc)"); others are left alone. Separators are tabulators, else semicolons, else commas;
/// decimals have a point, or a comma where commas do not separate. Rows without a value ("", "-", "/", "n/a")
/// are counted; empty rows and those that begin with # are passed over.
struct MeasuredRead {
    std::optional<MeasuredValues> values;  ///< empty when there are faults
    Diagnostics findings;                  ///< twenty at most, then how many more
};

MeasuredRead read_measured(const std::filesystem::path& file);
/// `file` is what messages call the text.
MeasuredRead read_measured_text(std::string_view text, const std::filesystem::path& file);

}  // namespace hanei
