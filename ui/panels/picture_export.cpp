#include "ui/panels/picture_export.h"

#include "ui/panels/language.h"
#include "ui/view/picture_text.h"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

namespace hanei {

void PictureExport::start(std::vector<PictureJob> jobs) {
    jobs_.assign(std::make_move_iterator(jobs.begin()), std::make_move_iterator(jobs.end()));
    total_ = jobs_.size();
    written_ = 0;
}

bool PictureExport::wants_unshadowed() const {
    return std::any_of(jobs_.begin(), jobs_.end(),
                       [](const PictureJob& job) { return job.four || job.part == LightPart::unshadowed; });
}

Task PictureExport::task() {
    const std::size_t done = total_ - jobs_.size();
    return {"export",
            fmt::format(fmt::runtime(tr("Exporting {} of {}")), done + 1, total_),
            static_cast<float>(done) / static_cast<float>(std::max<std::size_t>(1, total_)),
            {},
            [this] { cancel(); }};
}

PictureExport::Outcome PictureExport::step(const SolutionSnapshot& solution, bool is_fresh, const PictureRequest& base,
                                           const std::function<std::string()>& project_hash) {
    if (jobs_.empty() || !solution || !is_fresh) return {};
    const PictureJob job = jobs_.front();
    jobs_.pop_front();
    try {
        write(solution, base, job, project_hash());
        ++written_;
        last_ = job.file.filename().string();
    } catch (const std::runtime_error& fault) {
        jobs_.clear();
        Outcome ended;
        ended.fault.emplace().message = fault.what();
        return ended;
    }
    if (!jobs_.empty()) return {};
    return {written_ == 1 ? fmt::format("Exported {}", last_) : fmt::format("Exported {} pictures", written_), {}};
}

void PictureExport::write(const SolutionSnapshot& solution, PictureRequest request, const PictureJob& job,
                          const std::string& hash) const {
    request.size = job.size;
    request.options.part = job.part;
    request.annotated = job.has_legend || job.has_caption;
    request.has_legend = job.has_legend;
    request.has_caption = job.has_caption;
    request.has_scale_bar = job.has_scale_bar;
    request.has_axes = job.has_axes;
    const Image image = job.four ? render_four_up(solution, request) : render_picture(solution, request);
    write_png(image, job.file, picture_text(*solution, request.options, hash, std::chrono::system_clock::now()));
}

}  // namespace hanei
