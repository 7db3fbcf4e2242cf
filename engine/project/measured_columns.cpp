#include "engine/project/measured_columns.h"

#include "engine/project/luminaire_text.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace hanei {
namespace {

struct Word {
    std::string_view name;
    MeasuredField field;
};

using enum MeasuredField;

constexpr std::array words{
    Word{"lux", lux},
    Word{"lx", lux},
    Word{"e", lux},
    Word{"eh", lux},
    Word{"ev", lux},
    Word{"illuminance", lux},
    Word{"measured", lux},
    Word{"measured illuminance", lux},
    Word{"total", lux},
    Word{"value", lux},
    Word{"reading", lux},
    Word{"fc", lux},
    Word{"foot candles", lux},
    Word{"footcandles", lux},
    Word{"beleuchtungsstärke", lux},
    Word{"照度", lux},
    Word{"set", set},
    Word{"grid", set},
    Word{"name", set},
    Word{"surface", set},
    Word{"calculation surface", set},
    Word{"plane", set},
    Word{"area", set},
    Word{"index", index},
    Word{"nr", index},
    Word{"no", index},
    Word{"number", index},
    Word{"#", index},
    Word{"x", x},
    Word{"y", y},
    Word{"z", z},
    Word{"nx", nx},
    Word{"ny", ny},
    Word{"nz", nz},
    Word{"uncertainty", uncertainty},
    Word{"u", uncertainty},
    Word{"tolerance", uncertainty},
    Word{"error", uncertainty},
    Word{"±", uncertainty},
};

struct Unit {
    std::string_view name;
    double value;
};

constexpr double square_feet_a_square_metre = 1.0 / (0.3048 * 0.3048);
constexpr std::array units{Unit{"m", 1.0},     Unit{"cm", 0.01},     Unit{"mm", 0.001},
                           Unit{"ft", 0.3048}, Unit{"in", 0.0254},   Unit{"lx", 1.0},
                           Unit{"lux", 1.0},   Unit{"klx", 1000.0},  Unit{"fc", square_feet_a_square_metre},
                           Unit{"%", 0.01},    Unit{"percent", 0.01}};

/// "Illuminance [lx]" is illuminance, lx; letters past ASCII are kept as they are.
std::vector<std::string> tokens_of(std::string_view text) {
    std::vector<std::string> tokens;
    bool inside = false;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x80 || std::isalnum(byte) || c == '%' || c == '#') {
            if (!inside) tokens.emplace_back();
            tokens.back() += static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte);
            inside = true;
        } else {
            inside = false;
        }
    }
    return tokens;
}

std::string joined(const std::vector<std::string>& tokens) {
    std::string text;
    for (const std::string& token : tokens) text += (text.empty() ? "" : " ") + token;
    return text;
}

bool is_length(MeasuredField field) { return field == x || field == y || field == z; }
bool is_light(MeasuredField field) { return field == lux || field == uncertainty; }

bool fits(const Unit& unit, MeasuredField field) {
    constexpr std::size_t lengths = 5, lights = 9;
    const auto k = static_cast<std::size_t>(&unit - units.data());
    if (k < lengths) return is_length(field);
    return k < lights ? is_light(field) : field == uncertainty;
}

std::optional<MeasuredColumn> column_of(const std::string& header) {
    std::vector<std::string> tokens = tokens_of(header);
    const auto word = [&] {
        return std::find_if(words.begin(), words.end(),
                            [&](const Word& known) { return known.name == joined(tokens); });
    };
    MeasuredColumn column;
    column.header = header;
    const auto unit = tokens.empty() ? units.end() : std::find_if(units.begin(), units.end(), [&](const Unit& known) {
        return known.name == tokens.back();
    });
    if (unit != units.end() && tokens.size() > 1) tokens.pop_back();
    const auto found = word();
    if (found == words.end()) return std::nullopt;
    column.field = found->field;
    if (found->name.starts_with("f")) column.unit = square_feet_a_square_metre;
    if (unit == units.end() || !fits(*unit, column.field)) return column;
    column.unit = unit->value;
    column.percent = unit->name == "%" || unit->name == "percent";
    return column;
}

bool is_set_or_index(const std::string& header) {
    const std::string name = joined(tokens_of(header));
    return name == "point" || name == "id" || name == "point name";
}

}  // namespace

char separator_of(std::string_view line) {
    for (const char separator : {'\t', ';'})
        if (line.find(separator) != std::string_view::npos) return separator;
    return ',';
}

std::optional<std::vector<std::string>> fields_of(std::string_view line, char separator) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (std::size_t k = 0; k < line.size(); ++k) {
        const char c = line[k];
        if (quoted && c == '"' && k + 1 < line.size() && line[k + 1] == '"') {
            fields.back() += c;
            ++k;
        } else if (c == '"' && (quoted || trimmed(fields.back()).empty())) {
            quoted = !quoted;
        } else if (c == separator && !quoted) {
            fields.emplace_back();
        } else {
            fields.back() += c;
        }
    }
    if (quoted) return std::nullopt;
    for (std::string& field : fields) field = std::string(trimmed(field));
    return fields;
}

bool MeasuredHeader::has(MeasuredField field) const {
    return std::any_of(columns.begin(), columns.end(), [&](const MeasuredColumn& c) { return c.field == field; });
}

MeasuredHeader header_of(const std::vector<std::string>& names) {
    MeasuredHeader header;
    const auto add = [&](MeasuredColumn column, std::size_t place) {
        if (header.has(column.field)) {
            if (!header.twice) header.twice = column.header;
            return;
        }
        column.place = place;
        header.columns.push_back(std::move(column));
    };
    for (std::size_t k = 0; k < names.size(); ++k)
        if (auto column = column_of(names[k])) add(std::move(*column), k);
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (!is_set_or_index(names[k])) continue;
        if (header.has(set) && header.has(index)) continue;
        add({header.has(set) ? index : set, 0, names[k]}, k);
    }
    return header;
}

}  // namespace hanei
