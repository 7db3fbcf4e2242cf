/// Pictures on their way to files, one a frame, so that the window stays alive and can stop them.
#pragma once

#include "engine/base/diagnostic.h"
#include "ui/panels/background_work.h"
#include "ui/view/offscreen.h"

#include <deque>
#include <functional>
#include <optional>

namespace hanei {

struct PictureJob {
    std::filesystem::path file;
    LightPart part = LightPart::total;
    bool four = false;  ///< all four parts in one picture
    PixelSize size;
    bool has_legend = true, has_caption = true;
    bool has_scale_bar = true, has_axes = false;
};

/// With the caption of the solution behind the name of the kept state, which stood there alone.
PictureRequest captioned(PictureRequest request, const Solution& solution);

class PictureExport {
public:
    /// As those of BackgroundWork: pictures are packed and written away from the frames.
    PictureExport(std::function<void()> wake, double patience);

    void start(std::vector<PictureJob> jobs);
    void cancel();  ///< what is written stays; the picture that is being packed is not written
    bool busy() const { return !jobs_.empty() || packing_.busy() || !fault_.empty(); }

    /// Whether a picture waits for the part that is only computed on request.
    bool wants_unshadowed() const;
    Task task();

    struct Outcome {
        std::string message;              ///< what was exported, when the last picture is done
        std::optional<Diagnostic> fault;  ///< why it ended early
    };
    /// After a frame was painted: draws and writes the next picture, once the solution is whole. `base` is the
    /// picture as the window shows it, its caption the kept state that it shows, if it does.
    /// Needs     an OpenGL context.
    Outcome step(const SolutionSnapshot& solution, bool is_fresh, const PictureRequest& base,
                 const std::function<std::string()>& project_hash);

private:
    void write(const SolutionSnapshot& solution, PictureRequest request, const PictureJob& job,
               const std::string& hash);
    Outcome outcome();

    std::deque<PictureJob> jobs_;  ///< not drawn yet
    std::size_t total_ = 0, written_ = 0;
    std::string last_, fault_;
    TimeLeft left_;
    BackgroundWork packing_;
};

}  // namespace hanei
