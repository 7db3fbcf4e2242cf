#include "engine/edit/arrangements.h"
#include "engine/edit/hanging.h"
#include "engine/edit/luminaire_edits.h"
#include "ui/panels/hanging.h"
#include "ui/panels/workbench.h"

#include <imgui.h>

namespace hanei {

void Workbench::light_tab() {
    const SceneSnapshot scene = document_.shown();
    LightPanel::Outcome outcome = light_.draw(*scene, selection_, widgets_);
    form_.begin("start layout");
    StartLayoutDialog::Correction correction = start_layout_.compare(*scene, study_.answer(), form_);
    form_.end();
    if (outcome.chosen) selection_.choose(*outcome.chosen);
    if (correction.scene) return document_.commit(std::move(*correction.scene), std::move(correction.step));
    if (!outcome.scene) return;
    if (outcome.at_once)
        document_.commit(std::move(*outcome.scene), std::move(outcome.step));
    else
        propose(std::move(*outcome.scene), std::move(outcome.step));
}

/// An arrangement of luminaires like the chosen one; of one from a file when none is chosen.
void Workbench::lay_out_luminaires(CommandId id) {
    const Scene& scene = *document_.shown();
    if (find_luminaire(scene, selection_.primary())) return arrange(selection_.primary(), id);
    Arrival arrival;
    arrival.place = place_in_plan(scene, {}, raster());
    arrival.then = [this, id](ObjectId luminaire) { arrange(luminaire, id); };
    add_luminaire_file(std::move(arrival));
}

void Workbench::arrange(ObjectId luminaire, CommandId id) {
    const Scene& scene = *document_.shown();
    if (id == CommandId::light_layout) return start_layout_.open(luminaire);
    const Luminaire* const found = find_luminaire(scene, luminaire);
    if (!found) return;
    const double z = found->position.z;
    constexpr int in_a_line = 3, columns = 4, rows = 3, in_a_circle = 6;
    if (id == CommandId::light_line)
        return add(arranged(scene, luminaire, line_over_room(scene, z, in_a_line)), "Add line of luminaires");
    if (id == CommandId::light_field)
        return add(arranged(scene, luminaire, field_over_room(scene, z, columns, rows)), "Add field of luminaires");
    add(arranged(scene, luminaire, circle_in_room(scene, z, in_a_circle)), "Add circle of luminaires");
}

}  // namespace hanei
