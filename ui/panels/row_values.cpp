#include "ui/panels/row_values.h"

namespace hanei {

void RowValues::begin_writing(std::string name, Value value) {
    mode_ = Mode::writes;
    name_ = std::move(name);
    value_ = std::move(value);
}

void RowValues::read(const std::string& name, Value value) {
    const auto [found, is_new] = others_.emplace(name, value);
    if (!is_new && found->second != value) mixed_.insert(name);
}

bool RowValues::is_mixed(const std::string& name, const Value& value) const {
    const auto found = others_.find(name);
    return found != others_.end() && (found->second != value || mixed_.count(name) > 0);
}

void RowValues::note_change(std::string name, Value value) {
    changed_ = true;
    name_ = std::move(name);
    value_ = std::move(value);
}

}  // namespace hanei
