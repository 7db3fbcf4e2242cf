/// Figures as people and spreadsheets read them.
#pragma once

#include <string>
#include <string_view>

namespace hanei {

/// False for an error, lx, that stands for "not known": a series that is not known to converge.
bool has_bound(double error_lux);

/// A text as one CSV field: quoted when it holds a comma, a quote or a line end (RFC 4180).
std::string csv_field(std::string_view text);

}  // namespace hanei
