#version 330 core
// Illuminance by bilinear interpolation between the cell's corners (equation 6 of the paper),
// shown as a colour of the scale with lines of equal illuminance, or as a photograph would.
in vec2 flat_place;
flat in vec4 cell_sides;
flat in vec2 cell_corner;
flat in vec3 reflectance;
flat in vec4 corner_lux;
flat in vec4 corner_red;
flat in vec4 corner_green;
flat in vec4 corner_blue;

uniform bool photo;
uniform bool coloured_light;  // else every band has the lux
uniform int steps;            // 0 logarithmic, 1 linear, 2 bands
uniform vec2 lux_range;
uniform sampler2D colours;    // 256 x 1
uniform vec3 colour_below;
uniform vec3 colour_above;
uniform bool marks_clipped;   // what lies beyond the ends is hatched
uniform vec3 stripe_below;
uniform vec3 stripe_above;
uniform vec2 stripes;         // distance and width, pixels
uniform bool difference;      // of two solutions: -lux_range.y to lux_range.y
uniform vec3 of_difference[6];  // much less, less, none, more, much more, nothing to compare
uniform float shade_of_stripe;
uniform float least_striped;  // of lux_range.y
uniform int border_count;     // bands: borders of equally spaced colours
uniform float borders[64];
uniform int line_count;       // lines of equal illuminance, lx
uniform float lines[64];
uniform float line_width;     // pixels
uniform float exposure;       // photo: displayed 1 per cd/m2

out vec4 colour;

float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// Inverts place = u e + v f + u v g; the root inside a counter-clockwise cell, parallelograms included.
vec2 bilinear_coordinates(vec2 place) {
    vec2 e = cell_sides.xy, f = cell_sides.zw, g = cell_corner - e - f;
    float a = cross2(g, f), b = cross2(e, f) + cross2(place, g), c = cross2(place, e);
    float root = sqrt(max(0.0, b * b - 4.0 * a * c));
    float v = b >= 0.0 ? -2.0 * c / max(b + root, 1e-30) : (root - b) / (2.0 * a);
    vec2 row = e + v * g;
    return vec2(dot(place - v * f, row) / max(dot(row, row), 1e-30), v);
}

float between(vec4 corners, vec2 uv) {
    return mix(mix(corners.x, corners.y, uv.x), mix(corners.w, corners.z, uv.x), uv.y);
}

float lux_at(vec2 uv) { return between(corner_lux, uv); }

float scale_position(float lux) {
    if (steps == 1) return (lux - lux_range.x) / (lux_range.y - lux_range.x);
    if (steps == 0) return log(max(lux, 1e-9) / lux_range.x) / log(lux_range.y / lux_range.x);
    if (!(lux >= lux_range.x)) return -1.0;
    if (lux > lux_range.y) return 2.0;
    int band = 0;
    for (int k = 1; k + 1 < border_count; ++k) band += lux >= borders[k] ? 1 : 0;
    return border_count < 3 ? 0.5 : float(band) / float(border_count - 2);
}

bool in_stripe(float across) { return mod(0.70710678 * across, stripes.x) < stripes.y; }

vec3 scale_colour(float position) {
    bool falling = marks_clipped && in_stripe(gl_FragCoord.x + gl_FragCoord.y);
    bool rising = marks_clipped && in_stripe(gl_FragCoord.x - gl_FragCoord.y);
    if (!(position >= 0.0)) return falling ? stripe_below : colour_below;
    if (position > 1.0) return falling || rising ? stripe_above : colour_above;
    return texture(colours, vec2((position * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}

// Share of the pixel that a line covers. `steepness` is the change of log(lux) across a pixel.
float line_cover(float lux, float steepness, out float line_lux) {
    float here = log(max(lux, 1e-9)), nearest = 1e9;
    line_lux = 0.0;
    for (int k = 0; k < line_count; ++k) {
        float away = abs(here - log(lines[k]));
        if (away < nearest) {
            nearest = away;
            line_lux = lines[k];
        }
    }
    // A plateau that happens to lie on a step is no line; crowded lines would only blacken.
    float sloped = smoothstep(5e-6, 5e-5, steepness);
    float apart = smoothstep(1.5, 5.0, 0.29 / max(steepness, 1e-9));
    return sloped * apart * clamp(0.5 * line_width + 0.5 - nearest / max(steepness, 1e-9), 0.0, 1.0);
}

vec3 difference_colour(float lux) {
    if (!(lux < 1e20)) return of_difference[5];
    float share = lux / lux_range.y;
    float half_ways = 2.0 * min(abs(share), 1.0);
    vec3 middle = share < 0.0 ? of_difference[1] : of_difference[3];
    vec3 end = share < 0.0 ? of_difference[0] : of_difference[4];
    vec3 shown = half_ways < 1.0 ? mix(of_difference[2], middle, half_ways) : mix(middle, end, half_ways - 1.0);
    bool striped = share < -least_striped && in_stripe(gl_FragCoord.x + gl_FragCoord.y);
    return striped ? shade_of_stripe * shown : shown;
}

vec3 photograph(vec3 lux) {
    vec3 shown = exposure * reflectance * lux / 3.14159265;
    shown = shown * pow(max(shown, vec3(1e-6)), vec3(0.18));   // a film's contrast about the middle
    float white = 8.0;   // what the shoulder brings to full white, in middle exposures
    vec3 toned = clamp(shown * (1.0 + shown / (white * white)) / (1.0 + shown), 0.0, 1.0);
    vec3 linear = toned * mix(vec3(0.93, 0.98, 1.07), vec3(1.0, 0.985, 0.95), toned);
    vec3 low = 12.92 * linear, high = 1.055 * pow(max(linear, 1e-6), vec3(1.0 / 2.4)) - 0.055;
    return mix(low, high, step(vec3(0.0031308), linear));
}

void main() {
    // Derivatives first, of the unclamped map: it is smooth beyond the cell's border.
    vec2 uv = bilinear_coordinates(flat_place);
    float smooth_log = log(max(lux_at(uv), 1e-3));
    float steepness = length(vec2(dFdx(smooth_log), dFdy(smooth_log)));
    float lux = lux_at(clamp(uv, 0.0, 1.0));
    if (difference) {
        colour = vec4(difference_colour(lux), 1.0);
        return;
    }
    if (photo) {
        vec2 inside = clamp(uv, 0.0, 1.0);
        vec3 bands = vec3(between(corner_red, inside), between(corner_green, inside), between(corner_blue, inside));
        colour = vec4(photograph(coloured_light ? bands : vec3(lux)), 1.0);
        return;
    }
    float position = scale_position(lux);
    vec3 shown = scale_colour(position);
    float line_lux;
    float cover = line_cover(lux, steepness, line_lux);
    vec4 ink = scale_position(line_lux * 1.0001) < 0.5 ? vec4(vec3(1.0), 0.5) : vec4(0.02, 0.03, 0.05, 0.62);
    colour = vec4(mix(shown, ink.rgb, ink.a * cover), 1.0);
}
