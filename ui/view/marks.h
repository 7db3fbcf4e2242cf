/// What is drawn besides the cells: plain surfaces, lines and dots, as values. Private to the room.
#pragma once

#include "ui/view/renderer.h"

#include <glm/glm.hpp>

#include <vector>

namespace hanei {

struct SolidVertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec4 colour;
};

struct LineMark {
    Vec3 from{0.0}, to{0.0};
    glm::vec4 colour{0.0F, 0.0F, 0.0F, 1.0F};
    float width = 1.0F;  ///< pixels of a picture 900 high
    Vec3 normal_a{0.0};  ///< of the faces it borders: seen while one of them faces the eye
    Vec3 normal_b{0.0};
};

struct DotMark {
    glm::vec3 place;
    glm::vec4 fill;
    glm::vec4 ring;
    float radius = 3.0F;      ///< pixels of a picture 900 high
    float greatest_m = 0.0F;  ///< m; 0: none
    glm::vec3 normal{0.0F};   ///< of the plane it lies in; zero: none
};

namespace ink {
inline constexpr glm::vec4 edge{0.05F, 0.06F, 0.08F, 0.38F};
inline constexpr glm::vec4 mesh{0.0F, 0.0F, 0.0F, 0.22F};
inline constexpr glm::vec4 luminaire{0.15F, 0.14F, 0.10F, 0.75F};
inline constexpr glm::vec4 selected{0.97F, 0.52F, 0.07F, 1.0F};
inline constexpr glm::vec4 hovered{0.99F, 0.80F, 0.45F, 1.0F};
inline constexpr glm::vec4 no_value{0.62F, 0.63F, 0.65F, 1.0F};
}  // namespace ink

/// All faces by their material's reflectance, sub-areas laid over them.
struct PlainFaces {
    std::vector<SolidVertex> faces;
    std::vector<SolidVertex> sub_areas;
};
PlainFaces plain_faces(const Scene& scene);

/// Edges of all faces; where two faces share one it comes once, with both normals.
std::vector<LineMark> face_edges(const Scene& scene);
std::vector<LineMark> patch_edges(const Mesh& mesh);

/// Luminous openings as they shine in the picture.
struct LuminaireMarks {
    std::vector<SolidVertex> openings;
    std::vector<LineMark> outlines;  ///< of openings
    std::vector<LineMark> tubes;
    std::vector<DotMark> dots;
};
LuminaireMarks luminaire_marks(const Scene& scene);

/// Calculation points with their values as colours; grey where there is no value of this part.
std::vector<DotMark> calculation_dots(const Scene& scene, const Solution* solution, const ViewOptions& look);

/// Outlines of one authored object of any kind.
struct OutlineMarks {
    std::vector<LineMark> lines;
    std::vector<DotMark> dots;
};
OutlineMarks outline_of(const Scene& scene, ObjectId object, const glm::vec4& colour, float width);

}  // namespace hanei
