#version 330 core
// A round mark of a size in pixels, smaller where its neighbours come close.
layout(location = 0) in vec3 place;
layout(location = 1) in vec4 fill_colour;
layout(location = 2) in vec4 ring_colour;
layout(location = 3) in vec2 sizes;   // radius in pixels; greatest radius in metres (0: none)

uniform mat4 to_clip;
uniform float pixels_per_metre;   // at depth 1 (w = 1)
uniform float pixel_scale;
uniform float bias;

flat out vec4 fill;
flat out vec4 ring;
flat out float radius;

void main() {
    gl_Position = to_clip * vec4(place, 1.0);
    radius = sizes.x * pixel_scale;
    if (sizes.y > 0.0) radius = clamp(sizes.y * pixels_per_metre / gl_Position.w, 1.2, radius);
    gl_PointSize = 2.0 * radius + 2.0;
    gl_Position.z -= bias * gl_Position.w;
    fill = fill_colour;
    ring = ring_colour;
}
