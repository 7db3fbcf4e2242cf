#version 330 core
// A flat colour, shaded by direction so that shapes read; hatched by lines across the picture, as in
// a drawing, so that it reads without colour.
in vec3 to_light;
flat in vec4 plain_colour;

uniform float spacing;   // of the hatching, pixels
uniform vec3 hatching;

out vec4 colour;

void main() {
    vec3 n = normalize(to_light + vec3(1e-9));
    float shade = 0.86 + 0.10 * n.z + 0.04 * n.x - 0.03 * n.y;
    vec3 ground = plain_colour.rgb;
    if (plain_colour.a < 0.5) {
        float along = (gl_FragCoord.x + gl_FragCoord.y) * 0.70710678;
        float from_line = abs(along - spacing * floor(along / spacing + 0.5));
        ground = mix(hatching, ground, clamp(from_line - 0.11 * spacing + 0.5, 0.0, 1.0));
    }
    colour = vec4(ground * shade, 1.0);
}
