/// What the columns of a table of illuminances are called, and in which units they are.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hanei {

enum class MeasuredField { set, index, x, y, z, nx, ny, nz, lux, uncertainty };

struct MeasuredColumn {
    MeasuredField field = MeasuredField::lux;
    std::size_t place = 0;  ///< in the row, from 0
    std::string header;     ///< as written
    double unit = 1.0;      ///< what a 1 there is in metres or lux
    bool percent = false;   ///< of the row's illuminance
};

/// The fields of one row. Fields may stand in double quotes, in which two of them are one.
/// Returns   nothing when a quote does not end.
std::optional<std::vector<std::string>> fields_of(std::string_view line, char separator);

/// Tabulator, else semicolon, else comma: the first of them that occurs.
char separator_of(std::string_view line);

/// The columns that mean something here, one a field; of two that would be the same the second is in
/// `twice`. "point" and "id" name the set, or count its points where another column names the set.
struct MeasuredHeader {
    std::vector<MeasuredColumn> columns;
    std::optional<std::string> twice;
    bool has(MeasuredField field) const;
};
MeasuredHeader header_of(const std::vector<std::string>& names);

}  // namespace hanei
