#version 330 core
// A line of a width in pixels: four vertices, moved aside in the picture. Drawn only when one of
// its two faces is turned to the eye (zero normals: always).
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec3 normal_a;
layout(location = 3) in vec3 normal_b;
layout(location = 4) in vec4 line_colour;
layout(location = 5) in vec3 corner_and_width;   // which end (0, 1), which side (-1, 1), pixels

uniform mat4 to_clip;
uniform vec4 cuts[2];        // normal and offset of planes: what lies beyond is not drawn
uniform vec2 picture_size;   // pixels
uniform vec4 eye;            // w 1: a place; w 0: the direction to it
uniform float pixels_per_metre;   // at depth 1
uniform float lift;          // towards the eye, pixels: clear of the faces that the line borders

out float across;            // pixels from the line's middle
flat out float half_width;
flat out vec4 ink;
out float gl_ClipDistance[2];

vec4 lifted(vec3 place) {
    float metres = lift * max((to_clip * vec4(place, 1.0)).w, 0.0) / pixels_per_metre;
    return to_clip * vec4(place + metres * normalize(eye.xyz - place * eye.w), 1.0);
}

void main() {
    vec3 to_eye = eye.xyz - from * eye.w;
    bool hidden = max(dot(normal_a, to_eye), dot(normal_b, to_eye)) <= 0.0 && (normal_a != vec3(0.0) || normal_b != vec3(0.0));
    vec4 a = lifted(from), b = lifted(to);
    // The part behind the eye is cut off, else the division would turn it round.
    float da = a.w + a.z, db = b.w + b.z;
    vec3 first = from, last = to;
    if (da < 0.0 && db > 0.0) {
        a = mix(a, b, (1e-4 - da) / (db - da));
        first = mix(from, to, (1e-4 - da) / (db - da));
    }
    if (db < 0.0 && da > 0.0) {
        b = mix(b, a, (1e-4 - db) / (da - db));
        last = mix(to, from, (1e-4 - db) / (da - db));
    }
    vec3 place = corner_and_width.x < 0.5 ? first : last;
    for (int k = 0; k < 2; ++k) gl_ClipDistance[k] = cuts[k].w + 1e-4 - dot(cuts[k].xyz, place);
    vec4 here = corner_and_width.x < 0.5 ? a : b;
    vec2 along = (b.xy / b.w - a.xy / a.w) * picture_size;
    float size = length(along);
    vec2 direction = size > 0.0 ? along / size : vec2(1.0, 0.0);
    half_width = 0.5 * corner_and_width.z;
    float reach = half_width + 1.0;
    across = corner_and_width.y * reach;
    vec2 aside = vec2(-direction.y, direction.x) * across;
    vec2 beyond = direction * (corner_and_width.x < 0.5 ? -0.5 : 0.5) * half_width;
    here.xy += (aside + beyond) * 2.0 / picture_size * here.w;
    gl_Position = hidden || (da < 0.0 && db < 0.0) ? vec4(2.0, 2.0, 2.0, 1.0) : here;
    ink = line_colour;
}
