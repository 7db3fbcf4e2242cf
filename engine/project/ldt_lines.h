/// The lines of an EULUMDAT file: one value each, in fixed order.
#pragma once

#include "engine/project/allowed_range.h"
#include "engine/project/luminaire_findings.h"
#include "engine/project/luminaire_text.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hanei {

/// After a fault every further number is 0, every text and list empty (as IesWords).
class LdtLines {
public:
    LdtLines(std::string_view text, LuminaireFindings& findings);

    std::string_view text(std::string_view field);  ///< may be blank
    double number(std::string_view field, const AllowedRange& allowed = {});
    int whole(std::string_view field, const AllowedRange& allowed);
    std::vector<double> numbers(std::size_t count, std::string_view field);
    std::vector<double> increasing(std::size_t count, std::string_view field, const AllowedRange& allowed);

    std::size_t left() const { return left_; }
    int line() const { return lines_.number(); }  ///< of the last line read

    /// What was read by text() and number() so far: field and line as written, in order.
    const std::vector<std::pair<std::string, std::string>>& header() const { return header_; }
    int first_line_with_text();  ///< of what is left; 0 when all is blank. Reads to there.

private:
    bool take(std::string_view field);
    double parsed(std::string_view field);

    LineReader lines_;
    std::size_t left_ = 0;
    std::vector<std::pair<std::string, std::string>> header_;
    LuminaireFindings& findings_;
};

}  // namespace hanei
