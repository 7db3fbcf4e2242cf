/// The numbers of an LM-63 file: a stream of words that may wrap anywhere.
#pragma once

#include "engine/project/allowed_range.h"
#include "engine/project/luminaire_findings.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace hanei {

/// Words are parted by blanks, tabs, commas and line ends.
///
/// After a fault (a word that is no number, the end of the file) every further number is 0 and every
/// list empty: readers go on to their end without asking, and look at the findings once.
class IesWords {
public:
    /// `first_line` is the number of the line the text begins with.
    IesWords(std::string_view text, int first_line, LuminaireFindings& findings);

    double number(std::string_view field, const AllowedRange& allowed = {});
    /// A whole number, which may be written 37.0.
    int whole(std::string_view field, const AllowedRange& allowed);
    std::vector<double> numbers(std::size_t count, std::string_view field);
    /// Like numbers, each greater than the one before it.
    std::vector<double> increasing(std::size_t count, std::string_view field, const AllowedRange& allowed);

    std::size_t left() const { return left_; }  ///< words not yet read
    int line() const { return line_; }          ///< of the last word read
    int next_line();                            ///< of the word to be read next

private:
    std::string_view take();
    void skip_separators();
    double number_of(std::size_t count, std::size_t position, std::string_view field);

    std::string_view rest_;
    int at_line_;
    int line_;
    std::size_t left_ = 0;
    LuminaireFindings& findings_;
};

}  // namespace hanei
