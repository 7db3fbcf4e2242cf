#version 330 core
// A round mark of a size in pixels, smaller where its neighbours come close.
layout(location = 0) in vec3 place;
layout(location = 1) in vec4 fill_colour;
layout(location = 2) in vec4 ring_colour;
layout(location = 3) in vec2 sizes;   // radius in pixels; greatest radius in metres (0: none)

uniform mat4 to_clip;
uniform float pixels_per_metre;   // at depth 1 (w = 1)
uniform float pixel_scale;
uniform vec4 eye;                 // w 1: a place; w 0: the direction to it

flat out vec4 fill;
flat out vec4 ring;
flat out float radius;

void main() {
    gl_Position = to_clip * vec4(place, 1.0);
    radius = sizes.x * pixel_scale;
    if (sizes.y > 0.0) radius = clamp(sizes.y * pixels_per_metre / gl_Position.w, 1.2, radius);
    gl_PointSize = 2.0 * radius + 2.0;
    // Some radii nearer, so that a surface it lies on does not cut it in half, seen flatly either.
    float metres = 8.0 * radius * gl_Position.w / pixels_per_metre;
    gl_Position = to_clip * vec4(place + metres * normalize(eye.xyz - place * eye.w), 1.0);
    fill = fill_colour;
    ring = ring_colour;
}
