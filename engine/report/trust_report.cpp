#include "engine/report/trust_report.h"

#include <algorithm>
#include <fmt/args.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hanei {
namespace {

using Json = nlohmann::ordered_json;

const char* key_of(const TrustRow& row, std::size_t number) {
    static constexpr const char* keys[]{"direct", "energy", "reciprocity", "closure", "additivity", "threads"};
    return number < std::size(keys) ? keys[number] : row.name;
}

/// With the lines after the first set in.
std::string wrapped(const std::string& text, std::size_t indent) {
    constexpr std::size_t width = 108;
    std::string lines, line;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::string word = text.substr(at, end - at);
        if (!line.empty() && indent + line.size() + 1 + word.size() > width) {
            lines += line + '\n' + std::string(indent, ' ');
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
        at = end + 1;
    }
    return lines + line;
}

std::string paragraph(const char* title, const std::string& text) {
    constexpr std::size_t indent = 14;
    return text.empty() ? "" : fmt::format("    {:<10}{}\n", title, wrapped(text, indent));
}

Json to_json(const TrustFigure& figure) {
    return {{"state", name_of(figure.state())}, {"found", figure.found}, {"allowed", figure.allowed}};
}

Json figures_of(const TrustReport& report) {
    const DirectTrust& direct = report.direct;
    const EnergyTrust& energy = report.energy;
    Json json;
    json["direct"] = to_json(direct.figure());
    json["direct"].update({{"emitted_lm", direct.emitted},
                           {"arrived_lm", direct.arrived},
                           {"on_luminaires_lm", direct.on_luminaires},
                           {"missing_lm", direct.missing()}});
    json["energy"] = to_json(energy.figure());
    if (energy.asked)
        json["energy"].update({{"emitted_lm", energy.energy.emitted},
                               {"absorbed_lm", energy.energy.absorbed},
                               {"on_luminaires_lm", energy.energy.on_luminaires},
                               {"escaped_lm", energy.energy.escaped},
                               {"under_way_lm", energy.explained()},
                               {"unexplained_lm", energy.unexplained()},
                               {"received_from_surfaces_lm", energy.received}});
    const ReciprocityTrust& reciprocity = report.reciprocity;
    json["reciprocity"] = to_json(reciprocity.figure());
    if (reciprocity.asked)
        json["reciprocity"].update(
            {{"pairs", reciprocity.pairs.size()},
             {"within", reciprocity.within()},
             {"worst_ratio", reciprocity.worst() != nullptr ? reciprocity.worst()->ratio() : 0.0},
             {"form_factors_apart", reciprocity.rows_apart},
             {"scaled_by", reciprocity.gain}});
    const ClosureTrust& closure = report.closure;
    json["closure"] = to_json(closure.figure());
    if (closure.asked)
        json["closure"].update({{"least_row_sum", closure.least},
                                {"greatest_row_sum", closure.greatest},
                                {"seen_by_form_factors", closure.seen_by_rows},
                                {"seen_by_rays", closure.seen_by_rays},
                                {"worst_deviation", closure.worst_deviation}});
    const AdditivityTrust& additivity = report.additivity;
    json["additivity"] = to_json(additivity.figure());
    if (additivity.asked())
        json["additivity"].update({{"points", additivity.points},
                                   {"within", additivity.within},
                                   {"worst_ratio", additivity.worst_ratio},
                                   {"worst_apart_lx", additivity.worst_apart}});
    json["threads"] = to_json(report.threads.figure());
    json["threads"].update({{"values", report.threads.values}, {"other_bits", report.threads.others}});
    return json;
}

std::size_t count_of(const std::vector<TrustRow>& rows, TrustState state) {
    return static_cast<std::size_t>(
        std::count_if(rows.begin(), rows.end(), [&](const TrustRow& row) { return row.state == state; }));
}

}  // namespace

std::string TrustSentence::english() const {
    fmt::dynamic_format_arg_store<fmt::format_context> store;
    for (const std::string& figure : figures) store.push_back(figure);
    return fmt::vformat(words, store);
}

const char* name_of(TrustState state) {
    return state == TrustState::holds ? "holds" : state == TrustState::fails ? "fails" : "does not apply";
}

TrustSentence trust_verdict(const TrustReport& report) {
    const std::vector<TrustRow> rows = trust_rows(report);
    const std::size_t fails = count_of(rows, TrustState::fails), idle = count_of(rows, TrustState::not_asked);
    if (fails > 0) return {"{} of {} checks fail.", {std::to_string(fails), std::to_string(rows.size() - idle)}};
    return {"All {} checks hold.", {std::to_string(rows.size() - idle)}};
}

std::string trust_text(const TrustReport& report) {
    std::string text;
    for (const TrustRow& row : trust_rows(report)) {
        text += fmt::format("{:<14}{}\n", row.name, name_of(row.state));
        text += paragraph("must", row.must) + paragraph("found", row.found.english()) +
                paragraph("allowed", row.allowed.english());
        for (const TrustSentence& note : row.notes) text += paragraph("note", note.english());
        text += paragraph("do", row.advice.english());
    }
    const Solution& solution = *report.solution;
    text += fmt::format("\nmethod {}, {} patches: {}\n", name_of(solution.settings.method),
                        solution.mesh->patches.size(), trust_verdict(report).english());
    if (!solution.refusal.empty()) text += "note: " + solution.refusal + '\n';
    return text;
}

std::string trust_json(const TrustReport& report) {
    Json json{{"title", report.solution->scene->title},
              {"method", name_of(report.solution->settings.method)},
              {"patches", report.solution->mesh->patches.size()},
              {"holds", report.holds()}};
    const Json figures = figures_of(report);
    const std::vector<TrustRow> rows = trust_rows(report);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const char* const key = key_of(rows[k], k);
        Json& check = json["checks"][key] = figures[key];
        check["must"] = rows[k].must;
        check["said"] = rows[k].found.english();
        check["limit"] = rows[k].allowed.english();
        for (const TrustSentence& note : rows[k].notes) check["notes"].push_back(note.english());
        if (!rows[k].advice.words.empty()) check["advice"] = rows[k].advice.english();
    }
    return json.dump(2) + '\n';
}

}  // namespace hanei
