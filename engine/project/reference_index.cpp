#include "engine/project/reference_index.h"

#include "engine/project/json_fields.h"
#include "engine/project/text_file.h"

namespace hanei {

ReferenceIndex read_reference_index(const std::filesystem::path& file) {
    Diagnostics findings;
    const std::optional<std::string> text = read_text_file(file, findings);
    if (!text) return {{}, std::move(findings)};
    return read_reference_index_text(*text, file);
}

ReferenceIndex read_reference_index_text(std::string_view json, const std::filesystem::path& file) {
    ReferenceIndex index;
    JsonReading reading{file.string(), {}};
    if (const std::optional<JsonValue> root = parse_json(json, reading.file, reading.findings)) {
        Fields fields(reading, *root, "");
        std::string schema;
        fields.require("schema", schema, "\"hanei-reference-index/1\"");
        if (!schema.empty() && schema != "hanei-reference-index/1")
            fields.error("schema", "this is no list of reference cases: the field must be \"hanei-reference-index/1\"");
        for_each_object(fields, "cases", [&](Fields& entry, std::size_t) {
            std::string name;
            ReferenceEntry& read = index.entries.emplace_back();
            entry.require("file", name, "the name of a case's file");
            entry.optional("proves", read.proves);
            entry.optional("source", read.source);
            read.file = file.parent_path() / name;
        });
    }
    if (has_errors(reading.findings)) index.entries.clear();
    index.findings = std::move(reading.findings);
    return index;
}

}  // namespace hanei
