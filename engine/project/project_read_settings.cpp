#include "engine/project/json_text.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_settings.h"

namespace hanei {
namespace {

template <class T>
std::string digits_of(T value) {
    return one_line(json_number(static_cast<double>(value)));
}

/// In the unit of the file, where an end of the range that was stored in another unit may come out a
/// rounding beyond it.
template <class T>
bool is_allowed(const Option<T>& option, T shown) {
    const double slack = option.scale == 1.0 ? 0.0 : 1e-12;
    const auto value = static_cast<double>(shown);
    return value >= (1.0 - slack) * static_cast<double>(option.low) &&
           value <= (1.0 + slack) * static_cast<double>(option.high);
}

template <class T>
void take_option(Fields& fields, const Option<T>& option, Settings& settings) {
    const std::string field = field_of(option);
    T shown{};
    if (!fields.optional(field, shown)) return;
    if (!is_allowed(option, shown)) {
        fields.error(field, "found " + digits_of(shown) + ", allowed are " + digits_of(option.low) + " to " +
                                digits_of(option.high) + (option.unit.empty() ? "" : ' ' + std::string(option.unit)));
    } else if (option.scale == 1.0) {
        settings.*option.member = shown;
    } else {
        settings.*option.member = static_cast<T>(scaled(*fields.value().find(field), {1.0L, option.scale}));
    }
}

void take_method(Fields& fields, Settings& settings) {
    std::string name;
    if (!fields.optional("method", name)) return;
    if (const auto method = method_named(name)) {
        settings.method = *method;
        return;
    }
    std::string known;
    for (const Method method : methods) known += (known.empty() ? "" : ", ") + json_quoted(name_of(method));
    fields.error("method", "found " + json_quoted(name) + ", expected one of " + known);
}

void take_choice(Fields& fields, const EffectOption& option, Settings& settings) {
    const std::string field(option.name);
    std::string name;
    if (!fields.optional(field, name)) return;
    if (const auto choice = effect_choice_named(name)) {
        settings.*option.member = *choice;
        return;
    }
    std::string known;
    for (const EffectChoice each : effect_choices) known += (known.empty() ? "" : ", ") + json_quoted(name_of(each));
    fields.error(field, "found " + json_quoted(name) + ", expected one of " + known);
}

}  // namespace

void read_settings(Settings& settings, Fields& root, JsonValue& kept) {
    const JsonValue* const value = root.take("settings");
    if (value == nullptr) return;
    Fields fields(root.reading(), *value, "settings");
    take_method(fields, settings);
    for_each_option([&](const auto& option) { take_option(fields, option, settings); });
    for (const EffectOption& option : effect_options) take_choice(fields, option, settings);
    keep_unknown(fields, "settings", kept);
}

}  // namespace hanei
