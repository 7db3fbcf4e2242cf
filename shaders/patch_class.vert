#version 330 core
// Patches by how a luminaire's light reaches them.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 surface_colour;   // alpha 0: hatched

uniform mat4 to_clip;

out vec3 to_light;
flat out vec4 plain_colour;

void main() {
    gl_Position = to_clip * vec4(position, 1.0);
    to_light = normal;
    plain_colour = surface_colour;
}
