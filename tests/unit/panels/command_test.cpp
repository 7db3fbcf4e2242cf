#include "ui/panels/command.h"

#include <gtest/gtest.h>
#include <set>
#include <string>

namespace hanei {
namespace {

TEST(Commands, no_two_share_a_chord) {
    std::set<std::string> chords;
    for (const Command& entry : commands()) {
        for (const Chord& chord : {entry.chord, entry.other}) {
            if (chord.key == Key::none) continue;
            EXPECT_TRUE(chords.insert(to_text(chord)).second) << to_text(chord) << " of " << entry.name;
        }
    }
}

TEST(Commands, all_have_a_name_of_their_own_and_a_sentence_of_help) {
    std::set<std::string_view> names;
    for (const Command& entry : commands()) {
        EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
        EXPECT_FALSE(entry.help.empty()) << entry.name;
        EXPECT_EQ(&command(entry.id), &entry) << entry.name;
    }
}

TEST(Commands, are_found_by_their_chord_with_exactly_its_modifiers) {
    ASSERT_NE(command_for({key_of('Z'), true}), nullptr);
    EXPECT_EQ(command_for({key_of('Z'), true})->id, CommandId::undo);
    EXPECT_EQ(command_for({key_of('Z'), true, true})->id, CommandId::redo);
    EXPECT_EQ(command_for({key_of('Z')}), nullptr);
}

TEST(Chords, read_as_they_are_written) {
    for (const Command& entry : commands()) {
        if (entry.chord.key == Key::none) continue;
        const auto read = chord_of(to_text(entry.chord));
        ASSERT_TRUE(read) << to_text(entry.chord);
        EXPECT_EQ(*read, entry.chord) << to_text(entry.chord);
    }
    EXPECT_FALSE(chord_of("Ctrl+Banana"));
    EXPECT_FALSE(chord_of("Hyper+Z"));
}

}  // namespace
}  // namespace hanei
