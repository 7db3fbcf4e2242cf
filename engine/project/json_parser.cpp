#include "engine/project/json_value.h"
#include "engine/project/text_file.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

namespace hanei {
namespace {

constexpr std::size_t deepest = 64;
constexpr std::size_t most_values = 5'000'000;

/// Tells the handler how far the parser has read: the library's events carry no place.
class Reader {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    Reader(const char* at, const char** seen) : at_(at), seen_(seen) {}
    reference operator*() const { return *at_; }
    Reader& operator++() {
        *seen_ = at_++;
        return *this;
    }
    Reader operator++(int) {
        const Reader before = *this;
        ++*this;
        return before;
    }
    bool operator==(const Reader& other) const { return at_ == other.at_; }
    bool operator!=(const Reader& other) const { return at_ != other.at_; }

private:
    const char* at_;
    const char** seen_;
};

/// Messages of the library may quote the file's own bytes.
std::string printable(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return text;
}

/// The library's message without its code and its position, which ours has in front.
std::string reason_of(const std::string& what) {
    const std::size_t dash = what.find(" - ");
    if (dash != std::string::npos) return printable(what.substr(dash + 3));
    const std::size_t bracket = what.find("] ");
    return printable(bracket == std::string::npos ? what : what.substr(bracket + 2));
}

class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
public:
    TreeBuilder(std::string_view text, const std::string& file, Diagnostics& findings)
        : seen(text.data()), counted_(text.data()), file_(file), findings_(findings) {}

    const char* seen;  ///< the last character read
    JsonValue root;

    bool null() override { return put({}); }
    bool boolean(bool truth) override { return put(json_boolean(truth)); }
    bool number_integer(number_integer_t value) override { return put_integer(value); }
    bool number_unsigned(number_unsigned_t value) override { return put_integer(value); }
    bool number_float(number_float_t value, const string_t& digits) override {
        JsonValue number = json_number(value);
        number.text = digits;
        return put(std::move(number));
    }
    bool string(string_t& value) override { return put(json_text(std::move(value))); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(json_object()); }
    bool start_array(std::size_t) override { return open(json_list()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override {
        const JsonValue& object = *open_.back();
        key_ = std::move(name);
        if (object.find(key_) != nullptr) fault(path(), "the field stands here twice; keep one of them");
        return true;
    }

    bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception& error) override {
        const bool overflow = dynamic_cast<const nlohmann::json::out_of_range*>(&error) != nullptr;
        fault(path(), overflow ? reason_of(error.what()) + ": the number is too large, at most 1.79e308 is possible"
                               : "this is no valid JSON: " + reason_of(error.what()));
        return false;
    }

private:
    template <class Integer>
    bool put_integer(Integer value) {
        JsonValue number = json_number(static_cast<double>(value));
        number.text = std::to_string(value);
        return put(std::move(number));
    }

    /// Where the value now read goes; null after a fault that ends reading.
    JsonValue* place(JsonValue value) {
        value.line = line();
        if (++count_ > most_values) {
            fault(path(), "the file holds more than five million values; split the project");
            return nullptr;
        }
        if (open_.empty()) return &(root = std::move(value));
        JsonValue& parent = *open_.back();
        if (parent.is(JsonValue::Kind::object)) return &parent.add(std::exchange(key_, {}), std::move(value));
        parent.items.push_back(std::move(value));
        return &parent.items.back();
    }

    bool put(JsonValue value) { return place(std::move(value)) != nullptr; }

    bool open(JsonValue container) {
        if (open_.size() >= deepest) {
            fault(path(), "lists and objects are nested deeper than 64 levels; no project needs that");
            return false;
        }
        JsonValue* const at = place(std::move(container));
        if (at != nullptr) open_.push_back(at);
        return at != nullptr;
    }

    bool close() {
        open_.pop_back();
        return true;
    }

    /// The line of the last but one character read: the parser may be one ahead, after a number.
    int line() {
        line_ += static_cast<int>(std::count(counted_, std::max(counted_, seen), '\n'));
        counted_ = std::max(counted_, seen);
        return line_;
    }

    /// Of the value that is being read.
    std::string path() const {
        std::string text;
        for (std::size_t level = 0; level < open_.size(); ++level) {
            const JsonValue& parent = *open_[level];
            const bool innermost = level + 1 == open_.size();
            if (parent.is(JsonValue::Kind::list)) {
                text += '[' + std::to_string(parent.items.size() - (innermost ? 0 : 1)) + ']';
            } else if (const std::string& name = innermost ? key_ : parent.keys.back(); !name.empty()) {
                if (!text.empty()) text += '.';
                text += name;
            }
        }
        return printable(text);
    }

    void fault(const std::string& field, const std::string& message) {
        findings_.push_back(about_file(Severity::error, file_, line(), field, message));
    }

    const char* counted_;
    int line_ = 1;
    const std::string& file_;
    Diagnostics& findings_;
    std::vector<JsonValue*> open_;  // stable: only the innermost one's items grow
    std::string key_;
    std::size_t count_ = 0;
};

}  // namespace

std::optional<JsonValue> parse_json(std::string_view text, const std::string& file, Diagnostics& findings) {
    TreeBuilder builder(text, file, findings);
    const Reader begin(text.data(), &builder.seen);
    const Reader end(text.data() + text.size(), &builder.seen);
    if (!nlohmann::json::sax_parse(begin, end, &builder)) return std::nullopt;
    return std::move(builder.root);
}

std::string json_quoted(std::string_view text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace hanei
