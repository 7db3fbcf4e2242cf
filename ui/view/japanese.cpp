#include "ui/view/japanese.h"

#include "japanese_table.h"

#include <algorithm>
#include <string>
#include <vector>

namespace hanei {
namespace {

/// Cuts the table into its texts, in place.
std::vector<Translation> read_table(std::string& text) {
    std::vector<Translation> table;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size() - 1);
        const std::size_t tab = text.find('\t', at);
        if (text[at] != '#' && tab < end) {
            text[tab] = text[end] = '\0';
            table.push_back({{&text[at], tab - at}, {&text[tab + 1], end - tab - 1}});
        }
        at = end + 1;
    }
    std::sort(table.begin(), table.end(),
              [](const Translation& a, const Translation& b) { return a.english < b.english; });
    return table;
}

}  // namespace

std::span<const Translation> japanese() {
    static std::string text = std::string(japanese_table) + '\n';
    static const std::vector<Translation> table = read_table(text);
    return table;
}

}  // namespace hanei
