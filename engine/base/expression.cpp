#include "engine/base/expression.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace hanei {
namespace {

constexpr std::size_t longest = 200;  // letters: more is no figure but a pasted text
constexpr int deepest = 50;           // brackets in brackets

/// A figure, and whether a unit has been counted in.
struct Amount {
    double value = 0.0;
    bool has_unit = false;
};

struct Fault {
    std::string text;
};

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

class Calculation {
public:
    Calculation(std::string_view text, std::span<const UnitWord> units, double bare)
        : text_(text), units_(units), bare_(bare) {}

    double result() {
        const Amount whole = sum(0);
        if (!at_end()) refuse_rest();
        return in_units(whole);
    }

private:
    void blanks() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    }
    bool at_end() {
        blanks();
        return at_ == text_.size();
    }
    bool take(std::string_view word) {
        blanks();
        if (text_.substr(at_, word.size()) != word) return false;
        at_ += word.size();
        return true;
    }
    double in_units(const Amount& amount) const { return amount.has_unit ? amount.value : amount.value * bare_; }

    Amount sum(int depth) {
        Amount left = product(depth);
        for (;;) {
            const bool plus = take("+");
            if (!plus && !take("-") && !take("−")) return left;
            const Amount right = product(depth);
            const bool united = left.has_unit || right.has_unit;
            const double a = united ? in_units(left) : left.value, b = united ? in_units(right) : right.value;
            left = {plus ? a + b : a - b, united};
        }
    }

    Amount product(int depth) {
        Amount left = signed_figure(depth);
        for (;;) {
            if (take("*") || take("×")) {
                const Amount right = signed_figure(depth);
                if (left.has_unit && right.has_unit) throw Fault{"Two figures with units cannot be multiplied."};
                left = {left.value * right.value, left.has_unit || right.has_unit};
            } else if (take("/") || take("÷")) {
                const Amount right = signed_figure(depth);
                if (right.has_unit && !left.has_unit) throw Fault{"A figure cannot be divided by one with a unit."};
                if (right.value == 0.0) throw Fault{"This divides by zero."};
                left = {left.value / right.value, left.has_unit && !right.has_unit};
            } else {
                return left;
            }
        }
    }

    Amount signed_figure(int depth) {
        if (depth > deepest) throw Fault{"There are too many brackets or signs."};
        if (take("-") || take("−")) {
            const Amount amount = signed_figure(depth + 1);
            return {-amount.value, amount.has_unit};
        }
        if (take("+")) return signed_figure(depth + 1);
        if (!take("(")) return figure();
        Amount inner = sum(depth + 1);
        if (!take(")")) throw Fault{"A closing bracket is missing."};
        if (const UnitWord* unit = take_unit(); unit != nullptr) {
            if (inner.has_unit) throw Fault{"A unit stands behind brackets that have one already."};
            inner = {inner.value * unit->worth, true};
        }
        return inner;
    }

    Amount figure() {
        const double value = mixed_number();
        const UnitWord* const unit = take_unit();
        if (unit == nullptr) return {value, false};
        double total = value * unit->worth;
        if (is_feet(*unit)) total += inches_behind_feet();
        return {total, true};
    }

    static bool is_feet(const UnitWord& unit) { return unit.word == "'" || unit.word == "ft"; }

    /// What follows feet as inches; nothing is taken when it is none.
    double inches_behind_feet() {
        const std::size_t before = at_;
        take("-");
        blanks();
        if (at_ < text_.size() && is_digit(text_[at_])) {
            const double value = mixed_number();
            const UnitWord* const unit = take_unit();
            if (unit != nullptr && (unit->word == "\"" || unit->word == "in")) return value * unit->worth;
        }
        at_ = before;
        return 0.0;
    }

    /// "3", "2.5", "1e3", "3 1/2".
    double mixed_number() {
        const double whole = number();
        const std::size_t before = at_;
        blanks();
        if (before != at_ && at_ < text_.size() && is_digit(text_[at_])) {
            const double above = number();
            if (take("/")) {
                blanks();
                const double below = number();
                if (below == 0.0) throw Fault{"This divides by zero."};
                return whole + above / below;
            }
        }
        at_ = before;
        return whole;
    }

    double number() {
        blanks();
        const bool begins = at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.');
        double value = 0.0;
        const char* const from = text_.data() + at_;
        const auto [end, fault] = std::from_chars(from, text_.data() + text_.size(), value);
        if (begins && fault == std::errc::result_out_of_range) throw Fault{"This figure is too large or too small."};
        if (!begins || fault != std::errc()) {
            if (at_ == text_.size()) throw Fault{"A figure is missing at the end."};
            throw Fault{quoted("A figure is expected where ", " stands.")};
        }
        at_ += static_cast<std::size_t>(end - from);
        if (at_ + 1 < text_.size() && text_[at_] == ',' && is_digit(text_[at_ + 1]))
            throw Fault{"Decimals stand behind a point, not a comma."};
        return value;
    }

    /// The longest unit that stands here; null when none does.
    const UnitWord* take_unit() {
        blanks();
        const UnitWord* found = nullptr;
        for (const UnitWord& unit : units_) {
            if (text_.substr(at_, unit.word.size()) != unit.word || unit.word.empty()) continue;
            if (found == nullptr || unit.word.size() > found->word.size()) found = &unit;
        }
        if (found != nullptr) at_ += found->word.size();
        return found;
    }

    std::string rest() const {
        constexpr std::size_t shown = 12;
        std::size_t end = std::min(text_.size(), at_ + shown);
        while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xC0U) == 0x80U) ++end;
        return std::string(text_.substr(at_, end - at_));
    }

    std::string quoted(std::string_view before, std::string_view behind) const {
        std::string sentence(before);
        sentence += '"';
        sentence += rest();
        sentence += '"';
        sentence += behind;
        return sentence;
    }

    [[noreturn]] void refuse_rest() const {
        if (text_[at_] == ')') throw Fault{"There is a closing bracket too many."};
        std::string allowed;
        for (const UnitWord& unit : units_) {
            if (!allowed.empty()) allowed += ", ";
            allowed += unit.word;
        }
        if (allowed.empty()) throw Fault{quoted("", " is no part of a figure without a unit.")};
        throw Fault{quoted("", " is no unit here; these are: ") + allowed + '.'};
    }

    std::string_view text_;
    std::span<const UnitWord> units_;
    double bare_;
    std::size_t at_ = 0;
};

}  // namespace

Calculated calculated(std::string_view text, std::span<const UnitWord> units, double bare) {
    if (text.size() > longest) return {std::nullopt, "This is too long for a figure."};
    try {
        const double value = Calculation(text, units, bare).result();
        if (!std::isfinite(value)) return {std::nullopt, "This figure is too large or too small."};
        return {value, {}};
    } catch (const Fault& fault) {
        return {std::nullopt, fault.text};
    }
}

}  // namespace hanei
