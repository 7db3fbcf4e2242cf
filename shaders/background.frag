#version 330 core
in float height;

out vec4 colour;

void main() { colour = vec4(mix(vec3(0.855, 0.865, 0.875), vec3(0.935, 0.94, 0.945), height), 1.0); }
