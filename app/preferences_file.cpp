#include "app/preferences_file.h"

#include "engine/base/whole_file.h"
#include "engine/project/json_fields.h"
#include "engine/project/json_text.h"
#include "engine/project/text_file.h"
#include "ui/panels/preferences_keeper.h"

#include <array>
#include <fmt/format.h>

namespace hanei {
namespace {

template <class T, std::size_t count>
using Words = std::array<std::pair<T, std::string_view>, count>;

constexpr Words<Language, 2> languages{{{Language::english, "en"}, {Language::japanese, "ja"}}};
constexpr Words<Theme, 2> themes{{{Theme::dark, "dark"}, {Theme::light, "light"}}};
constexpr Words<LengthUnit, 4> lengths{{{LengthUnit::metre, "m"},
                                        {LengthUnit::centimetre, "cm"},
                                        {LengthUnit::millimetre, "mm"},
                                        {LengthUnit::feet_inches, "ft-in"}}};
constexpr Words<IlluminanceUnit, 2> illuminances{{{IlluminanceUnit::lux, "lx"}, {IlluminanceUnit::foot_candle, "fc"}}};

template <class T, std::size_t count>
std::string word_of(const Words<T, count>& words, T value) {
    for (const auto& [known, word] : words)
        if (known == value) return std::string(word);
    return {};
}

template <class T, std::size_t count>
void take_word(Fields& fields, std::string_view key, const Words<T, count>& words, T& target) {
    std::string found;
    if (!fields.optional(key, found)) return;
    std::string allowed;
    for (const auto& [known, word] : words) {
        if (word == found) {
            target = known;
            return;
        }
        allowed += (allowed.empty() ? "" : ", ") + json_quoted(word);
    }
    fields.error(key, "found " + json_quoted(found) + ", expected one of " + allowed);
}

template <class T>
void take_figure(Fields& fields, std::string_view key, double low, double high, T& target) {
    double found = 0.0;
    if (!fields.optional(key, found)) return;
    if (found >= low && found <= high)
        target = static_cast<T>(found);
    else
        fields.error(key, fmt::format("found {}, allowed are {} to {}", found, low, high));
}

void take_fields(Fields& fields, Preferences& preferences) {
    take_word(fields, "language", languages, preferences.language);
    take_word(fields, "theme", themes, preferences.theme);
    double scale = 0.0;
    if (fields.optional("scale", scale)) {
        if (scale == 0.0 || (scale >= 1.0 && scale <= 3.0))
            preferences.scale = scale;
        else
            fields.error("scale", fmt::format("found {}, allowed are 1 to 3, or 0 for the screen's own", scale));
    }
    take_word(fields, "length", lengths, preferences.length);
    take_word(fields, "illuminance", illuminances, preferences.illuminance);
    take_figure(fields, "autosave_s", 5.0, 600.0, preferences.autosave);
    fields.optional("restores_layout", preferences.restores_layout);
    fields.optional("glides", preferences.glides);
    fields.optional("picture_name", preferences.picture_name);
    fields.optional("shows_start_page", preferences.shows_start_page);
    take_figure(fields, "left_width", 140.0, 420.0, preferences.left_width);
    take_figure(fields, "right_width", 220.0, 520.0, preferences.right_width);
    take_figure(fields, "bottom_height", 90.0, 460.0, preferences.bottom_height);
    std::vector<std::string> recent;
    fields.optional("recent", recent);
    for (auto project = recent.rbegin(); project != recent.rend(); ++project) {
        if (std::filesystem::path(*project).is_absolute()) remember(preferences.recent, *project);
    }
}

}  // namespace

UserDoor::Opened preferences_of_text(std::string_view json, const std::filesystem::path& file) {
    UserDoor::Opened opened;
    JsonReading reading{file.string(), {}};
    const std::optional<JsonValue> root = parse_json(json, reading.file, reading.findings);
    if (root) {
        Fields fields(reading, *root, "");
        take_fields(fields, opened.preferences);
        const std::size_t said = reading.findings.size();
        opened.preferences.unknown = fields.unknown();
        reading.findings.resize(said);  // a newer program's fields are no fault
    }
    if (!opened.preferences.restores_layout) {
        const Preferences usual;
        opened.preferences.left_width = usual.left_width;
        opened.preferences.right_width = usual.right_width;
        opened.preferences.bottom_height = usual.bottom_height;
    }
    for (Diagnostic& finding : reading.findings) {
        finding.severity = Severity::warning;
        finding.message += "; the usual is taken instead";
        opened.findings.push_back(std::move(finding));
    }
    return opened;
}

UserDoor::Opened read_preferences(const std::filesystem::path& file) {
    std::error_code failure;
    if (!std::filesystem::exists(file, failure)) return {};
    Diagnostics findings;
    const std::optional<std::string> text = read_text_file(file, findings);
    if (text) return preferences_of_text(*text, file);
    for (Diagnostic& finding : findings) finding.severity = Severity::warning;
    return {{}, std::move(findings)};
}

std::string preferences_text(const Preferences& preferences) {
    JsonValue root = json_object();
    root.add("language", json_text(word_of(languages, preferences.language)));
    root.add("theme", json_text(word_of(themes, preferences.theme)));
    root.add("scale", json_number(preferences.scale));
    root.add("length", json_text(word_of(lengths, preferences.length)));
    root.add("illuminance", json_text(word_of(illuminances, preferences.illuminance)));
    root.add("autosave_s", json_number(preferences.autosave));
    root.add("restores_layout", json_boolean(preferences.restores_layout));
    root.add("glides", json_boolean(preferences.glides));
    root.add("left_width", json_number(static_cast<double>(preferences.left_width)));
    root.add("right_width", json_number(static_cast<double>(preferences.right_width)));
    root.add("bottom_height", json_number(static_cast<double>(preferences.bottom_height)));
    root.add("picture_name", json_text(preferences.picture_name));
    root.add("shows_start_page", json_boolean(preferences.shows_start_page));
    JsonValue& recent = root.add("recent", json_list());
    for (const std::filesystem::path& project : preferences.recent) recent.items.push_back(json_text(project.string()));
    if (!preferences.unknown.empty()) {
        Diagnostics ignored;
        std::optional<JsonValue> extra = parse_json(preferences.unknown, {}, ignored);
        for (std::size_t k = 0; extra && k < extra->keys.size(); ++k)
            root.add(extra->keys[k], std::move(extra->items[k]));
    }
    return json_document(root);
}

std::optional<Diagnostic> write_preferences(const Preferences& preferences, const std::filesystem::path& file) {
    if (const auto reason = make_folder(file.parent_path()))
        return about_file(Severity::error, file.string(), 0, {}, *reason);
    return write_text_file(file, preferences_text(preferences));
}

}  // namespace hanei
