/// OpenGL's objects with C++ lifetimes. Private to the room.
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <glad/gl.h>
#include <span>
#include <vector>

namespace hanei::gl {

/// A linked program; throws std::runtime_error with the compiler's words.
class Program {
public:
    Program(const char* vertex_source, const char* fragment_source);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void use() const { glUseProgram(id_); }
    void set(const char* name, int value) const;
    void set(const char* name, float value) const;
    void set(const char* name, const glm::vec2& value) const;
    void set(const char* name, const glm::vec3& value) const;
    void set(const char* name, const glm::vec4& value) const;
    void set(const char* name, const glm::mat4& value) const;
    void set(const char* name, std::span<const float> values) const;
    void set(const char* name, std::span<const glm::vec4> values) const;

private:
    GLuint id_ = 0;
};

/// One attribute of an interleaved vertex.
struct Attribute {
    GLuint location = 0;
    GLint components = 0;
    std::size_t offset = 0;
};

/// Vertices of one kind, in one buffer, with or without indices; refilled as a whole.
class Vertices {
public:
    Vertices();
    ~Vertices();
    Vertices(const Vertices&) = delete;
    Vertices& operator=(const Vertices&) = delete;

    void layout(std::size_t stride, std::initializer_list<Attribute> attributes, int buffer = 0);
    void leave_out(std::initializer_list<GLuint> locations);  ///< until they are laid out (again)

    template <class Vertex>
    void fill(const std::vector<Vertex>& vertices, int buffer = 0) {
        upload(buffer, vertices.data(), vertices.size() * sizeof(Vertex));
        if (buffer == 0) vertex_count_ = static_cast<GLsizei>(vertices.size());
    }
    void fill_indices(const std::vector<GLuint>& indices);

    void draw_triangles() const;  ///< by the indices when there are any
    void draw_points() const;

private:
    void upload(int buffer, const void* data, std::size_t bytes) const;
    GLuint array_ = 0;
    GLuint buffers_[4] = {};  ///< three of vertices, one of indices
    GLsizei vertex_count_ = 0, index_count_ = 0;
};

}  // namespace hanei::gl
