/// GLDF containers (.gldf, gldf.io): a product, its variants, their emitters and the photometry of each.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/project/luminaires.h"
#include "engine/scene/photometry.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hanei {

/// A file that the product names. One of type "url" lies elsewhere and is never fetched.
struct GldfFile {
    std::string id;
    std::string content_type;  ///< "ldc/eulumdat", "ldc/ies", "ldc/iesxml" (TM-33), "sensor/sensldt", ...
    std::string type;          ///< "localFileName" or "url"
    std::string name;
    std::string entry;  ///< its place in the container; empty for a url
    bool present = false;
    bool operator==(const GldfFile&) const = default;
};

struct GldfPhotometry {
    std::string id;
    std::string file;                      ///< id of its file
    std::optional<Photometry> photometry;  ///< as its file says; read when an emitter asks for it
    std::string fault;                     ///< why there is none
};

/// One way to operate an emitter. Those of one emitter are alternatives.
struct GldfEmitter {
    std::string id;
    std::string kind;  ///< "FixedLightEmitter", "ChangeableLightEmitter", "MultiChannelLightEmitter", "SensorEmitter"
    std::string name;  ///< the emitter's, or the channel's
    std::string photometry;                    ///< id; empty for a sensor
    std::optional<double> rated_flux;          ///< lm the luminaire emits
    std::optional<double> lamp_flux;           ///< lm of all its changeable lamps together
    std::optional<double> input_watts;         ///< of its light sources and gear
    std::optional<double> colour_temperature;  ///< K, of its light source
    std::string emergency;                     ///< "", "None", "EmergencyOnly", "Combined"
    double turn_deg = 0.0;                     ///< about the vertical (G0)
    bool tilted = false;                       ///< turned about other axes too, which a photometry cannot say
};

struct GldfVariant {
    std::string id;
    std::string name;
    std::vector<std::string> emitters;  ///< ids, each once
};

struct GldfListing {
    std::string manufacturer;
    std::string product;
    std::string format_version;  ///< "1.0-rc.3"
    std::vector<GldfFile> files;
    std::vector<GldfPhotometry> photometries;
    std::vector<GldfEmitter> emitters;  ///< those of one id follow one another
    std::vector<GldfVariant> variants;
    std::vector<std::string> orphans;  ///< entries that the product names nowhere, sorted
};

struct GldfRead {
    std::optional<GldfListing> listing;  ///< empty when the container or its product.xml cannot be read
    std::vector<NamedPhotometry> luminaires;
    Diagnostics findings;
};

/// Follows the chain variant, emitter, photometry, file. A luminaire is one emitter of one variant in one
/// of its ways to operate, named "variant / emitter"; a container without variants gives its emitters.
///
/// What the container says goes before the photometry (gldf.io, "GLDF over photometry"): the emitter's
/// rated flux is what the luminaire emits, so that intensities are scaled by rated over integrated flux;
/// changeable lamps replace those of the photometry, by their flux; rated power replaces the watts.
/// A change of more than 2 % is a warning of the luminaire. A turn about the vertical by quarters turns
/// the intensities; any other is a warning.
///
/// Returns   every luminaire whose photometry can be read; an error for each that cannot. At most 1000
///           luminaires and 20 million intensities: a warning says when there are more.
/// Cost      each photometry is inflated and read once.
GldfRead read_gldf(std::string_view bytes, std::string_view name);

}  // namespace hanei
