/// The effects plan in the window: what is simulated and who decided, what each effect could add, and what
/// it really adds and takes.
#pragma once

#include "engine/solution/solution.h"
#include "engine/study/effect_trials.h"
#include "ui/panels/task_bar.h"
#include "ui/panels/view_tool.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace hanei {

class EffectsPanel : public ViewOverlay {
public:
    EffectsPanel();
    ~EffectsPanel() override;

    void connect(std::function<void()> wake);  ///< who wants a frame when there is news

    struct Outcome {
        std::optional<Settings> settings;  ///< another choice of what is simulated
        std::optional<ObjectId> clicked;   ///< a piece of furniture
        bool starts = false;               ///< measure with and without each effect
    };
    /// The content of its tab. `measured` shows times; pictures that shall repeat leave them out.
    Outcome table(const Solution& solution, const Settings& settings, bool measured, WidgetRegistry& widgets);

    /// In the background; forgets what was measured before.
    void start(const SceneSnapshot& scene, const Settings& settings);
    void cancel();
    void begin_frame();
    bool busy() const;
    Task task();  ///< while it is busy

    const EffectTrials& trials() const;          ///< the last that ended; of none there is no time
    const std::vector<double>& pointed() const;  ///< lx at each calculation point, of the row under the pointer

    /// Of the row under the pointer: what it could add at each calculation point, as discs whose area is the bound.
    void draw(const PaneSight& sight, WidgetRegistry& widgets) override;

private:
    struct Parts;
    const EffectTrials* trials_of(const Solution& solution, const Settings& settings) const;
    void headline(const Solution& solution, const EffectTrials* trials, bool measured, Outcome& outcome,
                  WidgetRegistry& widgets);
    std::unique_ptr<Parts> parts_;
};

}  // namespace hanei
