#version 330 core
in float height;

out vec4 colour;

uniform vec3 low;
uniform vec3 high;

void main() { colour = vec4(mix(low, high, height), 1.0); }
