#version 330 core
in vec3 to_light;
in vec4 plain_colour;

uniform float shading;   // 0: the colour itself; 1: shaded by direction so that shapes read

out vec4 colour;

void main() {
    vec3 n = normalize(to_light + vec3(1e-9));
    float shade = 0.80 + 0.13 * n.z + 0.07 * n.x - 0.04 * n.y;
    colour = vec4(plain_colour.rgb * mix(1.0, shade, shading), plain_colour.a);
}
