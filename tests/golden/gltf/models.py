#!/usr/bin/env python3
"""Writes the glTF models beside this file: models.py [FOLDER]. Each shows one thing that files of
modellers do; gltf_models_test.cpp says what a sensible import of each is. Lengths are metres, y is up,
unless a model is there to be wrong about it."""
import base64
import json
import math
import pathlib
import struct
import sys

FOLDER = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
FLOAT, UBYTE, USHORT, UINT, SHORT = 5126, 5121, 5123, 5125, 5122
CODE = {FLOAT: "f", UBYTE: "B", USHORT: "H", UINT: "I", SHORT: "h"}


class Model:
    def __init__(self):
        self.root = {"asset": {"version": "2.0", "generator": "models.py"}, "scene": 0, "scenes": [{"nodes": []}],
                     "nodes": [], "meshes": [], "accessors": [], "bufferViews": []}
        self.bytes = bytearray()

    def view(self, data, **fields):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        self.root["bufferViews"].append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data), **fields})
        self.bytes += data
        return len(self.root["bufferViews"]) - 1

    def accessor(self, values, kind, component, **fields):
        flat = [x for value in values for x in value] if kind != "SCALAR" else list(values)
        data = struct.pack("<%d%s" % (len(flat), CODE[component]), *flat)
        item = {"bufferView": self.view(data), "componentType": component, "count": len(values), "type": kind, **fields}
        if kind == "VEC3":
            item["min"] = [min(v[k] for v in values) for k in range(3)]
            item["max"] = [max(v[k] for v in values) for k in range(3)]
        self.root["accessors"].append(item)
        return len(self.root["accessors"]) - 1

    def mesh(self, *primitives, name=None):
        self.root["meshes"].append({**({"name": name} if name else {}), "primitives": list(primitives)})
        return len(self.root["meshes"]) - 1

    def node(self, top=True, **fields):
        self.root["nodes"].append(fields)
        if top:
            self.root["scenes"][0]["nodes"].append(len(self.root["nodes"]) - 1)
        return len(self.root["nodes"]) - 1

    def material(self, name, colour, **fields):
        self.root.setdefault("materials", []).append(
            {"name": name, "pbrMetallicRoughness": {"baseColorFactor": [*colour, 1], "metallicFactor": 0}, **fields})
        return len(self.root["materials"]) - 1

    def primitive(self, places, triangles, component=USHORT, material=None, **fields):
        item = {"attributes": {"POSITION": self.accessor(places, "VEC3", FLOAT)},
                "indices": self.accessor([k for t in triangles for k in t], "SCALAR", component), **fields}
        return item if material is None else {**item, "material": material}

    def write(self, name):
        self.root = {key: value for key, value in self.root.items() if value != []}
        if name.endswith(".gltf"):
            data = base64.b64encode(bytes(self.bytes)).decode()
            self.root["buffers"] = [{"byteLength": len(self.bytes), "uri": "data:application/octet-stream;base64," + data}]
            (FOLDER / name).write_text(json.dumps(self.root) + "\n")
            return
        self.root["buffers"] = [{"byteLength": len(self.bytes)}]
        text = json.dumps(self.root).encode()
        text += b" " * (-len(text) % 4)
        binary = bytes(self.bytes) + b"\0" * (-len(self.bytes) % 4)
        chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(binary), b"BIN\0") + binary
        (FOLDER / name).write_bytes(b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks)


QUADS = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (4, 5, 6, 7), (3, 2, 1, 0)]  # of a box, outward


def corners(low, high):
    (a, b, c), (x, y, z) = low, high
    return [(a, b, z), (x, b, z), (x, b, c), (a, b, c), (a, y, z), (x, y, z), (x, y, c), (a, y, c)]


def box(low, high):
    """Every face with corners of its own, as exporters write flat shading."""
    eight, places, triangles = corners(low, high), [], []
    for quad in QUADS:
        first = len(places)
        places += [eight[k] for k in quad]
        triangles += [(first, first + 1, first + 2), (first, first + 2, first + 3)]
    return places, triangles


def joined(*pieces):
    places, triangles = [], []
    for more, theirs in pieces:
        triangles += [tuple(k + len(places) for k in t) for t in theirs]
        places += more
    return places, triangles


def turned(piece):
    return piece[0], [(a, c, b) for a, b, c in piece[1]]


def prism(plan, low, high, caps):
    """A plan [x, z], clockwise seen from above with y up, raised; caps are its triangles. Shared corners."""
    n = len(plan)
    places = [(x, low, z) for x, z in plan] + [(x, high, z) for x, z in plan]
    triangles = [t for t in caps] + [(c + n, b + n, a + n) for a, b, c in caps]
    for k in range(n):
        m = (k + 1) % n
        triangles += [(k, k + n, m), (m, k + n, m + n)]
    return places, triangles


def quarter(axis, angle):
    half = angle / 2
    return [*(math.sin(half) * x for x in axis), math.cos(half)]


L_PLAN = [(0, 0), (2.4, 0), (2.4, 0.6), (0.6, 0.6), (0.6, 1.8), (0, 1.8)]
L_CAPS = [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5)]

# A desk of three boxes that touch, turned by a quarter and moved.
m = Model()
wood = m.material("wood", (0.5, 0.3, 0.1))
parts = joined(box((-0.8, 0.71, -0.4), (0.8, 0.74, 0.4)), box((-0.8, 0, -0.4), (-0.77, 0.71, 0.4)),
               box((0.77, 0, -0.4), (0.8, 0.71, 0.4)))
m.node(name="desk", mesh=m.mesh(m.primitive(*parts, material=wood)), translation=[2, 0, -1],
       rotation=quarter((0, 1, 0), math.pi / 2))
m.write("desk.gltf")

# A counter that is not convex; its last corner is put right by a sparse accessor.
m = Model()
places, triangles = prism(L_PLAN, 0, 0.9, L_CAPS)
m.root["materials"] = [{"name": "stone", "pbrMetallicRoughness": {"baseColorFactor": [0.4, 0.4, 0.4, 1]}}]
wrong = places[:-1] + [(9, 9, 9)]
item = m.primitive(wrong, triangles, material=0)
del m.root["accessors"][0]["max"], m.root["accessors"][0]["min"]
m.root["accessors"][0]["sparse"] = {
    "count": 1,
    "indices": {"bufferView": m.view(struct.pack("<B", len(places) - 1)), "componentType": UBYTE},
    "values": {"bufferView": m.view(struct.pack("<3f", *places[-1]))}}
m.node(name="counter", mesh=m.mesh(item))
m.write("counter.glb")

# A chair of six boxes: one cube, stretched by six nodes below an empty one; a leg is mirrored.
m = Model()
cube = m.mesh(m.primitive(*box((0, 0, 0), (1, 1, 1)), component=UBYTE), name="cube")
pieces = [("seat", (-0.2, 0.42, -0.2), (0.4, 0.04, 0.4)), ("back", (-0.2, 0.46, -0.2), (0.4, 0.4, 0.03))]
pieces += [("leg", (x, 0, z), (0.04, 0.42, 0.04)) for x in (-0.2, 0.16) for z in (-0.2, 0.16)]
pieces[-1] = ("mirrored leg", (0.2, 0, 0.16), (-0.04, 0.42, 0.04))
children = [m.node(top=False, name=name, mesh=cube, translation=list(t), scale=list(s)) for name, t, s in pieces]
m.node(name="chair", children=children, translation=[1, 0, 0])
m.write("chair.gltf")

# A tray without a lid, one layer of faces that are seen from both sides.
m = Model()
tin = m.material("tin", (0.7, 0.7, 0.7), doubleSided=True)
places, triangles = box((-0.3, 0, -0.2), (0.3, 0.1, 0.2))
m.node(name="tray", mesh=m.mesh(m.primitive(places, [t for t in triangles if not all(places[k][1] == 0.1 for k in t)],
                                            material=tin)))
m.write("tray.gltf")

# A partition: one sheet, one side, as a strip without indices.
m = Model()
felt = m.material("felt", (0.2, 0.3, 0.6))
sheet = [(-0.8, 0.4, 0), (0.8, 0.4, 0), (-0.8, 1.4, 0), (0.8, 1.4, 0)]
m.node(name="partition", mesh=m.mesh({"attributes": {"POSITION": m.accessor(sheet, "VEC3", FLOAT)}, "mode": 5,
                                      "material": felt}))
m.write("partition.gltf")

# A cabinet that is inside out, its places packed into 16 bits (KHR_mesh_quantization).
m = Model()
places, triangles = turned(box((-1, 0, -1), (1, 1, 1)))
packed = m.accessor([tuple(round(32767 * x) for x in p) for p in places], "VEC3", SHORT, normalized=True)
m.root["extensionsUsed"] = m.root["extensionsRequired"] = ["KHR_mesh_quantization"]
m.node(name="cabinet", scale=[0.4, 2, 0.2],
       mesh=m.mesh({"attributes": {"POSITION": packed},
                    "indices": m.accessor([k for t in triangles for k in t], "SCALAR", UINT)}))
m.write("cabinet.glb")

# A plinth with five of twelve triangles wound the wrong way.
m = Model()
places, triangles = box((-0.25, 0, -0.25), (0.25, 1, 0.25))
triangles = [(a, c, b) if k in (1, 4, 6, 9, 11) else (a, b, c) for k, (a, b, c) in enumerate(triangles)]
m.node(name="plinth", mesh=m.mesh(m.primitive(places, triangles)))
m.write("plinth.gltf")

# A shelf drawn in millimetres and written as if they were metres.
m = Model()
boards = [box((0, y, 0), (900, y + 20, 300)) for y in (0, 590, 1180, 1780)]
sides = [box((x, 0, 0), (x + 20, 1800, 300)) for x in (-20, 900)]
m.node(name="shelf", mesh=m.mesh(m.primitive(*joined(*boards, *sides))))
m.write("shelf_in_mm.gltf")

# A table of 1.2 mm: scaled down once too often. Places and normals share one view.
m = Model()
places, triangles = box((-0.0006, 0, -0.0004), (0.0006, 0.0007, 0.0004))
view = m.view(b"".join(struct.pack("<6f", *p, 0, 1, 0) for p in places), byteStride=24)
m.root["accessors"] += [{"bufferView": view, "componentType": FLOAT, "count": len(places), "type": "VEC3"},
                        {"bufferView": view, "byteOffset": 12, "componentType": FLOAT, "count": len(places), "type": "VEC3"}]
m.node(name="table", mesh=m.mesh({"attributes": {"POSITION": 0, "NORMAL": 1},
                                  "indices": m.accessor([k for t in triangles for k in t], "SCALAR", USHORT)}))
m.write("tiny.glb")

# An office: a room of L shape seen from inside, a desk in it, and three lamps.
m = Model()
white, grey, brown = (m.material(n, c) for n, c in (("white", (0.8, 0.8, 0.8)), ("carpet", (0.2, 0.2, 0.2)),
                                                   ("beech", (0.6, 0.45, 0.3))))
plan = [(0, 0), (6, 0), (6, 3), (3, 3), (3, 5), (0, 5)]
places, triangles = turned(prism(plan, 0, 3, [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5)]))
places_at = m.accessor(places, "VEC3", FLOAT)
floor, rest = triangles[:4], triangles[4:]
room = [{"attributes": {"POSITION": places_at}, "material": material,
         "indices": m.accessor([k for t in some for k in t], "SCALAR", UBYTE)}
        for some, material in ((floor, grey), (rest, white))]
m.node(name="office", mesh=m.mesh(*room))
m.node(name="desk", mesh=m.mesh(m.primitive(*box((1, 0, 1), (2.6, 0.74, 1.8)), material=brown)))
profile = "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 3 1 1 2 0.6 0.6 0\n1 1 40\n0 45 90\n0\n1000 700 0\n"
m.root["extensionsUsed"] = ["KHR_lights_punctual", "EXT_lights_ies"]
m.root["extensions"] = {
    "KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 80},
                                       {"type": "spot", "intensity": 500, "spot": {"outerConeAngle": 0.6}}]},
    "EXT_lights_ies": {"lights": [{"uri": "data:application/x-ies-lm-63;base64,"
                                          + base64.b64encode(profile.encode()).decode()}]}}
down = quarter((1, 0, 0), -math.pi / 2)
for name, extension, light, place in (("globe", "KHR_lights_punctual", 0, [1.5, 2.2, 4]),
                                      ("spot", "KHR_lights_punctual", 1, [5, 2.9, 1.5]),
                                      ("panel", "EXT_lights_ies", 0, [1.8, 2.95, 1.4])):
    m.node(name=name, translation=place, rotation=down, extensions={extension: {"light": light}})
m.write("office.gltf")

# What goes wrong: triangles twice, without area, without a neighbour's corner; and a solid that crosses itself.
m = Model()
places, triangles = box((0, 0, 0), (1, 1, 1))
triangles += triangles[:3] + [(0, 1, 1), (2, 2, 2)]
extra = len(places)
places += [(0.5, 1, 1)]  # in the middle of an edge of the top alone
top = [t for t in triangles if all(places[k][1] == 1 for k in t)]
(a, b, c), rest = top[0], [t for t in triangles if t != top[0]]
rest += [(a, extra, c), (extra, b, c)]
crossing = prism([(0, 0), (2, 1), (2, 0), (0, 0.5)], 0, 1, [(0, 1, 2), (0, 2, 3)])
m.node(name="block", mesh=m.mesh(m.primitive(places, rest)))
m.node(name="bow tie", mesh=m.mesh(m.primitive(*crossing)), translation=[3, 0, 0])
m.write("messy.gltf")
