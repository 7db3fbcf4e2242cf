#version 330 core
// A round mark of a size in pixels, smaller where its neighbours come close.
layout(location = 0) in vec3 place;
layout(location = 1) in vec4 fill_colour;
layout(location = 2) in vec4 ring_colour;
layout(location = 3) in vec2 sizes;   // radius in pixels; greatest radius in metres (0: none)
layout(location = 4) in vec3 normal;   // of the plane it lies in; zero: none

uniform mat4 to_clip;
uniform vec4 cuts[2];   // normal and offset of planes: what lies beyond is not drawn
uniform float pixels_per_metre;   // at depth 1 (w = 1)
uniform float pixel_scale;
uniform vec4 eye;                 // w 1: a place; w 0: the direction to it

flat out vec4 fill;
flat out vec4 ring;
flat out float radius;

out float gl_ClipDistance[2];

void main() {
    for (int k = 0; k < 2; ++k) gl_ClipDistance[k] = cuts[k].w + 1e-4 - dot(cuts[k].xyz, place);
    gl_Position = to_clip * vec4(place, 1.0);
    radius = sizes.x * pixel_scale;
    if (sizes.y > 0.0) radius = clamp(sizes.y * pixels_per_metre / gl_Position.w, 1.2, radius);
    gl_PointSize = 2.0 * radius + 2.0;
    // So much nearer that the plane it lies in does not cut into it, and no more: what lies under
    // a thin board stays hidden.
    vec3 to_eye = normalize(eye.xyz - place * eye.w);
    float upright = abs(dot(normal, to_eye));
    float slope = normal == vec3(0.0) ? 1.0 : sqrt(max(0.0, 1.0 - upright * upright)) / max(upright, 0.1);
    float metres = (0.3 + 1.1 * slope) * radius * gl_Position.w / pixels_per_metre;
    gl_Position = to_clip * vec4(place + metres * to_eye, 1.0);
    fill = fill_colour;
    ring = ring_colour;
}
