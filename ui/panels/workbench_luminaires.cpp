#include "engine/edit/hanging.h"
#include "engine/scene/colour.h"
#include "ui/panels/hanging.h"
#include "ui/panels/language.h"
#include "ui/panels/luminaire_batch.h"
#include "ui/panels/workbench.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

std::string name_of_light(const Photometry& photometry) {
    return photometry.name.empty() ? photometry.source_file : photometry.name;
}

}  // namespace

void Workbench::add_luminaire_file(Arrival arrival) {
    browser_.open({"Add a luminaire", "Add", luminaire_endings(), false, folder(), ""},
                  [this, arrival = std::move(arrival)](const std::filesystem::path& file) {
                      Arrival named = arrival;
                      named.files = {file};
                      receive(std::move(named));
                  });
}

void Workbench::replace_luminaire_file() {
    browser_.open({"Use another luminaire file", "Use", luminaire_endings(), false, folder(), ""},
                  [this](const std::filesystem::path& file) {
                      receive({{file}, {}, {}, {}, selection_.primary(), {}});
                  });
}

/// On the view files hang where they are dropped; on the luminaire that is chosen, or beside the
/// view while one is chosen, they may take the place of its light.
void Workbench::drop(const std::vector<std::filesystem::path>& files) {
    start_page_.leave();  // what is dropped on it is what to begin with
    if (is_asking() || viewport_.dragging()) {
        message_ = tr("Nothing was dropped: finish what is open first");
        return;
    }
    document_.settle();
    const auto project =
        std::find_if(files.begin(), files.end(), [](const auto& file) { return ending_of(file) == ".hanei"; });
    if (project != files.end()) return guarded([this, file = *project] { load(file); });
    const SceneSnapshot scene = document_.shown();
    const Viewport::Pointed pointed = viewport_.pointed(*scene, ImGui::GetIO().MousePos);
    Arrival arrival{{files.begin(), files.end()}, {}, {}, place_in_plan(*scene, pointed.ray, raster()), {}, {}};
    const bool on_luminaire = find_luminaire(*scene, selection_.primary()) != nullptr;
    const bool on_chosen = on_luminaire && pointed.object == selection_.primary();
    const bool is_model = ending_of(files.front()) == ".gltf" || ending_of(files.front()) == ".glb";
    const bool beside_view = on_luminaire && !pointed.ray && ImGui::GetIO().MousePos.x > viewport_.right_edge();
    const bool on_view = !on_chosen && !beside_view;
    if (files.size() == 1 && is_model && on_view && door_.read_model)
        return ask_about_model(files.front(), true, std::move(arrival));
    if (files.size() > 1 || !(on_chosen || beside_view)) return receive(std::move(arrival));
    Arrival instead = arrival;
    instead.replaced = selection_.primary();
    if (beside_view || ImGui::GetIO().KeyShift) return receive(std::move(instead));
    const std::string name = display_name(*scene, selection_.primary());
    dialogs_.ask_choice(tr("Dropped on a luminaire"),
                        say("{} was dropped on {}.", files.front().filename().string(), name),
                        {say("Give its light to {}", name), tr("Hang a luminaire of it here")},
                        [this, arrival, instead](std::size_t k) { receive(k == 0 ? instead : arrival); });
}

void Workbench::receive(Arrival arrival) {
    arrival_ = std::move(arrival);
    read_next();
}

/// Reads file after file, those of folders too; one that holds several luminaires waits for an answer.
void Workbench::read_next() {
    const std::string name = arrival_.files.empty() ? std::string() : arrival_.files.front().filename().string();
    const std::string task =
        arrival_.files.size() > 1 ? say("Reading {} files", arrival_.files.size()) : say("Reading {}", name);
    file_work_.start(task, [this, files = arrival_.files, read = door_.read_luminaires](const Work& work) {
        const auto batch = std::make_shared<LuminaireBatch>(read_luminaire_files(files, read, work));
        return [this, batch] {
            arrival_.files = std::move(batch->left);
            std::move(batch->faults.begin(), batch->faults.end(), std::back_inserter(arrival_.faults));
            std::move(batch->read.begin(), batch->read.end(), std::back_inserter(arrival_.read));
            batch->several.empty() ? finish_arrival() : ask_which(batch->file, std::move(batch->several));
        };
    });
}

void Workbench::ask_which(const std::filesystem::path& file, std::vector<Photometry> found) {
    std::vector<std::string> entries;
    for (const Photometry& photometry : found) entries.push_back(name_of_light(photometry));
    if (!arrival_.replaced) entries.push_back(say("All {}", found.size()));
    const std::string text = say("{} holds {} luminaires.", file.filename().string(), found.size());
    const auto take = [this, found = std::move(found)](std::size_t k) {
        if (k < found.size())
            arrival_.read.push_back(found[k]);
        else
            arrival_.read.insert(arrival_.read.end(), found.begin(), found.end());
        read_next();
    };
    dialogs_.ask_choice(tr("Which luminaire?"), text, std::move(entries), take);
}

void Workbench::finish_arrival() {
    Arrival arrival = std::exchange(arrival_, {});
    if (!arrival.faults.empty()) {
        messages_.note("Luminaire file", arrival.faults);
        message_ = arrival.faults.front().place.file.empty()
                       ? tr("A file cannot be used")
                       : say("{} cannot be used",
                             std::filesystem::path(arrival.faults.front().place.file).filename().string());
        dialogs_.show_findings(
            tr(arrival.read.empty() ? "This luminaire file cannot be used" : "Not everything could be used"),
            std::move(arrival.faults));
    }
    if (arrival.read.empty()) return;
    std::size_t remarks = 0;
    for (const Photometry& photometry : arrival.read) remarks += photometry.warnings.size();
    const std::string light = name_of_light(arrival.read.front());
    const std::optional<double> kelvin = stated_colour_temperature(arrival.read.front());
    const std::size_t count = arrival.read.size();
    if (arrival.replaced) {
        document_.commit(with_other_file(*document_.shown(), arrival.replaced, std::move(arrival.read.front()),
                                         photometry_.reaches_all()),
                         "Use another luminaire file");
        message_ = say("{} shines as {}", display_name(*document_.shown(), arrival.replaced), light);
    } else {
        add(with_measured_luminaires(*document_.shown(), std::move(arrival.read), arrival.place),
            count == 1 ? "Add luminaire from file" : "Add luminaires from files");
        message_ = count == 1 ? say("Hung {}", light) : say("Hung {} luminaires", count);
        if (arrival.then) arrival.then(selection_.primary());
    }
    if (kelvin && count == 1) message_ += say(" · {:g} K as its file states", *kelvin);
    if (remarks > 0) message_ += say(remarks == 1 ? " · {} remark on its file" : " · {} remarks on its file", remarks);
}

}  // namespace hanei
