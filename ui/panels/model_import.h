/// The question how a model of another program is to be read, and what comes of it, before it is taken.
#pragma once

#include "ui/panels/form.h"
#include "ui/panels/project_door.h"
#include "ui/panels/task_bar.h"

#include <functional>
#include <string>

namespace hanei {

class ModelImport {
public:
    /// instead: of all that the project holds; new_project: beside it, in one of its own.
    enum class Where { middle, pointer, as_drawn, instead, new_project };

    struct Taken {
        std::filesystem::path file;
        ModelContent content;
        Diagnostics findings;
        Where where = Where::as_drawn;
        Vec2 place{0.0};  ///< in the plan, for middle and pointer
    };
    using Then = std::function<void(Opened<ModelContent>)>;
    using Read = std::function<void(const ModelReading&, Then)>;

    /// `read` is asked again whenever the answers change and calls back when it has read; `taken` is called once, never
    /// when the user thinks better of it. `dropped`: the place is where the pointer was.
    void open(const std::filesystem::path& file, Opened<ModelContent> first, Read read, Vec2 place, bool dropped,
              std::function<void(Taken)> taken);
    bool is_open() const { return open_; }

    /// Draws the question while it is open. Once a frame. `reading`: how far it is, while the file is read; when
    /// that ends without an outcome, the answers are those of before.
    void draw(Form& form, const std::optional<Task>& reading);

    /// What is shown, for scripts: "1.6 x 0.8 x 0.74 m, 3 solids, ..."; empty while closed.
    std::string summary() const;

private:
    bool choices(Form& form);
    void place_choice(Form& form);
    void facts(Form& form) const;
    void remarks() const;
    bool can_take() const { return opened_.content.has_value() && reading_ == read_as_; }

    std::filesystem::path file_;
    Opened<ModelContent> opened_;
    ModelReading reading_, read_as_;  ///< as is wished, and as what is shown was read
    Read read_;
    Where where_ = Where::as_drawn;
    Vec2 place_{0.0};
    bool dropped_ = false;
    std::function<void(Taken)> taken_;
    bool open_ = false, just_opened_ = false;
};

}  // namespace hanei
