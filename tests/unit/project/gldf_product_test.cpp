#include "engine/project/gldf_product.h"

#include "engine/project/gldf_luminaires.h"
#include "engine/scene/colour.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

/// A product of one emitter below these definitions, which make no finding.
GldfListing product(const std::string& definitions, const std::string& emitter) {
    LuminaireFindings findings("product.xml");
    const std::string text = "<Root><GeneralDefinitions>" + definitions + "<Emitters><Emitter id=\"e\">" + emitter +
                             "</Emitter></Emitters></GeneralDefinitions></Root>";
    GldfListing listing = read_gldf_product(text, findings);
    for (const Diagnostic& finding : findings.diagnostics()) ADD_FAILURE() << to_text(finding);
    return listing;
}

std::string source(const std::string& kind, const std::string& kelvin) {
    return "<LightSources><" + kind + " id=\"s\"><ColorInformation><CorrelatedColorTemperature>" + kelvin +
           "</CorrelatedColorTemperature></ColorInformation></" + kind + "></LightSources>";
}

const std::string fixed_emitter =
    "<FixedLightEmitter><PhotometryReference photometryId=\"p\"/><LightSourceReference fixedLightSourceId=\"s\"/>"
    "</FixedLightEmitter>";

TEST(GldfProduct, states_the_colour_temperature_of_a_fixed_light_source) {
    const GldfListing listing = product(source("FixedLightSource", "3000"), fixed_emitter);
    ASSERT_EQ(listing.emitters.size(), 1U);
    EXPECT_EQ(listing.emitters[0].colour_temperature, 3000.0);
}

TEST(GldfProduct, states_the_colour_temperature_of_the_lamps_of_an_equipment) {
    const GldfListing listing =
        product(source("ChangeableLightSource", "4000") +
                    "<Equipments><Equipment id=\"q\"><LightSourceReference changeableLightSourceId=\"s\"/></Equipment>"
                    "</Equipments>",
                "<ChangeableLightEmitter><EquipmentReference equipmentId=\"q\"/></ChangeableLightEmitter>");
    ASSERT_EQ(listing.emitters.size(), 1U);
    EXPECT_EQ(listing.emitters[0].colour_temperature, 4000.0);
}

TEST(GldfProduct, hands_the_colour_temperature_to_the_luminaire) {
    GldfListing listing = product(source("FixedLightSource", "3000"), fixed_emitter);
    Photometry lamp;
    lamp.horizontal_deg = {0.0};
    lamp.vertical_deg = {0.0, 90.0};
    lamp.candela = {100.0, 0.0};
    lamp.lamp_sets.resize(1);
    lamp.lamp_sets[0].colour = "4000";
    listing.photometries.push_back({"p", "f", lamp, {}});
    std::vector<NamedPhotometry> luminaires;
    Diagnostics findings;
    name_luminaires(listing, "lamp.gldf", luminaires, findings);
    ASSERT_EQ(luminaires.size(), 1U);
    EXPECT_EQ(stated_colour_temperature(luminaires[0].photometry), 3000.0) << "the container goes before the file";
}

}  // namespace
}  // namespace hanei
