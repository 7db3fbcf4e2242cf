#include "ui/panels/luminaire_batch.h"

#include <algorithm>
#include <cctype>

namespace hanei {
namespace {

namespace fs = std::filesystem;

void open_folders(std::deque<fs::path>& files) {
    const std::vector<std::string> endings = luminaire_endings();
    std::deque<fs::path> all;
    for (const fs::path& file : files) {
        std::error_code none;
        if (!fs::is_directory(file, none)) {
            all.push_back(file);
            continue;
        }
        std::vector<fs::path> inside;
        for (const auto& entry : fs::directory_iterator(file, none))
            if (entry.is_regular_file(none) &&
                std::find(endings.begin(), endings.end(), ending_of(entry.path())) != endings.end())
                inside.push_back(entry.path());
        std::sort(inside.begin(), inside.end());
        if (inside.empty()) inside.push_back(file);  // reading says what is wrong with it
        all.insert(all.end(), inside.begin(), inside.end());
    }
    files = std::move(all);
}

}  // namespace

std::vector<std::string> luminaire_endings() { return {".ies", ".ldt", ".xml", ".gldf", ".gltf", ".glb"}; }

std::string ending_of(const fs::path& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return ending;
}

LuminaireBatch read_luminaire_files(std::deque<fs::path> files, const decltype(ProjectDoor::read_luminaires)& read,
                                    const Work& work) {
    LuminaireBatch batch;
    open_folders(files);
    const std::size_t count = files.size();
    while (!files.empty() && batch.several.empty() && !work.stop.stop_requested()) {
        if (work.progress != nullptr)
            work.progress->advance(1.0F - static_cast<float>(files.size()) / static_cast<float>(count));
        batch.file = files.front();
        files.pop_front();
        Opened<std::vector<Photometry>> opened = read(batch.file);
        const bool unusable = !opened.content || opened.content->empty();
        for (Diagnostic& finding : opened.findings)
            if (unusable || finding.severity == Severity::error) batch.faults.push_back(std::move(finding));
        if (unusable) continue;
        std::vector<Photometry>& found = *opened.content;
        if (found.size() > 1)
            batch.several = std::move(found);
        else
            batch.read.push_back(std::move(found.front()));
    }
    batch.left = std::move(files);
    return batch;
}

}  // namespace hanei
