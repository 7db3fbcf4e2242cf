/// Arguments of the commands that read the light at places: why, profile, compare.
#pragma once

#include "app/profile_command.h"
#include "app/trust_command.h"
#include "app/why_command.h"

#include <functional>

namespace CLI {
class App;
}

namespace hanei {

struct ReadingArguments {
    WhyRequest why;
    ProfileRequest profile;
    CompareRequest compare;
    TrustRequest trust;
};

/// `add_common` adds the options that all commands share. The arguments must outlive the parsing.
using AddCommon = std::function<void(CLI::App&)>;
void add_reading(CLI::App& app, ReadingArguments& arguments, const AddCommon& add_common);

/// Runs the command that was asked for; empty when it is none of these.
std::optional<int> run_reading(const CLI::App& app, ReadingArguments& arguments, const SettingsChange& change);

}  // namespace hanei
