#version 330 core
// Plain surfaces: before any light is known, and luminous openings.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 surface_colour;

uniform mat4 to_clip;

out vec3 to_light;
out vec4 plain_colour;

void main() {
    gl_Position = to_clip * vec4(position, 1.0);
    to_light = normal;
    plain_colour = surface_colour;
}
