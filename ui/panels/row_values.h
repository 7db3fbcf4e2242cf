/// What the rows of a form say while it stands for several objects: panels are run for each of the
/// others as well, first to read their values and after an edit to write the changed one.
#pragma once

#include "engine/base/vector.h"

#include <map>
#include <set>
#include <string>
#include <variant>

namespace hanei {

class RowValues {
public:
    using Value = std::variant<std::monostate, double, bool, std::string, Vec3>;  ///< monostate: a button

    enum class Mode { draws, reads, writes };
    Mode mode() const { return mode_; }
    bool draws() const { return mode_ == Mode::draws; }

    void begin_reading() { mode_ = Mode::reads; }
    void begin_writing(std::string name, Value value);
    void end() { mode_ = Mode::draws; }
    void forget() { others_.clear(), mixed_.clear(); }  ///< the form stands for one object again

    /// The row of this name in a panel that is not drawn: reading notes its value, writing sets it.
    /// Returns   true when the value changed.
    template <class Kind>
    bool row(const std::string& name, Kind& value) {
        if (mode_ == Mode::reads) return read(name, value), false;
        const Kind* wished = name == name_ ? std::get_if<Kind>(&value_) : nullptr;
        if (wished == nullptr || *wished == value) return false;
        value = *wished;
        return true;
    }
    bool pressed(const std::string& name) const { return mode_ == Mode::writes && name == name_; }

    /// Do the objects differ in this row, when the drawn one has this value?
    bool is_mixed(const std::string& name, const Value& value) const;

    /// The change of this frame, to be written to the others.
    void note_change(std::string name, Value value);
    bool changed() const { return changed_; }
    const std::string& changed_name() const { return name_; }
    const Value& changed_value() const { return value_; }
    void begin_frame() { changed_ = false; }

private:
    void read(const std::string& name, Value value);

    Mode mode_ = Mode::draws;
    bool changed_ = false;
    std::string name_;
    Value value_;
    std::map<std::string, Value> others_;
    std::set<std::string> mixed_;  ///< rows in which the others differ among themselves
};

}  // namespace hanei
