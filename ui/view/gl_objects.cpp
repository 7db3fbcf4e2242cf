#include "ui/view/gl_objects.h"

#include <glm/gtc/type_ptr.hpp>

#include <stdexcept>
#include <string>

namespace hanei::gl {
namespace {

GLuint compiled(GLenum kind, const char* source) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint done = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done != 0) return shader;
    char words[2048] = {};
    glGetShaderInfoLog(shader, sizeof words - 1, nullptr, words);
    glDeleteShader(shader);
    throw std::runtime_error(std::string("The graphics driver refuses a shader: ") + words);
}

}  // namespace

Program::Program(const char* vertex_source, const char* fragment_source) : id_(glCreateProgram()) {
    const GLuint vertex = compiled(GL_VERTEX_SHADER, vertex_source);
    const GLuint fragment = compiled(GL_FRAGMENT_SHADER, fragment_source);
    glAttachShader(id_, vertex);
    glAttachShader(id_, fragment);
    glLinkProgram(id_);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    GLint done = 0;
    glGetProgramiv(id_, GL_LINK_STATUS, &done);
    if (done != 0) return;
    char words[2048] = {};
    glGetProgramInfoLog(id_, sizeof words - 1, nullptr, words);
    throw std::runtime_error(std::string("The graphics driver refuses a program: ") + words);
}

Program::~Program() { glDeleteProgram(id_); }

void Program::set(const char* name, int value) const { glUniform1i(glGetUniformLocation(id_, name), value); }
void Program::set(const char* name, float value) const { glUniform1f(glGetUniformLocation(id_, name), value); }
void Program::set(const char* name, const glm::vec2& value) const {
    glUniform2fv(glGetUniformLocation(id_, name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, const glm::vec3& value) const {
    glUniform3fv(glGetUniformLocation(id_, name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, const glm::vec4& value) const {
    glUniform4fv(glGetUniformLocation(id_, name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, const glm::mat4& value) const {
    glUniformMatrix4fv(glGetUniformLocation(id_, name), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(const char* name, std::span<const glm::vec4> values) const {
    if (!values.empty())
        glUniform4fv(glGetUniformLocation(id_, name), static_cast<GLsizei>(values.size()), &values.front().x);
}

void Program::set(const char* name, std::span<const float> values) const {
    if (values.empty()) return;
    glUniform1fv(glGetUniformLocation(id_, name), static_cast<GLsizei>(values.size()), values.data());
}

Vertices::Vertices() {
    glGenVertexArrays(1, &array_);
    glGenBuffers(4, buffers_);
}

Vertices::~Vertices() {
    glDeleteBuffers(4, buffers_);
    glDeleteVertexArrays(1, &array_);
}

void Vertices::layout(std::size_t stride, std::initializer_list<Attribute> attributes, int buffer) {
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[buffer]);
    for (const Attribute& attribute : attributes) {
        glEnableVertexAttribArray(attribute.location);
        glVertexAttribPointer(attribute.location, attribute.components, GL_FLOAT, GL_FALSE,
                              static_cast<GLsizei>(stride), reinterpret_cast<const void*>(attribute.offset));
    }
    glBindVertexArray(0);
}

void Vertices::leave_out(std::initializer_list<GLuint> locations) {
    glBindVertexArray(array_);
    for (const GLuint location : locations) glDisableVertexAttribArray(location);
    glBindVertexArray(0);
}

void Vertices::upload(int buffer, const void* data, std::size_t bytes) const {
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[buffer]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_DRAW);
    glBindVertexArray(0);
}

void Vertices::fill_indices(const std::vector<GLuint>& indices) {
    glBindVertexArray(array_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[3]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(GLuint)), indices.data(),
                 GL_DYNAMIC_DRAW);
    glBindVertexArray(0);
    index_count_ = static_cast<GLsizei>(indices.size());
}

void Vertices::draw_triangles() const {
    glBindVertexArray(array_);
    if (index_count_ > 0) {
        glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
    } else if (vertex_count_ > 0) {
        glDrawArrays(GL_TRIANGLES, 0, vertex_count_);
    }
    glBindVertexArray(0);
}

void Vertices::draw_points() const {
    if (vertex_count_ == 0) return;
    glBindVertexArray(array_);
    glDrawArrays(GL_POINTS, 0, vertex_count_);
    glBindVertexArray(0);
}

}  // namespace hanei::gl
