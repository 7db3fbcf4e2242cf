#include "ui/panels/picture_export.h"

#include "engine/base/stoppable.h"
#include "engine/base/whole_file.h"
#include "ui/panels/language.h"
#include "ui/view/legend.h"
#include "ui/view/picture_text.h"

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <stdexcept>
#include <utility>

namespace hanei {

PictureExport::PictureExport(std::function<void()> wake, double patience)
    : packing_(std::move(wake), patience, [this](const std::string& fault) { fault_ = fault; }) {}

PictureRequest captioned(PictureRequest request, const Solution& solution) {
    if (request.caption.empty()) return request;
    const Caption whole = caption_of(solution, request.options);
    request.caption = fmt::format("{}  ·  {}\n{}", request.caption, whole.title, whole.detail);
    return request;
}

void PictureExport::start(std::vector<PictureJob> jobs) {
    cancel();
    jobs_.assign(std::make_move_iterator(jobs.begin()), std::make_move_iterator(jobs.end()));
    total_ = jobs_.size();
    written_ = 0;
    left_ = {};
}

void PictureExport::cancel() {
    jobs_.clear();
    packing_.cancel();
}

bool PictureExport::wants_unshadowed() const {
    return std::any_of(jobs_.begin(), jobs_.end(),
                       [](const PictureJob& job) { return job.four || job.part == LightPart::unshadowed; });
}

Task PictureExport::task() {
    const float done = static_cast<float>(written_) / static_cast<float>(std::max<std::size_t>(1, total_));
    return {"export", fmt::format(fmt::runtime(tr("Exporting {} of {}")), std::min(written_ + 1, total_), total_), done,
            left_.text(Stage::idle, done), [this] { cancel(); }};
}

/// Of what was packed until now.
PictureExport::Outcome PictureExport::outcome() {
    Outcome ended;
    if (!fault_.empty()) {
        jobs_.clear();
        ended.fault.emplace().message = std::exchange(fault_, {});
    } else if (total_ > 0 && written_ == total_) {
        ended.message =
            written_ == 1 ? fmt::format("Exported {}", last_) : fmt::format("Exported {} pictures", written_);
        total_ = 0;
    }
    return ended;
}

PictureExport::Outcome PictureExport::step(const SolutionSnapshot& solution, bool is_fresh, const PictureRequest& base,
                                           const std::function<std::string()>& project_hash) {
    packing_.follow();
    if (packing_.busy() || jobs_.empty() || !fault_.empty() || !solution || !is_fresh) return outcome();
    const PictureJob job = jobs_.front();
    jobs_.pop_front();
    try {
        write(solution, base, job, project_hash());
    } catch (const std::runtime_error& fault) {
        fault_ = fault.what();
    }
    return outcome();
}

void PictureExport::write(const SolutionSnapshot& solution, PictureRequest request, const PictureJob& job,
                          const std::string& hash) {
    request.size = job.size;
    request.options.part = job.part;
    request.annotated = job.has_legend || job.has_caption;
    request.has_legend = job.has_legend;
    request.has_caption = job.has_caption;
    request.has_scale_bar = job.has_scale_bar;
    request.has_axes = job.has_axes;
    request = captioned(std::move(request), *solution);
    const auto image =
        std::make_shared<const Image>(job.four ? render_four_up(solution, request) : render_picture(solution, request));
    const auto text = picture_text(*solution, request.options, hash, std::chrono::system_clock::now());
    packing_.start({}, [this, image, text, file = job.file](const Work& work) {
        const std::string bytes = png_bytes(*image, text);
        if (work.stop.stop_requested()) throw Stopped{};
        if (const auto reason = write_whole_file(file, bytes)) throw std::runtime_error(file.string() + ": " + *reason);
        return [this, file] {
            ++written_;
            last_ = file.filename().string();
        };
    });
}

}  // namespace hanei
