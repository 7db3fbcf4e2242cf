#version 330 core
// A cell of the picture: four vertices that all carry the cell's flat frame and corner values.
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 place_in_cell;   // in the cell's plane, from its first corner, m
layout(location = 2) in vec4 sides;           // corners 2 and 4 likewise
layout(location = 3) in vec4 corner_and_shade;  // corner 3; reflectance; unused
layout(location = 4) in vec4 values;          // lx at the corners

uniform mat4 to_clip;

out vec2 flat_place;
flat out vec4 cell_sides;
flat out vec2 cell_corner;
flat out float reflectance;
flat out vec4 corner_lux;

void main() {
    gl_Position = to_clip * vec4(position, 1.0);
    flat_place = place_in_cell;
    cell_sides = sides;
    cell_corner = corner_and_shade.xy;
    reflectance = corner_and_shade.z;
    corner_lux = values;
}
