#include "engine/project/measured_file.h"
#include "tests/fuzz/what_holds.h"

#include <cmath>
#include <cstdlib>

namespace {

void check(bool holds) {
    if (!holds) std::abort();
}

void check_value(const hanei::MeasuredValue& value) {
    check(std::isfinite(value.lux) && value.lux >= 0.0 && value.line > 0);
    check(!value.index || *value.index >= 1);
    check(!value.plan || (std::isfinite(value.plan->x) && std::isfinite(value.plan->y)));
    check(!value.uncertainty || (std::isfinite(*value.uncertainty) && *value.uncertainty >= 0.0));
    check(!value.normal || std::abs(glm::length(*value.normal) - 1.0) < 1e-9);
    check(value.plan || value.index || !value.set.empty());
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const hanei::MeasuredRead read = hanei::read_measured_text(hanei::text_of(bytes, count), "fuzz.csv");
    hanei::check_findings(read.findings, read.values.has_value());
    if (read.values)
        for (const hanei::MeasuredValue& value : read.values->values) check_value(value);
    return 0;
}
