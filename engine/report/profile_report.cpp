#include "engine/report/profile_report.h"

#include <fmt/format.h>

namespace hanei {

std::string profile_csv(const ProfileSampler& profile) {
    std::string csv = "along_m,x_m,y_m,z_m,total_lx,direct_lx,interreflected_lx,error_lx\n";
    for (const ProfileSample& sample : profile.samples()) {
        if (sample.value.inside_solid) continue;
        const Vec3 place = profile.line().at(sample.along);
        csv += fmt::format("{:.4f},{:.4f},{:.4f},{:.4f},{:.6g},{:.6g},{:.6g},{:.3g}\n", sample.along, place.x, place.y,
                           place.z, sample.value.total().value, sample.value.direct.value,
                           sample.value.interreflected.value, sample.value.error.total());
    }
    return csv;
}

}  // namespace hanei
