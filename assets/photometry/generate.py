#!/usr/bin/env python3
"""Writes the luminaire files of this folder (LM-63-2002, type C) from formulas.

The luminaires exist on paper alone. Each is a function of direction: g is the angle from nadir, C the
plane (0 along the luminaire's length, or towards the wall). The function's scale is chosen so that the
bilinear interpolant of the written table integrates to the stated lumens.

    generate.py [FOLDER]        default: the folder this script lies in
"""

import math
import pathlib
import sys


def steps(last, step):
    return [k * step for k in range(round(last / step) + 1)]


def panel(plane, gamma):
    """Microprisms: a little less than a cosine, cut off smoothly above 62 degrees against glare."""
    across = math.sin(math.radians(plane)) ** 2
    edge = 62 - 2 * across
    return math.cos(math.radians(gamma)) ** 0.9 / (1 + math.exp((gamma - edge) / 4.5))


def pendant(plane, gamma):
    """Louvre below, batwing above: 40 % of the light goes down."""
    across = math.sin(math.radians(plane)) ** 2
    if gamma <= 90:
        return math.cos(math.radians(gamma)) ** (1.3 + 1.2 * across)
    up = math.radians(180 - gamma)
    return math.cos(up) * (0.55 + 1.5 * math.sin(up) ** 2 * (0.4 + 0.6 * across))


def downlight(plane, gamma):
    """Reflector with a beam of 64 degrees."""
    return math.exp(-math.log(2) * (gamma / 32) ** 3.2)


def wall_washer(plane, gamma):
    """Aimed 38 degrees off nadir towards C0, wide along the wall, some spill on the floor."""
    g, c, aim = math.radians(gamma), math.radians(plane), math.radians(38)
    towards = math.sin(g) * math.cos(c) * math.sin(aim) + math.cos(g) * math.cos(aim)
    along = math.sin(g) * math.sin(c)
    cut_off = 1 / (1 + math.exp((gamma - 74) / 3))
    return (math.exp(-3.2 * (1 - towards - 0.35 * along**2) ** 1.1 * 2.2) + 0.03 * math.cos(g)) * cut_off


LUMINAIRES = [
    dict(
        file="panel-600-microprismatic.ies", name="Recessed panel 600 x 600, microprismatic", function=panel,
        catalogue="HANEI-P600", lamp="LED 4000 K, Ra 80", lumens=3600, watts=29,
        planes=steps(90, 15), gammas=steps(90, 2.5), size=(0.57, 0.57, 0),
        formula=["I = k cos(g)^0.9 / (1 + exp((g - 62 + 2 sin(C)^2) / 4.5)), g in degrees from nadir",
                 "luminance above 65 degrees below 3000 cd/m2"],
    ),
    dict(
        file="linear-pendant.ies", name="Linear pendant 1500, direct and indirect", function=pendant,
        catalogue="HANEI-L1500", lamp="LED 4000 K, Ra 90", lumens=6200, watts=48,
        planes=steps(90, 15), gammas=steps(180, 2.5), size=(0.06, 1.48, 0),
        formula=["below: I = k cos(g)^(1.3 + 1.2 sin(C)^2), g in degrees from nadir",
                 "above: I = k cos(u) (0.55 + 1.5 sin(u)^2 (0.4 + 0.6 sin(C)^2)), u = 180 - g"],
    ),
    dict(
        file="downlight.ies", name="Downlight 150", function=downlight,
        catalogue="HANEI-D150", lamp="LED 3000 K, Ra 90", lumens=2000, watts=17,
        planes=[0], gammas=steps(90, 2.5), size=(-0.15, -0.15, 0),
        formula=["I = k exp(-ln 2 (g / 32)^3.2), g in degrees from nadir"],
    ),
    dict(
        file="wall-washer.ies", name="Wall washer 300, asymmetric", function=wall_washer,
        catalogue="HANEI-W300", lamp="LED 3000 K, Ra 90", lumens=2400, watts=22,
        planes=steps(180, 10), gammas=steps(90, 2.5), size=(0.28, 0.08, 0),
        formula=["I = k (exp(-7.04 (1 - t - 0.35 s^2)^1.1) + 0.03 cos(g)) / (1 + exp((g - 74) / 3))",
                 "t = sin(g) cos(C) sin(38) + cos(g) cos(38), s = sin(g) sin(C), g in degrees from nadir",
                 "plane 0 faces the wall"],
    ),
]


def gamma_weights(gammas):
    """Exact integrals of hat functions times the sine, over the list of angles."""
    weights = [0.0] * len(gammas)
    for k in range(len(gammas) - 1):
        a, b = math.radians(gammas[k]), math.radians(gammas[k + 1])
        chord = (math.sin(b) - math.sin(a)) / (b - a)
        weights[k] += math.cos(a) - chord
        weights[k + 1] += chord - math.cos(b)
    return weights


def plane_weights(planes):
    """Radians of the circle that each plane stands for, its mirror images included."""
    if len(planes) == 1:
        return [2 * math.pi]
    copies = 360 / planes[-1]
    weights = [0.0] * len(planes)
    for k in range(len(planes) - 1):
        half = math.radians(planes[k + 1] - planes[k]) / 2
        weights[k] += copies * half
        weights[k + 1] += copies * half
    return weights


def table(luminaire):
    rows = [[luminaire["function"](plane, gamma) for gamma in luminaire["gammas"]] for plane in luminaire["planes"]]
    along, across = gamma_weights(luminaire["gammas"]), plane_weights(luminaire["planes"])
    flux = sum(w * sum(v * x for v, x in zip(along, row)) for w, row in zip(across, rows))
    scale = luminaire["lumens"] / flux
    return [[scale * value for value in row] for row in rows]


def lines_of(values, form):
    for k in range(0, len(values), 10):
        yield " ".join(form % value for value in values[k:k + 10])


def text(luminaire):
    lines = [
        "IESNA:LM-63-2002", "[TEST] computed", "[TESTLAB] Hanei", "[ISSUEDATE] 2026-01-01", "[MANUFAC] Hanei",
        "[LUMCAT] " + luminaire["catalogue"], "[LUMINAIRE] " + luminaire["name"], "[LAMP] " + luminaire["lamp"],
        "[OTHER] Computed, not measured, by assets/photometry/generate.py from the formula",
        *("[MORE] " + line for line in luminaire["formula"]),
        "[MORE] k so that the table integrates to %d lm" % luminaire["lumens"], "TILT=NONE",
    ]
    gammas, planes = luminaire["gammas"], luminaire["planes"]
    lines.append("1 %d 1 %d %d 1 2 %g %g %g" % (luminaire["lumens"], len(gammas), len(planes), *luminaire["size"]))
    lines.append("1 1 %g" % luminaire["watts"])
    lines += lines_of(gammas, "%g")
    lines += lines_of(planes, "%g")
    for row in table(luminaire):
        lines += lines_of(row, "%.2f")
    return "\r\n".join(lines) + "\r\n"


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
    for luminaire in LUMINAIRES:
        (folder / luminaire["file"]).write_text(text(luminaire), encoding="ascii", newline="")


if __name__ == "__main__":
    main()
