#include "ui/panels/checks.h"
#include "ui/panels/language.h"
#include "ui/panels/workbench.h"

namespace hanei {

/// Asks for a table of others, reads it and computes our values there beside the frames.
void Workbench::compare_measured() {
    browser_.open({"Compare with measured values", "Compare", {".csv", ".txt", ".tsv"}, false, folder(), ""},
                  [this](const std::filesystem::path& file) {
                      const SolutionSnapshot answer = study_.answer();
                      if (!answer) return;
                      file_work_.start(say("Comparing {}", file.filename().string()),
                                       [this, file, answer, read = door_.read_measured](const Work& work) {
                                           auto opened = read(file);
                                           auto made = std::make_shared<MeasuredComparison>();
                                           if (opened.content)
                                               *made = compared_with(*answer, *opened.content, work.stop);
                                           Diagnostics faults = opened.content ? made->faults : opened.findings;
                                           return [this, made, faults] {
                                               if (!faults.empty())
                                                   return dialogs_.show_findings("Compare with measured values",
                                                                                 faults);
                                               if (!made->sets.empty()) checks_->measured.open(made);
                                           };
                                       });
                  });
}

}  // namespace hanei
