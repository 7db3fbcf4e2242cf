#include "ui/panels/properties.h"

#include <string>
#include <type_traits>
#include <vector>

namespace hanei {
namespace {

/// "max-patch" as a label: "Max patch".
std::string label_of(std::string_view name) {
    std::string label(name);
    for (char& letter : label) {
        if (letter == '-') letter = ' ';
    }
    if (!label.empty()) label[0] = static_cast<char>(label[0] - 'a' + 'A');
    return label;
}

template <class T>
bool option_row(const Option<T>& option, Settings& settings, Form& form) {
    const std::string name = "settings." + std::string(option.name);
    const std::string label = label_of(option.name);
    const std::string unit = option.unit == "percent" ? "%" : std::string(option.unit);
    const std::string help(option.help);
    constexpr bool counts = std::is_integral_v<T>;
    double shown = static_cast<double>(settings.*option.member) * option.scale;
    const double low = static_cast<double>(option.low);
    const NumberField field{name.c_str(),        label.c_str(), unit.c_str(),
                            help.c_str(),        low,           static_cast<double>(option.high),
                            counts ? 1.0 : 0.01, counts ? 0 : 3};
    if (!form.number(field, shown)) return false;
    if constexpr (counts)
        settings.*option.member = static_cast<T>(shown + 0.5);
    else
        settings.*option.member = shown / option.scale;
    return true;
}

}  // namespace

std::optional<Settings> settings_panel(const Settings& settings, Form& form) {
    Settings wished = settings;
    std::vector<std::string> names;
    for (const Method method : methods) names.emplace_back(name_of(method));
    int chosen = static_cast<int>(wished.method);
    bool changed =
        form.choice("settings.method", "Method",
                    "patch: one value a patch, the fastest to follow the mouse. linear: values that slope across a "
                    "patch, for final figures. paper: the method of Nishita and Nakamae, 1985. paper-closed: the "
                    "same, made to lose and gain no light",
                    names, chosen);
    wished.method = methods[static_cast<std::size_t>(chosen)];
    std::apply([&](const auto&... option) { ((changed |= option_row(option, wished, form)), ...); }, options);
    if (!changed) return std::nullopt;
    return wished;
}

}  // namespace hanei
