#version 330 core
// Plain surfaces: before any light is known, and luminous openings.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 surface_colour;

uniform mat4 to_clip;
uniform vec4 cuts[2];   // normal and offset of planes: what lies beyond is not drawn

out vec3 to_light;
out vec4 plain_colour;

out float gl_ClipDistance[2];

void main() {
    gl_Position = to_clip * vec4(position, 1.0);
    for (int k = 0; k < 2; ++k) gl_ClipDistance[k] = cuts[k].w - dot(cuts[k].xyz, position);
    to_light = normal;
    plain_colour = surface_colour;
}
