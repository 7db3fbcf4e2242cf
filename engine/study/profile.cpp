#include "engine/study/profile.h"

#include "engine/study/study.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

constexpr std::size_t equal_steps = 96;
constexpr std::size_t most_samples = 400;
constexpr double shown_step = 0.02;         // of the greatest value: smaller ones look smooth
constexpr double least_width = 1.0 / 4096;  // of the line

double total_of(const ProfileSample& sample) { return sample.value.total().value; }

}  // namespace

Vec3 ProfileLine::at(double along) const {
    const double whole = length();
    return whole > 0.0 ? from + (along / whole) * (to - from) : from;
}

ProfileSampler::ProfileSampler(SolutionSnapshot solution, const ProfileLine& line)
    : solution_(std::move(solution)), line_(line) {
    const double size = glm::length(line_.normal);
    line_.normal = size > 0.0 ? line_.normal / size : Vec3(0.0, 0.0, 1.0);
    refined_ = !(line_.length() > 0.0) || !std::isfinite(line_.length());
    if (refined_) next_ = equal_steps + 1;  // a line of no length has no values
}

bool ProfileSampler::done() const { return next_ > equal_steps && refined_; }

void ProfileSampler::insert(double along) {
    const auto after = std::lower_bound(samples_.begin(), samples_.end(), along,
                                        [](const ProfileSample& sample, double place) { return sample.along < place; });
    samples_.insert(after, {along, value_at(*solution_, line_.at(along), line_.normal)});
}

/// One value more in the widest interval over which the light jumps. False when none is left.
bool ProfileSampler::refine() {
    double greatest = 0.0;
    for (const ProfileSample& sample : samples_) greatest = std::max(greatest, total_of(sample));
    std::size_t worst = 0;
    double width = least_width * line_.length();
    for (std::size_t k = 1; k < samples_.size(); ++k) {
        const bool covered = samples_[k].value.inside_solid != samples_[k - 1].value.inside_solid;
        const double step = std::abs(total_of(samples_[k]) - total_of(samples_[k - 1]));
        const double apart = samples_[k].along - samples_[k - 1].along;
        if ((!covered && step < shown_step * greatest) || apart <= width) continue;
        width = apart;
        worst = k;
    }
    if (worst == 0 || samples_.size() >= most_samples) return false;
    insert(0.5 * (samples_[worst - 1].along + samples_[worst].along));
    return true;
}

void ProfileSampler::advance(std::size_t values) {
    for (std::size_t k = 0; k < values && !done(); ++k) {
        if (next_ <= equal_steps)
            insert(line_.length() * static_cast<double>(next_++) / equal_steps);
        else
            refined_ = !refine();
    }
}

}  // namespace hanei
