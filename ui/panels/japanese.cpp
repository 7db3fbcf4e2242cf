#include "ui/panels/japanese.h"

#include <array>

namespace hanei {
namespace {

constexpr std::array table{
    Translation{"Add", "追加"},    Translation{"Edit", "編集"}, Translation{"File", "ファイル"},
    Translation{"Help", "ヘルプ"}, Translation{"View", "表示"},
};

}  // namespace

std::span<const Translation> japanese() { return table; }

}  // namespace hanei
