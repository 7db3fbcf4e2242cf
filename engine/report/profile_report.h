/// A profile for spreadsheets.
#pragma once

#include "engine/study/profile.h"

#include <string>

namespace hanei {

/// Distance and place, total, direct and interreflected illuminance and the error bar of every sample; those
/// inside of furniture are left out.
std::string profile_csv(const ProfileSampler& profile);

}  // namespace hanei
