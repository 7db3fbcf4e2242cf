#include "engine/project/gldf_luminaires.h"

#include "engine/project/number_text.h"
#include "engine/scene/colour.h"
#include "engine/scene/intensity.h"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <set>
#include <utility>

namespace hanei {
namespace {

constexpr std::size_t most_luminaires = 1000;
constexpr std::size_t most_intensities = 20'000'000;
constexpr std::size_t most_asked = 1'000'000;  // emitters of variants: where a product ends and an attack begins

void scale(Photometry& photometry, double share, const std::string& reason) {
    constexpr double noticed = 0.02;
    constexpr double most = 1e6;  // a lamp of a lumen for a stadium's: no product, and no figure gets infinite
    if (!(share < most && share > 1.0 / most)) {
        photometry.warnings.push_back(reason + "; they cannot be of one luminaire, and the photometry is kept");
        return;
    }
    for (double& candela : photometry.candela) candela *= share;
    photometry.candela_per_figure *= share;
    photometry.lamp_lumens *= share;
    for (LampSet& lamps : photometry.lamp_sets) lamps.lumens *= share;
    if (std::abs(share - 1.0) > noticed)
        photometry.warnings.push_back(fmt::format("{}; its intensities are multiplied by {:.4g}", reason, share));
}

void set_flux(const GldfEmitter& emitter, Photometry& photometry) {
    const double flux = luminous_flux(photometry).value;
    if (emitter.rated_flux && *emitter.rated_flux > 0.0 && flux > 0.0) {
        scale(photometry, *emitter.rated_flux / flux,
              fmt::format("the container rates the emitter at {:g} lm, the photometry has {:.1f} lm",
                          *emitter.rated_flux, flux));
    } else if (emitter.lamp_flux && *emitter.lamp_flux > 0.0 && photometry.lamp_lumens > 0.0) {
        scale(photometry, *emitter.lamp_flux / photometry.lamp_lumens,
              fmt::format("the container has lamps of {:g} lm, the photometry of {:g} lm", *emitter.lamp_flux,
                          photometry.lamp_lumens));
    }
}

void turn(const GldfEmitter& emitter, Photometry& photometry) {
    const double quarters = emitter.turn_deg / 90.0;
    if (emitter.tilted || quarters != std::floor(quarters) || std::abs(quarters) > 4.0) {
        photometry.warnings.emplace_back(
            "the container turns the emitter against the luminaire; turn the luminaire itself when it is placed");
    } else if (quarters != 0.0) {
        photometry.quarter_turns = (static_cast<int>(quarters) % 4 + 4) % 4;
    }
}

/// What the container says goes before what the photometry says.
Photometry with_product(const GldfListing& listing, const GldfVariant& variant, const GldfEmitter& emitter,
                        Photometry photometry) {
    set_flux(emitter, photometry);
    turn(emitter, photometry);
    if (emitter.input_watts) photometry.input_watts = *emitter.input_watts;
    std::vector<std::pair<std::string, std::string>> keywords;
    const auto add = [&keywords](const char* key, const std::string& text) {
        if (!text.empty()) keywords.emplace_back(key, text);
    };
    add("GLDF manufacturer", listing.manufacturer);
    add("GLDF product", listing.product);
    add("GLDF variant", variant.name);
    add("GLDF emitter", emitter.name.empty() ? emitter.id : emitter.name);
    add("GLDF emergency behaviour", emitter.emergency);
    if (emitter.rated_flux) add("GLDF rated flux", fmt::format("{} lm", *emitter.rated_flux));
    if (emitter.colour_temperature)
        add(std::string(colour_temperature_keyword).c_str(), fmt::format("{:g} K", *emitter.colour_temperature));
    photometry.keywords.insert(photometry.keywords.begin(), keywords.begin(), keywords.end());
    return photometry;
}

class Naming {
public:
    Naming(const GldfListing& listing, const std::string& file, std::vector<NamedPhotometry>& luminaires,
           Diagnostics& findings)
        : listing_(listing), file_(file), luminaires_(luminaires), findings_(findings) {
        for (const GldfPhotometry& photometry : listing.photometries) photometries_.emplace(photometry.id, &photometry);
        for (const GldfEmitter& emitter : listing.emitters) emitters_[emitter.id].push_back(&emitter);
    }

    void add_all() {
        if (listing_.variants.empty()) {
            GldfVariant all{"", listing_.product, {}};
            for (const auto& [id, ways] : emitters_) all.emitters.push_back(id);
            add_variant(all);
        }
        for (const GldfVariant& variant : listing_.variants) {
            if (asked_ <= most_asked) add_variant(variant);
        }
        if (left_out_ > 0)
            add(Severity::warning, "Variants",
                fmt::format("{} luminaires are left out: {} luminaires and {} intensities are read at most", left_out_,
                            most_luminaires, most_intensities));
        if (luminaires_.empty() && !has_errors(findings_))
            add(Severity::error, "Emitters", "the container has no light emitter with a photometry");
    }

private:
    void add(Severity severity, const std::string& field, std::string message) {
        if (!said_.insert(field + message).second) return;
        findings_.push_back({severity, {file_, 0, field, 0}, std::move(message)});
    }

    void add_variant(const GldfVariant& variant) {
        std::vector<const GldfEmitter*> usable;
        for (const std::string& id : variant.emitters) {
            const auto found = emitters_.find(id);
            if (found == emitters_.end()) {
                add(Severity::error, "EmitterReference", "the emitter " + in_quotes(id) + " is not defined");
                continue;
            }
            for (const GldfEmitter* emitter : found->second) {
                if (++asked_ > most_asked) break;
                if (photometry_of(*emitter) != nullptr) usable.push_back(emitter);
            }
        }
        for (std::size_t k = 0; k < usable.size(); ++k) add_luminaire(variant, *usable[k], k, usable.size());
    }

    /// Null, with the error that says so, when there is none.
    const Photometry* photometry_of(const GldfEmitter& emitter) {
        if (emitter.kind == "SensorEmitter") return nullptr;
        const auto found = photometries_.find(emitter.photometry);
        if (found != photometries_.end()) {
            const auto& photometry = found->second->photometry;
            return photometry ? &*photometry : nullptr;
        }
        add(Severity::error, "PhotometryReference",
            fmt::format("the emitter {} asks for the photometry {}, which is not defined", in_quotes(emitter.id),
                        in_quotes(emitter.photometry)));
        return nullptr;
    }

    void add_luminaire(const GldfVariant& variant, const GldfEmitter& emitter, std::size_t place, std::size_t count) {
        const Photometry& photometry = *photometry_of(emitter);
        if (luminaires_.size() >= most_luminaires || intensities_ + photometry.candela.size() > most_intensities) {
            ++left_out_;
            return;
        }
        intensities_ += photometry.candela.size();
        std::string name = variant.name.empty() ? variant.id : variant.name;
        if (count > 1 || name.empty()) name += (name.empty() ? "" : " / ") + way_name(emitter);
        if (emitter.emergency == "EmergencyOnly") name += ", emergency only";
        if (!names_.insert(name).second) name += fmt::format(" ({})", place + 1);
        NamedPhotometry& luminaire = luminaires_.emplace_back();
        luminaire.photometry = with_product(listing_, variant, emitter, photometry);
        luminaire.photometry.source_file = std::filesystem::path{file_}.filename().string();
        luminaire.photometry.name = name;
        luminaire.name = std::move(name);
    }

    static std::string way_name(const GldfEmitter& emitter) { return emitter.name.empty() ? emitter.id : emitter.name; }

    const GldfListing& listing_;
    const std::string& file_;
    std::vector<NamedPhotometry>& luminaires_;
    Diagnostics& findings_;
    std::map<std::string, const GldfPhotometry*> photometries_;
    std::map<std::string, std::vector<const GldfEmitter*>> emitters_;
    std::set<std::string> said_, names_;
    std::size_t intensities_ = 0;
    std::size_t left_out_ = 0;
    std::size_t asked_ = 0;
};

}  // namespace

void name_luminaires(const GldfListing& listing, const std::string& file, std::vector<NamedPhotometry>& luminaires,
                     Diagnostics& findings) {
    Naming{listing, file, luminaires, findings}.add_all();
}

}  // namespace hanei
