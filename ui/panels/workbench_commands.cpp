#include "engine/scene/faces.h"
#include "ui/panels/edit.h"
#include "ui/panels/workbench.h"
#include "ui/view/offscreen.h"

#include <imgui.h>
#include <stdexcept>

namespace hanei {

std::filesystem::path Workbench::folder() const {
    return document_.file().empty() ? std::filesystem::path()
                                    : std::filesystem::absolute(document_.file()).parent_path();
}

bool Workbench::can(CommandId id) const {
    const ObjectKind kind = kind_of(*document_.shown(), selected_);
    switch (id) {
        case CommandId::undo:
            return document_.history().can_undo();
        case CommandId::redo:
            return document_.history().can_redo();
        case CommandId::duplicate:
            return can_remove(kind);
        case CommandId::remove:
            return can_remove(kind);
        case CommandId::deselect:
            return static_cast<bool>(selected_) || study_.is_cancellable();
        case CommandId::nudge_left:
        case CommandId::nudge_right:
        case CommandId::nudge_down:
        case CommandId::nudge_up:
        case CommandId::nudge_lower:
        case CommandId::nudge_higher:
        case CommandId::look_at_selection:
            return place_of(*document_.shown(), selected_).has_value();
        case CommandId::turn_object:
            return kind == ObjectKind::luminaire || kind == ObjectKind::furniture;
        case CommandId::turn_intensities: {
            const Luminaire* luminaire = find_luminaire(*document_.shown(), selected_);
            return luminaire != nullptr && photometry_of(*document_.shown(), *luminaire) != nullptr;
        }
        case CommandId::fit_range:
        case CommandId::export_picture:
            return study_.solution() != nullptr;
        case CommandId::render_exact:
            return study_.fresh() && !viewport_.state.options.shadow_classes &&
                   has_part(*study_.solution(), viewport_.state.options.part);
        default:
            return true;
    }
}

void Workbench::add(Added added, const char* step) {
    document_.commit(std::move(added.scene), step);
    selected_ = added.object;
}

void Workbench::nudge(const Vec3& direction) {
    const double step = ImGui::GetIO().KeyShift ? 0.01 : 0.1;
    const std::string name = "Move " + std::string(name_of(kind_of(*document_.shown(), selected_)));
    document_.commit(moved(*document_.shown(), selected_, step * direction), name);
}

void Workbench::carry_out(CommandId id) {
    ViewState& view = viewport_.state;
    const Scene& scene = *document_.shown();
    const auto show = [&](LightPart part) {
        view.options.part = part;
        view.options.shadow_classes = false;
        view.four_up = false;
    };
    switch (id) {
        case CommandId::open:
            return guarded([this] { open_file(); });
        case CommandId::save:
            return save(false);
        case CommandId::save_as:
            return save(true);
        case CommandId::export_picture:
            return ask_for_picture();
        case CommandId::render_exact:
            return exact_.start(study_.solution(), picture_request());
        case CommandId::quit:
            return ask_to_quit();
        case CommandId::undo:
            return document_.undo();
        case CommandId::redo:
            return document_.redo();
        case CommandId::duplicate:
            return add(duplicated(scene, selected_), "Duplicate");
        case CommandId::remove:
            document_.commit(removed(scene, selected_), "Delete " + display_name(scene, selected_));
            selected_ = {};
            return;
        case CommandId::deselect:
            if (!selected_) return study_.cancel();
            selected_ = {};
            return;
        case CommandId::toggle_snap:
            snaps_ = !snaps_;
            return;
        case CommandId::nudge_left:
            return nudge({-1.0, 0.0, 0.0});
        case CommandId::nudge_right:
            return nudge({1.0, 0.0, 0.0});
        case CommandId::nudge_down:
            return nudge({0.0, -1.0, 0.0});
        case CommandId::nudge_up:
            return nudge({0.0, 1.0, 0.0});
        case CommandId::nudge_lower:
            return nudge({0.0, 0.0, -1.0});
        case CommandId::nudge_higher:
            return nudge({0.0, 0.0, 1.0});
        case CommandId::turn_object:
            document_.commit(turned_by_a_quarter(scene, selected_),
                             "Turn " + std::string(name_of(kind_of(scene, selected_))) + " by 90 degrees");
            return;
        case CommandId::turn_intensities: {
            Photometry turned = turned_by_a_quarter(*photometry_of(scene, *find_luminaire(scene, selected_)));
            document_.commit(with_photometry(scene, selected_, std::move(turned), photometry_.reaches_all()),
                             "Turn intensities by 90 degrees");
            return;
        }
        case CommandId::add_point_luminaire:
            return add(with_point_luminaire(scene), "Add point luminaire");
        case CommandId::add_line_luminaire:
            return add(with_line_luminaire(scene), "Add line luminaire");
        case CommandId::add_panel_luminaire:
            return add(with_panel_luminaire(scene), "Add panel luminaire");
        case CommandId::add_luminaire_file:
            return add_luminaire_file();
        case CommandId::add_box:
            return add(with_box(scene), "Add box");
        case CommandId::add_grid:
            return add(with_grid(scene), "Add calculation grid");
        case CommandId::add_calculation_point:
            return add(with_calculation_point(scene), "Add calculation point");
        case CommandId::show_overview:
            return viewport_.show_overview(scene);
        case CommandId::show_plan:
            return viewport_.show_plan(scene);
        case CommandId::look_at_selection:
            return viewport_.look_at(*place_of(scene, selected_));
        case CommandId::save_view: {
            Scene wished = scene;
            View kept = view_of(view.camera, "View " + std::to_string(scene.views.size() + 1));
            kept.id = wished.new_id();
            wished.views.push_back(std::move(kept));
            document_.commit(std::move(wished), "Keep view");
            return;
        }
        case CommandId::part_total:
            return show(LightPart::total);
        case CommandId::part_direct:
            return show(LightPart::direct);
        case CommandId::part_interreflected:
            return show(LightPart::interreflected);
        case CommandId::part_unshadowed:
            return show(LightPart::unshadowed);
        case CommandId::four_up:
            view.four_up = !view.four_up;
            return;
        case CommandId::toggle_photo:
            view.options.scale = view.options.scale == Scale::photo ? Scale::false_colour : Scale::photo;
            return;
        case CommandId::toggle_shadow_classes:
            view.options.shadow_classes = view.four_up || !view.options.shadow_classes;
            view.four_up = false;
            return;
        case CommandId::toggle_shadow_outlines:
            view.options.shadow_outlines = !view.options.shadow_outlines;
            return;
        case CommandId::toggle_isolux:
            view.options.isolux = !view.options.isolux;
            return;
        case CommandId::toggle_mesh:
            view.options.mesh_lines = !view.options.mesh_lines;
            return;
        case CommandId::toggle_grids:
            view.options.grids = !view.options.grids;
            return;
        case CommandId::toggle_body:
            view.photometric_body = !view.photometric_body;
            return;
        case CommandId::fit_range:
            view.options.range = suggested_range(*study_.solution());
            return;
        case CommandId::show_keys:
            return dialogs_.show_keys();
        case CommandId::show_about:
            return dialogs_.show_about();
    }
}

}  // namespace hanei
