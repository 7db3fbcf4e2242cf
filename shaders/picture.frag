#version 330 core
// A finished picture of the room, pixel for pixel.
uniform sampler2D picture;

out vec4 colour;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    colour = texelFetch(picture, ivec2(at.x, textureSize(picture, 0).y - 1 - at.y), 0);
}
