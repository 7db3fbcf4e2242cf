/// A reference case computed and judged.
#pragma once

#include "app/commands.h"
#include "app/verdict.h"
#include "engine/base/progress.h"

#include <optional>

namespace hanei {

/// By the method and the patch width that suit the case within some seconds; `change` has the last word.
/// Returns   nothing when stopped.
std::optional<CaseVerdict> run_reference(const ReferenceCase& reference, const SettingsChange& change,
                                         const Work& work);

}  // namespace hanei
