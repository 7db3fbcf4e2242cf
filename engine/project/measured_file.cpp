#include "engine/project/measured_file.h"

#include "engine/project/luminaire_text.h"
#include "engine/project/measured_columns.h"
#include "engine/project/number_text.h"
#include "engine/project/text_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

using enum MeasuredField;

constexpr std::size_t most_faults = 20;
constexpr double greatest_lux = 1e9, greatest_length = 1e6, greatest_index = 1e9;

bool is_no_value(const std::string& text) {
    return text.empty() || text == "-" || text == "--" || text == "/" || text == "n/a" || text == "N/A";
}

class MeasuredReader {
public:
    MeasuredReader(std::string_view text, std::string file) : lines_(text) { values_.file = std::move(file); }

    MeasuredRead read() {
        if (find_header()) {
            while (lines_.next()) row();
            if (values_.values.empty() && findings_.empty()) fault("", "no row below the header has a value");
        }
        if (faults_ > most_faults)
            findings_.push_back(
                about_file(Severity::error, values_.file, 0, "", fmt::format("{} faults more", faults_ - most_faults)));
        if (faults_ > 0) return {std::nullopt, std::move(findings_)};
        return {std::move(values_), {}};
    }

private:
    void fault(const std::string& field, const std::string& message) {
        if (++faults_ <= most_faults)
            findings_.push_back(about_file(Severity::error, values_.file, lines_.number(), field, message));
    }

    bool is_passed_over() const {
        const std::string_view line = trimmed(lines_.line());
        return line.empty() || line.front() == '#';
    }

    bool find_header() {
        while (lines_.next()) {
            if (is_passed_over()) continue;
            separator_ = separator_of(lines_.line());
            const auto names = fields_of(lines_.line(), separator_);
            if (!names) continue;
            header_ = header_of(*names);
            if (!header_.has(lux)) continue;
            columns_ = names->size();
            return check_header();
        }
        fault(
            "header",
            "no row names a column of illuminances; one must be called lux, illuminance, E, total, measured or value");
        return false;
    }

    bool check_header() {
        if (header_.twice) {
            fault("header",
                  fmt::format("{} means the same as a column before it; keep one of them", in_quotes(*header_.twice)));
            return false;
        }
        if (header_.has(x) != header_.has(y)) {
            fault("header", fmt::format("there is a column {} and none {}; a place needs both",
                                        header_.has(x) ? "x" : "y", header_.has(x) ? "y" : "x"));
            return false;
        }
        if (header_.has(set) || header_.has(index) || header_.has(x)) return true;
        fault("header",
              "no column says where; name the grid or point (set), the number of its point (index), or x, y and z");
        return false;
    }

    /// A row on its way in.
    struct Row {
        MeasuredValue value;
        bool has_lux = true;
        std::optional<double> x_m, y_m;
        std::array<std::optional<double>, 3> normal;
    };

    void row() {
        if (is_passed_over()) return;
        const auto fields = fields_of(lines_.line(), separator_);
        if (!fields) return fault("", "a quote does not end on its line");
        if (has_more(*fields))
            return fault("", fmt::format("{} fields, where the header has {}{}", fields->size(), columns_,
                                         separator_ == ',' ? "; decimals have a point where commas separate" : ""));
        const std::size_t before = faults_;
        Row read;
        read.value.line = lines_.number();
        for (const MeasuredColumn& column : header_.columns)
            take(column, column.place < fields->size() ? (*fields)[column.place] : std::string(), read);
        if (faults_ > before) return;
        if (read.has_lux)
            finish(std::move(read));
        else
            ++values_.without_value;
    }

    bool has_more(const std::vector<std::string>& fields) const {
        return fields.size() > columns_ &&
               std::any_of(fields.begin() + static_cast<std::ptrdiff_t>(columns_), fields.end(),
                           [](const std::string& field) { return !field.empty(); });
    }

    void take(const MeasuredColumn& column, const std::string& text, Row& read) {
        MeasuredValue& value = read.value;
        switch (column.field) {
            case set:
                value.set = text;
                return;
            case index:
                if (const auto number = taken(column, text, 1.0, greatest_index)) take_index(column, *number, value);
                return;
            case x:
                read.x_m = taken(column, text, -greatest_length, greatest_length);
                return;
            case y:
                read.y_m = taken(column, text, -greatest_length, greatest_length);
                return;
            case z:
                value.height = taken(column, text, -greatest_length, greatest_length);
                return;
            case nx:
                read.normal[0] = taken(column, text, -greatest_length, greatest_length);
                return;
            case ny:
                read.normal[1] = taken(column, text, -greatest_length, greatest_length);
                return;
            case nz:
                read.normal[2] = taken(column, text, -greatest_length, greatest_length);
                return;
            case lux:
                read.has_lux = !is_no_value(text);
                if (read.has_lux) value.lux = taken(column, text, 0.0, greatest_lux).value_or(0.0);
                return;
            case uncertainty:
                if (!is_no_value(text)) value.uncertainty = taken(column, text, 0.0, greatest_lux);
                return;
        }
    }

    void finish(Row read) {
        MeasuredValue& value = read.value;
        for (const MeasuredColumn& column : header_.columns)
            if (column.percent && value.uncertainty) value.uncertainty = *value.uncertainty * value.lux;
        if (read.x_m.has_value() != read.y_m.has_value()) return fault("", "a place needs both x and y");
        if (read.x_m) value.plan = Vec2{*read.x_m, *read.y_m};
        if (!take_normal(read.normal, value)) return;
        if (!value.plan && !value.index && value.set.empty())
            return fault("", "nothing says where this value is of: no name, no index, no x and y");
        values_.values.push_back(std::move(value));
    }

    std::optional<double> taken(const MeasuredColumn& column, const std::string& text, double least, double most) {
        if (text.empty()) return std::nullopt;
        const auto number = separator_ == ',' ? decimal_number(text) : decimal_number_with_comma(text);
        const bool counts = column.field == index;
        if (number && *number * column.unit >= least && *number * column.unit <= most) return *number * column.unit;
        fault(column.header, fmt::format("{} is {}; allowed is {} from {} to {}", in_quotes(text),
                                         number ? "out of range" : "no number", counts ? "a whole number" : "a number",
                                         least / column.unit, most / column.unit));
        return std::nullopt;
    }

    void take_index(const MeasuredColumn& column, double number, MeasuredValue& value) {
        if (number != std::floor(number))
            return fault(column.header, fmt::format("{} is no whole number; points are counted from 1", number));
        value.index = static_cast<int>(number);
    }

    bool take_normal(const std::array<std::optional<double>, 3>& read, MeasuredValue& value) {
        if (!read[0] && !read[1] && !read[2]) return true;
        const Vec3 normal{read[0].value_or(0.0), read[1].value_or(0.0), read[2].value_or(0.0)};
        if (glm::length(normal) > 0.0) {
            value.normal = glm::normalize(normal);
            return true;
        }
        fault("normal", "0, 0, 0 has no direction; write the direction that the place faces, such as 0, 0, 1");
        return false;
    }

    LineReader lines_;
    char separator_ = ',';
    MeasuredHeader header_;
    std::size_t columns_ = 0;
    std::size_t faults_ = 0;
    MeasuredValues values_;
    Diagnostics findings_;
};

}  // namespace

MeasuredRead read_measured(const std::filesystem::path& file) {
    Diagnostics findings;
    const std::optional<std::string> text = read_text_file(file, findings);
    if (!text) return {std::nullopt, std::move(findings)};
    return read_measured_text(*text, file);
}

MeasuredRead read_measured_text(std::string_view text, const std::filesystem::path& file) {
    const std::string decoded = decoded_text(text);
    return MeasuredReader(decoded, file.string()).read();
}

}  // namespace hanei
