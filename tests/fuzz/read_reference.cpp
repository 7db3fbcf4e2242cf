#include "engine/base/check.h"
#include "engine/project/reference_case.h"
#include "engine/scene/scene_check.h"
#include "tests/fuzz/what_holds.h"

#include <cmath>

namespace {

bool is_finite(const hanei::Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void check_case(const hanei::ReferenceCase& wanted) {
    if (wanted.unsupported.empty()) HANEI_CHECK(!hanei::has_errors(hanei::check_scene(wanted.scene)));
    for (const hanei::ReferencePoint& point : wanted.points) {
        HANEI_CHECK(is_finite(point.position) && is_finite(point.normal));
        HANEI_CHECK(std::isfinite(point.expected) && std::isfinite(point.uncertainty));
    }
    for (const hanei::ReferenceFormFactor& factor : wanted.form_factors)
        HANEI_CHECK(std::isfinite(factor.expected) && std::isfinite(factor.reverse.value_or(0.0)));
    for (const hanei::ReferenceMean& mean : wanted.means) HANEI_CHECK(std::isfinite(mean.expected));
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const hanei::ReferenceRead read =
        hanei::read_reference_text(hanei::text_of(bytes, count), "/nowhere/reference/file.json");
    hanei::check_findings(read.findings, !hanei::has_errors(read.findings));
    HANEI_CHECK(read.cases.empty() || !hanei::has_errors(read.findings));
    for (const hanei::ReferenceCase& wanted : read.cases) check_case(wanted);
    return 0;
}
