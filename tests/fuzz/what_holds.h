/// What must hold of anything a reader accepts, and of anything it refuses, whatever the bytes were.
/// A fault stops the program: the fuzzer then keeps the input.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/project/luminaire_findings.h"
#include "engine/project/project_file.h"
#include "engine/scene/photometry.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace hanei {

/// The fuzzer's bytes as the readers take them.
std::string_view text_of(const std::uint8_t* bytes, std::size_t count);

/// Every finding is a sentence, and there is an error exactly when the file was refused.
void check_findings(const Diagnostics& findings, bool accepted);

/// A table that hangs together, figures that are finite, intensities and flux that are finite and not
/// negative, downward flux that is no more than all of it, and a project that gives it back.
void check_photometry(const Photometry& photometry);

/// The project's text reads back as an equal project.
void check_project(const Project& project);

/// One of the readers of luminaire files, as the common door calls it.
using LuminaireReader = std::vector<Photometry> (*)(std::string_view text, LuminaireFindings& findings);
void check_reader(LuminaireReader reader, const std::uint8_t* bytes, std::size_t count);

}  // namespace hanei

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count);
