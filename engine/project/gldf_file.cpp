#include "engine/project/gldf_file.h"

#include "engine/project/gldf_container.h"
#include "engine/project/gldf_luminaires.h"
#include "engine/project/gldf_product.h"
#include "engine/project/luminaire_file.h"
#include "engine/project/luminaire_text.h"
#include "engine/project/number_text.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>
#include <utility>

namespace hanei {
namespace {

constexpr std::size_t most_bytes = 16U << 20U;  // of one text: the limit of luminaire files on disk
constexpr const char* product_entry = "product.xml";

class Reading {
public:
    Reading(std::string_view bytes, std::string_view name, GldfRead& result)
        : name_(name), container_(bytes, name, result.findings), result_(result) {}

    void read() {
        if (!container_.open()) return;
        if (!read_product()) return;
        locate_files();
        list_orphans();
        read_photometries();
        name_luminaires(*result_.listing, name_, result_.luminaires, result_.findings);
    }

private:
    void add(Severity severity, std::string field, std::string message) {
        result_.findings.push_back({severity, {name_, 0, std::move(field), 0}, std::move(message)});
    }

    bool read_product() {
        if (container_.find(product_entry, product_entry, result_.findings) != product_entry) {
            add(Severity::error, product_entry, "is missing; the container describes no product");
            return false;
        }
        const std::optional<std::string> bytes = container_.read(product_entry, most_bytes, result_.findings);
        if (!bytes) return false;
        LuminaireFindings findings{name_ + "/" + product_entry};
        const std::string text = decoded_text(*bytes);
        if (bytes->starts_with("\xFF\xFE") || bytes->starts_with("\xFE\xFF"))
            findings.warn(0, product_entry, "is UTF-16 by its byte order mark, which goes before its declaration");
        if (text.find('\0') != std::string::npos) findings.fault(1, product_entry, "a NUL byte stands in the text");
        GldfListing listing;
        if (!findings.failed()) listing = read_gldf_product(text, findings);
        const Diagnostics& found = findings.diagnostics();
        result_.findings.insert(result_.findings.end(), found.begin(), found.end());
        if (!findings.failed()) result_.listing = std::move(listing);
        return result_.listing.has_value();
    }

    /// A file lies in the folder that the first part of its content type names.
    void locate_files() {
        for (GldfFile& file : result_.listing->files) {
            files_.emplace(file.id, &file);
            if (file.type == "url") continue;
            const std::string field = "File " + file.id;
            file.entry = file.content_type.substr(0, file.content_type.find('/')) + "/" + file.name;
            if (!stays_inside(file.name)) {
                add(Severity::error, field, in_quotes(file.name) + " leads out of its folder; the file is not used");
                continue;
            }
            const std::optional<std::string> entry = container_.find(file.entry, field, result_.findings);
            file.present = entry.has_value();
            if (entry)
                file.entry = *entry;
            else
                add(Severity::warning, field, file.entry + " is not in the container");
        }
    }

    void list_orphans() {
        std::set<std::string> named{product_entry, "meta-information.xml", "gldf.xsd", "signature"};
        for (const GldfFile& file : result_.listing->files) named.insert(file.entry);
        std::vector<std::string>& orphans = result_.listing->orphans;
        for (const std::string& entry : container_.entries()) {
            if (!named.contains(entry)) orphans.push_back(entry);
        }
        std::sort(orphans.begin(), orphans.end());
    }

    void read_photometries() {
        std::set<std::string> wanted;
        for (const GldfEmitter& emitter : result_.listing->emitters) wanted.insert(emitter.photometry);
        for (GldfPhotometry& photometry : result_.listing->photometries) {
            if (wanted.contains(photometry.id)) read_photometry(photometry);
        }
    }

    void read_photometry(GldfPhotometry& photometry) {
        const auto found = files_.find(photometry.file);
        const std::string field = "Photometry " + photometry.id;
        const auto refuse = [&](std::string message) {
            photometry.fault = message;
            add(Severity::error, field, std::move(message));
        };
        if (found == files_.end()) return refuse(fmt::format("its file {} is not defined", in_quotes(photometry.file)));
        const GldfFile& file = *found->second;
        const std::string what = "its file " + file.id + ", ";
        if (file.type == "url")
            return refuse(what + file.name +
                          ", lies on the network, which is not asked; save it and read it by itself");
        if (!file.present) return refuse(what + file.entry + ", is not in the container");
        if (file.content_type.starts_with("sensor"))
            return refuse(what + file.entry + ", is of a sensor, no luminaire");
        read_entry(photometry, file.entry);
    }

    void read_entry(GldfPhotometry& photometry, const std::string& entry) {
        const auto known = texts_.find(entry);
        if (known != texts_.end()) {
            photometry.photometry = known->second->photometry;
            photometry.fault = known->second->fault;
            return;
        }
        texts_.emplace(entry, &photometry);
        const std::size_t before = result_.findings.size();
        if (const auto bytes = container_.read(entry, most_bytes, result_.findings)) {
            LuminaireFileRead read = read_luminaire_text(*bytes, name_ + "/" + entry);
            result_.findings.insert(result_.findings.end(), read.findings.begin(), read.findings.end());
            photometry.photometry = std::move(read.photometry);
        }
        if (!photometry.photometry && result_.findings.size() > before)
            photometry.fault = result_.findings.back().message;
    }

    std::string name_;
    GldfContainer container_;
    GldfRead& result_;
    std::map<std::string, GldfFile*, std::less<>> files_;
    std::map<std::string, const GldfPhotometry*, std::less<>> texts_;
};

}  // namespace

GldfRead read_gldf(std::string_view bytes, std::string_view name) {
    GldfRead result;
    Reading{bytes, name, result}.read();
    return result;
}

}  // namespace hanei
