#include "engine/project/gltf_accessor.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <string_view>

namespace hanei {
namespace {

struct ComponentType {
    int number;  ///< as glTF numbers them
    std::size_t bytes;
    double greatest;  ///< of a normalised whole number; 0: not one
};
constexpr ComponentType component_types[] = {{5120, 1, 127.0},   {5121, 1, 255.0}, {5122, 2, 32767.0},
                                             {5123, 2, 65535.0}, {5125, 4, 0.0},   {5126, 4, 0.0}};
constexpr int type_of_floats = 5126;

template <class T>
double taken(const char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
}

/// The shortest decimal number that rounds to the same float: what was typed, as far as it can be known.
double as_written(float figure) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), figure).ptr;
    double number = figure;
    std::from_chars(text.data(), end, number);
    return number;
}

double figure_at(const char* bytes, int type) {
    switch (type) {
        case 5120:
            return taken<std::int8_t>(bytes);
        case 5121:
            return taken<std::uint8_t>(bytes);
        case 5122:
            return taken<std::int16_t>(bytes);
        case 5123:
            return taken<std::uint16_t>(bytes);
        case 5125:
            return taken<std::uint32_t>(bytes);
        default:
            return as_written(static_cast<float>(taken<float>(bytes)));
    }
}

/// Where elements lie in a buffer view.
struct Layout {
    std::size_t offset = 0;
    std::size_t stride = 0;  ///< 0: one after another
    std::size_t components = 1;
    ComponentType type{};
    bool normalised = false;
    std::size_t element() const { return components * type.bytes; }
};

class AccessorReading {
public:
    AccessorReading(GltfDocument& document, const JsonValue& accessor, std::string path)
        : document_(document), fields_(document.reading(), accessor, std::move(path)) {}

    /// All components one after another.
    std::optional<std::vector<double>> read(std::string_view type, std::size_t components) {
        std::string found;
        fields_.require("type", found, "the type of its elements");
        if (found != type) {
            fields_.error("type", fmt::format("found {}, expected \"{}\" here", json_quoted(found), type));
            return std::nullopt;
        }
        Layout layout;
        layout.components = components;
        const auto count = take_count(fields_, 0);
        const auto offset = take_offset(fields_);
        if (!take_component_type(fields_, layout.type) || !count || !offset) return std::nullopt;
        layout.offset = *offset;
        fields_.optional("normalized", layout.normalised);
        std::vector<double> figures;
        if (const JsonValue* const view = fields_.take("bufferView")) {
            auto read = read_view(*view, fields_, layout, *count);
            if (!read) return std::nullopt;
            figures = std::move(*read);
        } else {
            figures.assign(*count * components, 0.0);
        }
        const JsonValue* const sparse = fields_.take("sparse");
        if (sparse != nullptr && !replace(*sparse, layout, *count, figures)) return std::nullopt;
        return figures;
    }

    const std::string& path() const { return fields_.path(); }
    void error(const std::string& message) { document_.reading().error(fields_.value(), fields_.path(), message); }
    bool holds_floats() {
        const JsonValue* const type = fields_.take("componentType");
        return type != nullptr && type->number == type_of_floats;
    }

private:
    static std::optional<std::size_t> take_whole(Fields& fields, std::string_view key, int low, int high,
                                                 std::string_view what) {
        int value = 0;
        if (!fields.optional(key, value)) return std::nullopt;
        if (value >= low && value <= high) return static_cast<std::size_t>(value);
        fields.error(key, fmt::format("found {}, expected {} from {} to {}", value, what, low, high));
        return std::nullopt;
    }

    static std::optional<std::size_t> take_count(Fields& fields, int low) {
        if (!fields.has("count")) {
            fields.missing("count", "how many elements there are");
            return std::nullopt;
        }
        return take_whole(fields, "count", low, most_gltf_elements, "a count");
    }

    static std::optional<std::size_t> take_offset(Fields& fields) {
        constexpr int most = 1 << 30;
        return fields.has("byteOffset") ? take_whole(fields, "byteOffset", 0, most, "a number of bytes") : 0;
    }

    static bool take_component_type(Fields& fields, ComponentType& type) {
        int number = 0;
        fields.require("componentType", number, "the type of its components");
        for (const ComponentType& known : component_types)
            if (known.number == number) {
                type = known;
                return true;
            }
        if (fields.has("componentType"))
            fields.error("componentType", fmt::format("found {}, expected 5120 to 5123, 5125 or 5126", number));
        return false;
    }

    std::optional<std::vector<double>> read_view(const JsonValue& view, Fields& owner, Layout layout,
                                                 std::size_t count) {
        const auto bytes = document_.view_bytes(view, owner.path_of("bufferView"));
        if (!bytes) return std::nullopt;
        layout.stride = layout.element();
        Fields described(document_.reading(),
                         document_.root().find("bufferViews")->items[static_cast<std::size_t>(view.number)],
                         "bufferViews[" + view.text + ']');
        if (described.has("byteStride")) {
            constexpr int most = 252;
            const auto stride =
                take_whole(described, "byteStride", static_cast<int>(layout.element()), most, "a number of bytes");
            if (!stride) return std::nullopt;
            layout.stride = *stride;
        }
        if (count == 0) return std::vector<double>{};
        const std::size_t end = layout.offset + (count - 1) * layout.stride + layout.element();
        if (end > bytes->size()) {
            document_.reading().error(
                owner.value(), owner.path(),
                fmt::format("its {} elements end at byte {} of a buffer view of {} bytes", count, end, bytes->size()));
            return std::nullopt;
        }
        std::vector<double> figures;
        figures.reserve(count * layout.components);
        for (std::size_t k = 0; k < count; ++k)
            for (std::size_t c = 0; c < layout.components; ++c) {
                const char* const place = bytes->data() + layout.offset + k * layout.stride + c * layout.type.bytes;
                const double figure = figure_at(place, layout.type.number);
                const bool share = layout.normalised && layout.type.greatest > 0.0;
                figures.push_back(share ? std::max(figure / layout.type.greatest, -1.0) : figure);
            }
        return figures;
    }

    bool replace(const JsonValue& value, const Layout& layout, std::size_t count, std::vector<double>& figures) {
        Fields sparse(document_.reading(), value, fields_.path_of("sparse"));
        const auto changed = take_count(sparse, 1);
        const JsonValue* const where = sparse.take("indices");
        const JsonValue* const what = sparse.take("values");
        if (where == nullptr) sparse.missing("indices", "which elements are replaced");
        if (what == nullptr) sparse.missing("values", "what replaces them");
        if (!changed || where == nullptr || what == nullptr) return false;
        Layout numbers;
        Fields indices(document_.reading(), *where, sparse.path_of("indices"));
        if (!take_component_type(indices, numbers.type)) return false;
        const auto at = read_part(indices, numbers, *changed);
        Fields values(document_.reading(), *what, sparse.path_of("values"));
        Layout dense = layout;
        const auto by = read_part(values, dense, *changed);
        if (!at || !by) return false;
        for (std::size_t k = 0; k < *changed; ++k) {
            const double number = (*at)[k];
            if (!(number >= 0.0 && number < static_cast<double>(count) && number == std::floor(number))) {
                indices.error("bufferView",
                              fmt::format("number {} is {}, there are {} elements, counted from 0", k, number, count));
                return false;
            }
            for (std::size_t c = 0; c < layout.components; ++c)
                figures[static_cast<std::size_t>(number) * layout.components + c] = (*by)[k * layout.components + c];
        }
        return true;
    }

    std::optional<std::vector<double>> read_part(Fields& fields, Layout layout, std::size_t count) {
        const auto offset = take_offset(fields);
        const JsonValue* const view = fields.take("bufferView");
        if (view == nullptr) fields.missing("bufferView", "where its bytes are");
        if (view == nullptr || !offset) return std::nullopt;
        layout.offset = *offset;
        return read_view(*view, fields, layout, count);
    }

    GltfDocument& document_;
    Fields fields_;
};

std::optional<AccessorReading> accessor_of(GltfDocument& document, const JsonValue& index, const std::string& path) {
    const JsonValue* const accessor = document.item(index, path, "accessors");
    if (accessor == nullptr) return std::nullopt;
    return AccessorReading{document, *accessor, "accessors[" + described(index) + ']'};
}

}  // namespace

std::optional<std::vector<Vec3>> read_places(GltfDocument& document, const JsonValue& index, const std::string& path) {
    auto accessor = accessor_of(document, index, path);
    if (!accessor) return std::nullopt;
    const auto figures = accessor->read("VEC3", 3);
    if (!figures) return std::nullopt;
    std::vector<Vec3> places;
    places.reserve(figures->size() / 3);
    for (std::size_t k = 0; k < figures->size(); k += 3) {
        const Vec3 place{(*figures)[k], (*figures)[k + 1], (*figures)[k + 2]};
        if (!std::isfinite(place.x) || !std::isfinite(place.y) || !std::isfinite(place.z)) {
            accessor->error(fmt::format("element {} is {} {} {}; only finite figures are places", k / 3, place.x,
                                        place.y, place.z));
            return std::nullopt;
        }
        places.push_back(place);
    }
    return places;
}

std::optional<std::vector<std::uint32_t>> read_indices(GltfDocument& document, const JsonValue& index,
                                                       const std::string& path, std::size_t vertices) {
    auto accessor = accessor_of(document, index, path);
    if (!accessor) return std::nullopt;
    if (accessor->holds_floats()) {
        accessor->error("its components are floating-point figures, expected whole vertex numbers");
        return std::nullopt;
    }
    const auto figures = accessor->read("SCALAR", 1);
    if (!figures) return std::nullopt;
    std::vector<std::uint32_t> numbers;
    numbers.reserve(figures->size());
    for (std::size_t k = 0; k < figures->size(); ++k) {
        const double number = (*figures)[k];
        if (!(number >= 0.0 && number < static_cast<double>(vertices) && number == std::floor(number))) {
            accessor->error(fmt::format("element {} is vertex {}, there are {}, counted from 0", k, number, vertices));
            return std::nullopt;
        }
        numbers.push_back(static_cast<std::uint32_t>(number));
    }
    return numbers;
}

}  // namespace hanei
