/// What must hold of any right answer, looked for in that of one scene.
#pragma once

#include "app/commands.h"

namespace hanei {

struct TrustRequest {
    std::filesystem::path project;
    std::optional<std::filesystem::path> json{};
    SettingsChange change{};
};
/// Returns   exit_answer_is_no when a check fails.
int trust_command(const TrustRequest& request);

}  // namespace hanei
