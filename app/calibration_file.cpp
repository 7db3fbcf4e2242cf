#include "app/calibration_file.h"

#include "app/files.h"
#include "app/user_folders.h"
#include "engine/base/whole_file.h"
#include "engine/project/json_fields.h"
#include "engine/project/json_text.h"
#include "engine/project/text_file.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace hanei {
namespace {

constexpr double most_unknowns = 1e9, most_ns = 1e12, most_percent = 1e9;

/// 64 bits do not go through a JSON number.
std::string room_text(std::uint64_t room) { return fmt::format("{:016x}", room); }

std::optional<std::uint64_t> room_of_text(const std::string& text) {
    if (text.size() != 16 || text.find_first_not_of("0123456789abcdef") != std::string::npos) return std::nullopt;
    return std::stoull(text, nullptr, 16);
}

bool take_within(Fields& fields, std::string_view key, double low, double high, double& target) {
    if (!fields.require(key, target, "a number")) return false;
    if (target >= low && target <= high) return true;
    fields.error(key, fmt::format("found {:g}, allowed are {:g} to {:g}", target, low, high));
    return false;
}

std::optional<CalibrationSample> sample_from(Fields& fields) {
    CalibrationSample sample;
    std::string method, room;
    if (!fields.require("method", method, "a method's name") || !fields.require("room", room, "16 hexadecimal digits"))
        return std::nullopt;
    const auto known_method = method_named(method);
    const auto known_room = room_of_text(room);
    if (!known_method) fields.error("method", fmt::format("found \"{}\", which is no method", method));
    if (!known_room) fields.error("room", fmt::format("found \"{}\", expected 16 hexadecimal digits", room));
    if (!known_method || !known_room) return std::nullopt;
    sample.method = *known_method;
    sample.room = *known_room;
    if (!take_within(fields, "unknowns", 1.0, most_unknowns, sample.unknowns)) return std::nullopt;
    std::vector<double> ns;
    if (!fields.require("ns_a_unit", ns, "a list of numbers")) return std::nullopt;
    bool good = ns.size() == timed_stages;
    for (const double each : ns) good = good && each >= 0.0 && each <= most_ns;
    if (!good) {
        fields.error("ns_a_unit", fmt::format("expected {} figures of 0 to {:g}", timed_stages, most_ns));
        return std::nullopt;
    }
    std::copy(ns.begin(), ns.end(), sample.ns_a_unit.begin());
    if (fields.has("p95_percent")) {
        double percent = 0.0;
        if (!take_within(fields, "p95_percent", 0.0, most_percent, percent)) return std::nullopt;
        sample.error = 0.01 * percent;
    }
    return sample;
}

}  // namespace

CalibrationRead calibration_of_text(std::string_view json, const std::filesystem::path& file) {
    constexpr std::size_t told = 5;
    CalibrationRead read;
    JsonReading reading{file.string(), {}};
    const std::optional<JsonValue> root = parse_json(json, reading.file, reading.findings);
    if (root) {
        Fields fields(reading, *root, "");
        std::string format;
        int version = 0;
        const bool ours = fields.require("format", format, "\"hanei-calibration\"") && format == "hanei-calibration";
        if (ours && fields.require("version", version, "1") && version == 1) {
            for_each_object(fields, "studies", [&](Fields& each, std::size_t) {
                if (const auto sample = sample_from(each)) read.calibration.learn(*sample);
            });
        } else if (reading.findings.empty()) {
            fields.error("format", "this is no calibration of version 1");
        }
    }
    for (Diagnostic& finding : reading.findings) {
        finding.severity = Severity::warning;
        finding.message += "; it is not learned from";
        if (read.findings.size() < told) read.findings.push_back(std::move(finding));
    }
    return read;
}

CalibrationRead read_calibration(const std::filesystem::path& file) {
    std::error_code failure;
    if (!std::filesystem::exists(file, failure)) return {};
    Diagnostics findings;
    const std::optional<std::string> text = read_text_file(file, findings);
    if (text) return calibration_of_text(*text, file);
    for (Diagnostic& finding : findings) finding.severity = Severity::warning;
    return {{}, std::move(findings)};
}

std::string calibration_text(const Calibration& calibration) {
    JsonValue root = json_object();
    root.add("format", json_text("hanei-calibration"));
    root.add("version", json_number(1));
    JsonValue& studies = root.add("studies", json_list());
    for (const CalibrationSample& sample : calibration.samples()) {
        JsonValue study = json_object();
        study.add("method", json_text(std::string(name_of(sample.method))));
        study.add("room", json_text(room_text(sample.room)));
        study.add("unknowns", json_number(sample.unknowns));
        JsonValue& ns = study.add("ns_a_unit", json_list());
        for (const double each : sample.ns_a_unit) ns.items.push_back(json_number(each));
        if (sample.error) study.add("p95_percent", json_number(100.0 * *sample.error));
        studies.items.push_back(std::move(study));
    }
    return json_document(root);
}

std::optional<Diagnostic> write_calibration(const Calibration& calibration, const std::filesystem::path& file) {
    if (const auto reason = make_folder(file.parent_path()))
        return about_file(Severity::error, file.string(), 0, {}, *reason);
    return write_text_file(file, calibration_text(calibration));
}

std::optional<Diagnostic> add_learned(const std::vector<CalibrationSample>& learned,
                                      const std::filesystem::path& file) {
    if (learned.empty()) return std::nullopt;
    Calibration calibration = read_calibration(file).calibration;
    for (const CalibrationSample& sample : learned) calibration.learn(sample);
    return write_calibration(calibration, file);
}

std::filesystem::path calibration_path() {
    const auto folders = user_folders(std::nullopt);
    return folders ? folders->calibration : std::filesystem::path();
}

Calibration known_calibration() {
    const std::filesystem::path file = calibration_path();
    if (file.empty()) return {};
    CalibrationRead read = read_calibration(file);
    print_findings(read.findings);
    return std::move(read.calibration);
}

void keep_learned(const std::vector<CalibrationSample>& learned) {
    const std::filesystem::path file = calibration_path();
    if (file.empty()) return;
    if (const auto fault = add_learned(learned, file)) print_findings({*fault});
}

}  // namespace hanei
