#version 330 core
flat in vec4 fill;
flat in vec4 ring;
flat in float radius;

out vec4 colour;

void main() {
    float away = length(gl_PointCoord - 0.5) * (2.0 * radius + 2.0);
    float cover = clamp(radius + 0.5 - away, 0.0, 1.0);
    float rim = clamp(away - (radius - 1.1), 0.0, 1.0);
    vec4 shown = mix(fill, ring, rim * ring.a);
    colour = vec4(shown.rgb, fill.a * cover);
}
