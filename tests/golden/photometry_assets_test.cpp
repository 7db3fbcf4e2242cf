// The luminaires the program brings with it.

#include "engine/project/luminaire_file.h"
#include "engine/scene/intensity.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>

namespace hanei {
namespace {

std::vector<Photometry> own_luminaires() {
    std::vector<Photometry> photometries;
    for (const auto& file :
         std::filesystem::directory_iterator{std::filesystem::path{HANEI_SOURCE} / "assets/photometry"}) {
        if (file.path().extension() != ".ies") continue;
        const LuminaireFileRead read = read_luminaire_file(file.path());
        EXPECT_TRUE(read.photometry) << file.path();
        EXPECT_TRUE(read.findings.empty()) << to_text(read.findings.front());
        if (read.photometry) photometries.push_back(*read.photometry);
    }
    return photometries;
}

TEST(OwnLuminaires, are_four_and_read_without_a_warning) { EXPECT_EQ(own_luminaires().size(), 4U); }

TEST(OwnLuminaires, give_the_lumens_they_declare) {
    for (const Photometry& photometry : own_luminaires()) {
        // two decimals of figures around 1000 cd: 1e-5
        EXPECT_NEAR(luminous_flux(photometry).value / photometry.lamp_lumens, 1.0, 1e-4) << photometry.name;
    }
}

TEST(OwnLuminaires, state_their_formula) {
    for (const Photometry& photometry : own_luminaires()) {
        const auto formula = [](const auto& keyword) {
            return keyword.first == "OTHER" && keyword.second.find("I = k ") != std::string::npos;
        };
        EXPECT_TRUE(std::any_of(photometry.keywords.begin(), photometry.keywords.end(), formula)) << photometry.name;
    }
}

}  // namespace
}  // namespace hanei
