/// What shall be exported, how large and under which names.
#pragma once

#include "ui/panels/form.h"
#include "ui/panels/picture_export.h"
#include "ui/panels/picture_name.h"

#include <array>
#include <optional>

namespace hanei {

class ExportDialog {
public:
    struct Context {
        std::string project, view;          ///< for names
        LightPart part = LightPart::total;  ///< shown
        bool four = false;
        PixelSize view_size;  ///< of the view on the screen
    };

    void open(const std::filesystem::path& folder, std::string name_template);
    bool is_open() const { return open_; }
    const std::string& name_template() const { return template_; }

    /// Once a frame, with a form that no other panel has open. Returns the pictures when the user wants them.
    std::optional<std::vector<PictureJob>> draw(const Context& context, Form& form);

private:
    enum class What { view, four, parts };
    std::vector<PictureJob> jobs(const Context& context, std::string& fault) const;
    PixelSize size(const Context& context) const;
    void fields(const Context& context, Form& form);
    bool preview(const std::vector<PictureJob>& jobs, const std::string& fault, WidgetRegistry& widgets) const;

    bool open_ = false, opening_ = false;
    What what_ = What::view;
    std::array<bool, 4> parts_{true, true, true, false};
    int size_ = 0;  ///< as the view, twice, 4K, own
    double own_width_ = 1600.0, own_height_ = 1000.0;
    bool legend_ = true, caption_ = true, scale_bar_ = true, axes_ = false;
    std::string folder_, template_{usual_name_template};
    std::chrono::system_clock::time_point opened_at_;
};

}  // namespace hanei
