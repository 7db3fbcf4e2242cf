#version 330 core
// A cell of the picture: four vertices that all carry the cell's flat frame and corner values.
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 place_in_cell;   // in the cell's plane, from its first corner, m
layout(location = 2) in vec4 sides;           // corners 2 and 4 likewise
layout(location = 3) in vec2 corner;          // corner 3
layout(location = 4) in vec4 values;          // lx at the corners
layout(location = 5) in vec3 band_reflectance;
layout(location = 6) in vec4 red_values;      // lx at the corners in each band; unset where light is neutral
layout(location = 7) in vec4 green_values;
layout(location = 8) in vec4 blue_values;

uniform mat4 to_clip;
uniform vec4 cuts[2];   // normal and offset of planes: what lies beyond is not drawn

out vec2 flat_place;
flat out vec4 cell_sides;
flat out vec2 cell_corner;
flat out vec3 reflectance;
flat out vec4 corner_lux;
flat out vec4 corner_red;
flat out vec4 corner_green;
flat out vec4 corner_blue;

out float gl_ClipDistance[2];

void main() {
    gl_Position = to_clip * vec4(position, 1.0);
    for (int k = 0; k < 2; ++k) gl_ClipDistance[k] = cuts[k].w - dot(cuts[k].xyz, position);
    flat_place = place_in_cell;
    cell_sides = sides;
    cell_corner = corner;
    reflectance = band_reflectance;
    corner_lux = values;
    corner_red = red_values;
    corner_green = green_values;
    corner_blue = blue_values;
}
