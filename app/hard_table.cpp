#include "app/files.h"
#include "app/hard_cases.h"
#include "engine/project/json_fields.h"
#include "engine/project/text_file.h"

namespace hanei {
namespace {

double number_of(const JsonValue& object, std::string_view key) {
    const JsonValue* const value = object.find(key);
    return value == nullptr ? 0.0 : value->number;
}
std::string text_at(const JsonValue& object, std::string_view key) {
    const JsonValue* const value = object.find(key);
    return value == nullptr ? std::string() : value->text;
}

HardFigure figure_of(const JsonValue& row) {
    HardFigure figure;
    figure.point = text_at(row, "point");
    figure.direct_only = text_at(row, "light") == "direct";
    figure.expected = number_of(row, "expected_lx");
    figure.tolerance = number_of(row, "tolerance_lx");
    if (row.find("naive_lx") != nullptr) figure.naive = number_of(row, "naive_lx");
    return figure;
}

HardCase case_of(const JsonValue& row) {
    HardCase read;
    for (const auto& [key, target] :
         {std::pair{"file", &HardCase::file}, std::pair{"title", &HardCase::title}, std::pair{"why", &HardCase::why},
          std::pair{"right", &HardCase::right}, std::pair{"naive", &HardCase::naive},
          std::pair{"naive_by", &HardCase::naive_by}, std::pair{"refusal", &HardCase::refusal},
          std::pair{"same_as", &HardCase::same_as}})
        read.*target = text_at(row, key);
    if (const JsonValue* const covers = row.find("covers"))
        for (const JsonValue& item : covers->items) read.covers.push_back(item.text);
    if (const JsonValue* const figures = row.find("figures"))
        for (const JsonValue& item : figures->items) read.figures.push_back(figure_of(item));
    if (const JsonValue* const finds = row.find("finds"))
        for (const JsonValue& item : finds->items) read.finds.push_back(item.text);
    if (const JsonValue* const escaped = row.find("escaped_lm")) {
        read.escaped_lm = number_of(*escaped, "expected");
        read.escaped_tolerance = number_of(*escaped, "tolerance");
    }
    return read;
}

}  // namespace

std::filesystem::path hard_folder() { return start_room().parent_path() / "hard"; }

std::vector<HardCase> read_hard_cases(const std::filesystem::path& folder, Diagnostics& findings) {
    std::vector<HardCase> cases;
    const std::filesystem::path file = folder / "cases.json";
    const std::optional<std::string> text = read_text_file(file, findings);
    if (!text) return cases;
    const std::optional<JsonValue> table = parse_json(*text, file.string(), findings);
    const JsonValue* const rows = table ? table->find("cases") : nullptr;
    if (rows == nullptr) return cases;
    JsonReading reading{file.string(), {}};
    for (const JsonValue& row : rows->items) {
        HardCase read = case_of(row);
        if (read.file.empty() || read.right.empty() || read.covers.empty())
            reading.error(row, "cases", "a case needs its file, what is right and what it covers");
        else
            cases.push_back(std::move(read));
    }
    findings.insert(findings.end(), reading.findings.begin(), reading.findings.end());
    return cases;
}

}  // namespace hanei
