#include "ui/panels/language.h"

#include "source_texts.h"
#include "ui/panels/command.h"
#include "ui/view/japanese.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace hanei {
namespace {

std::string contents(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// The placeholders by their number, numbered or not.
std::map<int, std::string> placeholders(std::string_view text) {
    static const std::regex pattern(R"(\{(\d*)(:(?:[^{}]|\{\})*)?\})");
    std::map<int, std::string> found;
    const std::string whole(text);
    int next = 0;
    for (std::sregex_iterator each(whole.begin(), whole.end(), pattern), end; each != end; ++each) {
        const int number = (*each)[1].length() > 0 ? std::stoi((*each)[1]) : next++;
        if ((*each)[2].str().find("{}") != std::string::npos) ++next;  // its precision is an argument as well
        found[number] = (*each)[2];
    }
    return found;
}

bool is_known(std::string_view text) {
    const auto table = japanese();
    return std::any_of(table.begin(), table.end(), [&](const Translation& entry) { return entry.english == text; });
}

/// Same in both languages, or seen by nobody who reads words.
const std::set<std::string_view> kept{
#include "kept_texts.inc"
};

TEST(JapaneseTable, has_no_text_twice_and_none_without_translation) {
    const auto table = japanese();
    ASSERT_GT(table.size(), 100U);
    for (std::size_t k = 0; k < table.size(); ++k) {
        EXPECT_FALSE(table[k].other.empty()) << table[k].english;
        if (k == 0) continue;
        EXPECT_LT(table[k - 1].english, table[k].english);
    }
}

TEST(JapaneseTable, numbers_all_placeholders_of_a_sentence_or_none) {
    static const std::regex numbered(R"(\{\d)"), unnumbered(R"(\{[:}])");
    for (const Translation& entry : japanese()) {
        const std::string text(entry.other);
        EXPECT_FALSE(std::regex_search(text, numbered) && std::regex_search(text, unnumbered))
            << text << " would be refused when its figures are filled in";
    }
}

TEST(JapaneseTable, keeps_the_placeholders_of_every_sentence) {
    for (const Translation& entry : japanese())
        EXPECT_EQ(placeholders(entry.english), placeholders(entry.other)) << entry.english;
}

TEST(JapaneseTable, has_every_text_of_the_window) {
    std::string missing;
    for (const auto& file : std::filesystem::directory_iterator(HANEI_SOURCE "/ui/panels")) {
        const std::string name = file.path().filename().string();
        if (file.path().extension() != ".cpp") continue;
        if (name == "state_text.cpp" || name == "key.cpp") continue;  // for scripts; names of keys
        for (const SourceText& each : literals_of(contents(file.path()), name)) {
            if (reads_like_words(each.text) && !kept.contains(each.text) && !is_known(each.text))
                missing += each.place + "\t" + each.text + "\n";
        }
    }
    EXPECT_EQ(missing, "") << "Translate these in ui/view/japanese.tsv, or list them in kept_texts.inc.";
}

TEST(JapaneseTable, has_the_menus_labels_and_help_of_every_command) {
    for (const Command& entry : commands()) {
        for (const std::string_view text : {entry.menu, entry.label, entry.help})
            EXPECT_TRUE(text.empty() || is_known(text)) << entry.name << ": " << text;
    }
}

class Spoken : public testing::Test {
protected:
    ~Spoken() override { speak(Language::english); }
};

TEST_F(Spoken, english_stays_as_it_is_written) {
    EXPECT_STREQ(tr("Floor"), "Floor");
    EXPECT_EQ(say("Wall {}", 3), "Wall 3");
}

TEST_F(Spoken, japanese_takes_figures_into_its_sentences) {
    speak(Language::japanese);
    EXPECT_STREQ(tr("Floor"), "床");
    EXPECT_EQ(say("Wall {}", 3), "壁 3");
    EXPECT_EQ(say("{:.1f} % of the {:.0f} lm measured", 50.0, 4000.0), "測定値 4000 lm の 50.0 %");
}

TEST_F(Spoken, words_made_of_words_are_put_together_anew) {
    EXPECT_EQ(phrase("Move 3 luminaires"), "Move 3 luminaires");
    speak(Language::japanese);
    EXPECT_EQ(phrase("3 luminaires"), "照明器具 3 台");
    EXPECT_EQ(phrase("Move 3 luminaires"), "照明器具 3 台を移動");
    EXPECT_EQ(phrase("Move luminaire"), "照明器具を移動");
    EXPECT_EQ(phrase("Frobnicate it all"), "Frobnicate it all");
}

TEST_F(Spoken, texts_without_a_translation_stay_english_and_are_remembered) {
    speak(Language::japanese);
    EXPECT_STREQ(tr("Nobody has written this sentence"), "Nobody has written this sentence");
    EXPECT_TRUE(untranslated().contains("Nobody has written this sentence"));
}

TEST(SourceTexts, join_what_stands_side_by_side_and_leave_remarks_out) {
    const auto found =
        literals_of("#include \"no.h\"\n// \"nor\" this\nf(\"One \"\n  \"text\", 'x', \"two\");\n", "a.cpp");
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].text, "One text");
    EXPECT_EQ(found[0].place, "a.cpp:3");
    EXPECT_EQ(found[1].text, "two");
    EXPECT_FALSE(reads_like_words("light.dimmer"));
    EXPECT_FALSE(reads_like_words("{:.1f} m"));
    EXPECT_TRUE(reads_like_words("Dimmer"));
    EXPECT_TRUE(reads_like_words("being worked out"));
}

}  // namespace
}  // namespace hanei
