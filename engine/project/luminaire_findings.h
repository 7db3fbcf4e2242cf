/// What a reader of luminaire files found wrong.
#pragma once

#include "engine/base/diagnostic.h"

#include <string>
#include <string_view>
#include <vector>

namespace hanei {

/// Collects warnings and the first fault. After a fault a reader's figures mean nothing: every later
/// one would only follow from it, so that later faults and warnings are dropped.
class LuminaireFindings {
public:
    explicit LuminaireFindings(std::string_view file) : file_(file) {}

    void fault(int line, std::string field, std::string message);
    void warn(int line, std::string field, std::string message);
    bool failed() const { return failed_; }

    const Diagnostics& diagnostics() const { return diagnostics_; }
    /// "line 14, vertical angle: message", for Photometry::warnings.
    std::vector<std::string> warning_texts() const;

private:
    std::string file_;
    Diagnostics diagnostics_;
    bool failed_ = false;
};

}  // namespace hanei
