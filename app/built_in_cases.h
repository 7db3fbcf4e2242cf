/// The reference cases that come with the program.
#pragma once

#include "app/reference_run.h"
#include "engine/project/reference_index.h"
#include "engine/report/validation_report.h"

#include <functional>
#include <optional>
#include <vector>

namespace hanei {

struct BuiltInCases {
    struct Case {
        ReferenceEntry entry;
        ReferenceCase reference;
    };
    std::vector<Case> cases;  ///< a case with variants is several
    Diagnostics findings;
};
BuiltInCases built_in_cases();

/// All of them, one after the other; `told` (may be null) gets each as it is done, from the calling thread.
/// Returns   nothing when stopped.
/// Cost      some ten seconds on two cores.
std::optional<Validation> validate(const BuiltInCases& cases, const SettingsChange& change, const Work& work,
                                   const std::function<void(const CaseVerdict&, const ValidationRow&)>& told);

}  // namespace hanei
