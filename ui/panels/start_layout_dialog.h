/// Asks how bright a room shall be and hangs as many luminaires as that needs.
#pragma once

#include "engine/edit/start_layout.h"
#include "engine/solution/solution.h"
#include "ui/panels/form.h"

#include <optional>
#include <string>
#include <vector>

namespace hanei {

/// The lumen method's wish in a dialog, its answer beside it while it is changed; and afterwards what
/// the real solution says to it.
class StartLayoutDialog {
public:
    void open(ObjectId luminaire);
    bool is_open() const { return open_; }

    /// In front of everything, while it is open. What it gives back is one step.
    std::optional<Added> draw(const Scene& scene, Form& form);

    /// Rows that compare what was predicted with what is computed, and offer to correct it.
    struct Correction {
        std::optional<Scene> scene;
        std::string step;
    };
    Correction compare(const Scene& scene, const SolutionSnapshot& answer, Form& form);

private:
    bool rows(const Scene& scene, Form& form);
    void figures(const Scene& scene, Form& form) const;
    void answer_anew(const Scene& scene);
    void recall(const Scene& scene);
    std::vector<ObjectId> offered(const Scene& scene) const;

    LumenWish wish_;
    LumenAnswer answer_;
    ObjectId luminaire_;
    bool open_ = false, opening_ = false;
    bool is_other_ = false;  ///< than the luminaire of the last time

    /// What was hung last.
    struct Made {
        ObjectId arrangement;
        LumenWish wish;
        double predicted = 0.0;  ///< lx
    };
    std::optional<Made> made_;
};

}  // namespace hanei
