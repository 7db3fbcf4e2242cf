#include "app/commands.h"
#include "app/exit_code.h"
#include "ui/view/png_text.h"

#include <cstdio>

namespace hanei {

int describe_command(const std::filesystem::path& picture) {
    const std::optional<PngText> text = read_png_text(picture);
    if (!text) {
        std::fprintf(stderr, "%s: this is no PNG picture that can be read\n", picture.c_str());
        return exit_bad_input;
    }
    if (text->empty()) {
        std::printf("%s: says nothing of itself\n", picture.c_str());
        return exit_answer_is_no;
    }
    for (const auto& [key, words] : *text) std::printf("%s: %s\n", key.c_str(), words.c_str());
    return exit_done;
}

}  // namespace hanei
