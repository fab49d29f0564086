#!/usr/bin/env python3
"""Writes the glTF files of tests/data, each small and about one feature: python3 tools/make_test_data.py [FOLDER]"""

import math
import pathlib
import random
import struct
import sys

from make_test_data_codecs import (
    DRACO_NORMAL,
    DRACO_POSITION,
    draco_mesh,
    exponential,
    meshopt_attributes,
    meshopt_triangles,
    octahedral,
    webp,
)
from make_test_data_gltf import (
    FLOAT,
    I8,
    I16,
    LINE_LOOP,
    LINE_STRIP,
    LINES,
    POINTS,
    TRIANGLE_FAN,
    TRIANGLE_STRIP,
    U16,
    Gltf,
    box,
    cross,
    ground,
    looking,
    png,
    quad,
    single,
    sphere,
    sub,
    turn,
    unit,
)

REPEAT, CLAMP, MIRROR = 10497, 33071, 33648
NEAREST, LINEAR, LINEAR_MIPS = 9728, 9729, 9987


def letter_picture():
    """16 x 16, different at each edge and under each turn: a white F on a ground that changes from corner to corner."""

    def pixel(x, y):
        letter = (x in (4, 5) and 3 <= y < 13) or (y in (3, 4) and 4 <= x < 12) or (y in (7, 8) and 4 <= x < 10)
        return (255, 255, 255, 255) if letter else (60 + 12 * x, 60 + 12 * y, 120, 255)

    return png(16, 16, pixel)


def triangle():
    g = Gltf()
    mesh = g.mesh(g.primitive([[-0.9, -0.7, 0], [0.9, -0.7, 0], [0, 0.9, 0]], material=g.material([0.9, 0.35, 0.1, 1])))
    g.node(mesh=mesh)
    g.camera([0, 0, 3.6], [0, 0, 0])
    return g


def wrap_modes():
    g = Gltf()
    image = g.image(letter_picture())
    for row, t in enumerate((REPEAT, MIRROR, CLAMP)):
        for column, s in enumerate((REPEAT, MIRROR, CLAMP)):
            texture = g.texture(image, wrapS=s, wrapT=t, magFilter=NEAREST, minFilter=LINEAR_MIPS)
            shape = quad(0.94, 0.94, u=(-0.75, 1.75), v=(-0.75, 1.75))
            mesh = g.mesh(g.primitive(**shape, material=g.material(texture=texture, roughness=0.9)))
            g.node(mesh=mesh, translation=[column - 1, 1 - row, 0])
    g.camera([0, 0, 5], [0, 0, 0])
    return g


def vertex_colors():
    g = Gltf()
    shape = box()
    colors = [[round(255 * (c + 0.5)) for c in p] + [255] for p in shape["positions"]]
    mesh = g.mesh(g.primitive(**shape, colors=colors, material=g.material(roughness=0.6)))
    g.node(mesh=mesh)
    g.camera([1.6, 1.3, 2.2], [0, -0.03, 0])
    return g


def sparse():
    """A flat grid whose inner points a sparse accessor lifts; without normals, so each facet is flat."""
    g = Gltf()
    n = 8
    grid = [[i - n / 2, 0, j - n / 2] for j in range(n + 1) for i in range(n + 1)]
    position = g.attribute(grid, "VEC3", bounds=True)
    lifted, heights = [], []
    for k, (x, _, z) in enumerate(grid):
        y = 2.2 * math.exp(-(x * x + z * z) / 7) * (1 + 0.35 * math.cos(2.2 * x) * math.cos(1.7 * z))
        if y > 0.2:
            lifted.append(k)
            heights.append([x, single(y), z])
    accessor = g.root["accessors"][position]
    accessor["max"][1] = max(h[1] for h in heights)
    accessor["sparse"] = {
        "count": len(lifted),
        "indices": {"bufferView": g.view(struct.pack(f"<{len(lifted)}H", *lifted)), "componentType": U16},
        "values": {"bufferView": g.view(b"".join(struct.pack("<3f", *h) for h in heights))},
    }
    indices = []
    for j in range(n):
        for i in range(n):
            a = j * (n + 1) + i
            indices += [a, a + n + 1, a + 1, a + 1, a + n + 1, a + n + 2]
    material = g.material([0.35, 0.55, 0.3, 1], roughness=0.8)
    primitive = {"attributes": {"POSITION": position}, "indices": g.indices(indices), "material": material}
    g.node(mesh=g.mesh(primitive))
    g.camera([7.0, 8.1, 11.3], [0, 0.1, 0])
    return g


def primitive_modes():
    """All seven modes, one a cell of a 3 x 3 grid."""
    g = Gltf()
    ring = [[0.38 * math.cos(math.radians(60 * k + 90)), 0.38 * math.sin(math.radians(60 * k + 90)), 0] for k in range(6)]
    zigzag = [[-0.4 + 0.2 * k, 0.3 if k % 2 else -0.3, 0] for k in range(5)]
    cells = [
        (POINTS, ring + [[0, 0, 0]], None, [0.9, 0.8, 0.1]),
        (LINES, [p for k in range(6) for p in ([0, 0, 0], ring[k])], None, [0.1, 0.8, 0.9]),
        (LINE_LOOP, ring, None, [0.9, 0.2, 0.6]),
        (LINE_STRIP, zigzag, None, [0.3, 0.9, 0.3]),
        (None, [ring[0], ring[2], ring[4]], None, [0.8, 0.8, 0.8]),
        (TRIANGLE_STRIP, [zigzag[k] for k in (1, 0, 3, 2)] + [zigzag[4]], [0, 1, 2, 3, 4], [0.9, 0.4, 0.1]),
        (TRIANGLE_FAN, [[0, 0, 0]] + ring + [ring[0]], None, [0.2, 0.4, 0.9]),
    ]
    for k, (mode, points, indices, color) in enumerate(cells):
        unlit = mode is not None and mode < 4
        extensions = {"KHR_materials_unlit": {}} if unlit else None
        material = g.material(color + [1], extensions=extensions, doubleSided=True)
        normals = None if unlit else [[0, 0, 1]] * len(points)
        shape = dict(positions=points, normals=normals, indices=indices, material=material)
        mesh = g.mesh(g.primitive(**shape) if mode is None else g.primitive(**shape, mode=mode))
        x, y = (k % 3 - 1, 1 - k // 3) if k < 6 else (0, -1)
        g.node(mesh=mesh, translation=[x, y, 0])
    g.camera([0, 0, 5], [0, 0, 0])
    return g


def animate(g, name, node, path, times, values, interpolation="LINEAR"):
    kind = {"translation": "VEC3", "scale": "VEC3", "rotation": "VEC4", "weights": "SCALAR"}[path]
    sampler = {
        "input": g.accessor(times, "SCALAR", bounds=True),
        "output": g.accessor(values, kind),
        "interpolation": interpolation,
    }
    tracks = g.root.setdefault("animations", [])
    if not any(a["name"] == name for a in tracks):
        tracks.append({"name": name, "samplers": [], "channels": []})
    track = next(a for a in tracks if a["name"] == name)
    track["samplers"].append(sampler)
    target = {"node": node, "path": path}
    track["channels"].append({"sampler": len(track["samplers"]) - 1, "target": target})


def morph_cube():
    """A cube that a first target shears and a second opens like a flower; the animation starts half way."""
    g = Gltf()
    shape = box()
    shear = [[0.6 * p[1], 0, 0] for p in shape["positions"]]
    bloom = [[0.5 * p[0] if p[1] > 0 else 0, 0, 0.5 * p[2] if p[1] > 0 else 0] for p in shape["positions"]]
    primitive = g.primitive(**{k: shape[k] for k in ("positions", "indices")}, material=g.material([0.2, 0.5, 0.8, 1]))
    primitive["targets"] = [{"POSITION": g.attribute(t, "VEC3", bounds=True)} for t in (shear, bloom)]
    node = g.node(mesh=g.mesh(primitive, weights=[0.5, 0.5]))
    animate(g, "breathe", node, "weights", [0, 1, 2], [0.5, 0.5, 1, 0, 0.5, 0.5])
    g.camera([2.0, 1.6, 3.2], [0.02, 0.0, 0])
    return g


def skinned_bar():
    """A bar of square section on three joints, each turned against the one below it: it curls, and uncurls."""
    g = Gltf()
    steps, height, half = 12, 3.0, 0.3
    positions, normals, joints, weights, indices = [], [], [], [], []
    for side in range(4):
        n = [[0, 0, 1], [1, 0, 0], [0, 0, -1], [-1, 0, 0]][side]
        right = cross([0, 1, 0], n)
        first = len(positions)
        for i in range(steps + 1):
            y = height * i / steps
            along = min(max(y - 0.5, 0.0), 2.0)  # 0, 1 and 2 at the middle of each joint's reach
            low = min(int(along), 1)
            share = single(along - low)
            for s in (-1, 1):
                positions.append([half * (n[0] + s * right[0]), y, half * (n[2] + s * right[2])])
                normals.append(n)
                joints.append([low if share < 1 else 0, low + 1 if share > 0 else 0, 0, 0])
                weights.append([1 - share, share, 0, 0])
        for i in range(steps):
            a = first + 2 * i
            indices += [a, a + 1, a + 3, a, a + 3, a + 2]
    primitive = g.primitive(positions, normals, indices=indices, material=g.material([0.75, 0.3, 0.2, 1], doubleSided=True))
    primitive["attributes"]["JOINTS_0"] = g.attribute(joints, "VEC4", U16)
    primitive["attributes"]["WEIGHTS_0"] = g.attribute(weights, "VEC4")
    bones = [g.node(root=k == 0, name=f"joint {k}", translation=[0, 1 if k else 0, 0]) for k in range(3)]
    for k in (0, 1):
        g.root["nodes"][bones[k]]["children"] = [bones[k + 1]]
    inverse = [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -k, 0, 1] for k in range(3)]
    skin = g.add("skins", {"joints": bones, "inverseBindMatrices": g.accessor(inverse, "MAT4"), "skeleton": bones[0]})
    g.node(mesh=g.mesh(primitive), skin=skin, name="bar")
    for bone in bones[1:]:
        turns = [turn([0, 0, 1], d) for d in (-35, 35, -35)]
        animate(g, "curl", bone, "rotation", [0, 1, 2], turns)
    g.camera([1.9, 2.6, 6.2], [0.45, 1.45, 0])
    return g


def mirrored_and_masked():
    """A stair and its mirror image by negative scale; behind them a masked, double-sided, bent screen."""
    g = Gltf()
    g.node(mesh=g.mesh(g.primitive(**ground(6), material=g.material([0.5, 0.5, 0.5, 1], roughness=0.9))))
    stone = g.material([0.7, 0.55, 0.4, 1], roughness=0.7)
    steps = [g.mesh(g.primitive(**box(0.4, 0.3 * (k + 1), 0.6), material=stone)) for k in range(3)]
    for x, sign in ((0.25, 1), (-0.25, -1)):
        stair = [
            g.node(root=False, mesh=step, translation=[0.2 + 0.4 * k, 0.15 * (k + 1), 0.1 * k])
            for k, step in enumerate(steps)
        ]
        g.node(translation=[x, 0, 0.6], scale=[sign, 1, 1], children=stair)

    def pixel(x, y):
        hole = math.hypot(x % 8 - 3.5, y % 8 - 3.5) < 2.6
        return (230, 200, 90, 0 if hole else 255)

    texture = g.texture(g.image(png(32, 32, pixel)), magFilter=LINEAR, minFilter=LINEAR_MIPS)
    screen = g.material(texture=texture, alphaMode="MASK", alphaCutoff=0.5, doubleSided=True, roughness=0.6)
    bent = dict(positions=[], normals=[], uv=[], indices=[])
    for i in range(13):
        angle = math.radians(-75 + 12.5 * i)
        for j in (0, 1):
            bent["positions"].append([1.6 * math.sin(angle), 1.5 * (1 - j), 0.6 - 1.6 * math.cos(angle)])
            bent["normals"].append([math.sin(angle), 0, -math.cos(angle)])
            bent["uv"].append([3 * i / 12, 1.2 * j])
        if i:
            a = 2 * i - 2
            bent["indices"] += [a, a + 2, a + 1, a + 1, a + 2, a + 3]
    g.node(mesh=g.mesh(g.primitive(**bent, material=screen)))
    g.camera([0.6, 2.6, 6.0], [0, 0.5, 0])
    return g


def blend_layers():
    """Coloured panes one behind the other, in the file from front to back: drawn in that order, all but one vanish."""
    g = Gltf()

    def pixel(x, y):
        return (235, 235, 235, 255) if (x // 4 + y // 4) % 2 else (40, 40, 40, 255)

    texture = g.texture(g.image(png(32, 32, pixel)), magFilter=NEAREST, minFilter=LINEAR_MIPS)
    wall = g.mesh(g.primitive(**quad(3, 3), material=g.material(texture=texture, roughness=0.9)))
    panes = [([0.9, 0.1, 0.1, 0.5], 0.5, 0.4), ([0.1, 0.8, 0.1, 0.5], 0.1, 0.1), ([0.1, 0.2, 0.9, 0.5], -0.3, -0.2)]
    for color, z, shift in panes:
        material = g.material(color, roughness=0.3, alphaMode="BLEND", doubleSided=True)
        mesh = g.mesh(g.primitive(**quad(1.3, 1.3), material=material))
        g.node(mesh=mesh, translation=[shift, 0.7 * shift, z])
    g.node(mesh=wall, translation=[0, 0, -1])
    g.camera([0.5, 0.4, 4.4], [0, 0, -0.3])
    return g


def lights():
    """A dim sun from the left, a warm bulb in front, a blue spot from above."""
    g = Gltf()
    grey = g.material([0.6, 0.6, 0.6, 1], roughness=0.8)
    g.node(mesh=g.mesh(g.primitive(**ground(8), material=grey)))
    g.node(mesh=g.mesh(g.primitive(**quad(8, 4), material=grey)), translation=[0, 2, -1.5])
    ball = g.mesh(g.primitive(**sphere(0.5, 14, 28), material=g.material([0.8, 0.8, 0.8, 1], roughness=0.35)))
    for x in (-1.1, 0, 1.1):
        g.node(mesh=ball, translation=[x, 0.5, 0])
    g.light([0, 3, 0], looking([-2, 3, 2], [0, 0, 0]), name="sun", type="directional", intensity=0.8)
    g.light([-0.6, 0.9, 1.0], [0, 0, 0, 1], name="bulb", type="point", intensity=1.5, color=[1, 0.6, 0.25], range=8)
    cone = {"innerConeAngle": 0.2, "outerConeAngle": 0.45}
    g.light([1.1, 3, 0.4], turn([1, 0, 0], -85), name="spot", type="spot", intensity=20, color=[0.3, 0.5, 1], spot=cone)
    g.camera([0, 1.7, 5.2], [0, 0.75, 0])
    return g


def clip_volumes():
    """Two rooms and the wall between: a warm light ends at the box of the left room, a cold one at a hexagon in the right."""
    g = Gltf()
    grey = g.material([0.7, 0.7, 0.7, 1], roughness=0.8)
    facing = {-1: turn([0, 1, 0], 90), 1: turn([0, 1, 0], -90)}
    floor, back = (g.mesh(g.primitive(**shape, material=grey)) for shape in (ground(4), quad(4, 2)))
    for side in (-1, 1):
        g.node(mesh=floor, translation=[2 * side, 0, 0])
        g.node(mesh=back, translation=[2 * side, 1, -2])
        g.node(mesh=back, translation=[4 * side, 1, 0], rotation=facing[side])
        g.node(mesh=back, translation=[0, 1, 0], rotation=facing[-side])
        ball = g.mesh(g.primitive(**sphere(0.5, 14, 28), material=g.material([0.8, 0.8, 0.8, 1], roughness=0.4)))
        g.node(mesh=ball, translation=[2.6 * side, 0.5, -0.8])
    g.node(translation=[-2, 1, 0], extras={"clip_volume": {"name": "left room", "half_size": [2, 1, 2]}})
    corners = [[math.cos(math.radians(60 * i)), y, math.sin(math.radians(60 * i))] for i in range(6) for y in (-1, 1)]
    sides = [k for i in range(6) for k in (2 * i, 2 * i + 1, (2 * i + 2) % 12)]
    sides += [k for i in range(6) for k in (2 * i + 1, (2 * i + 3) % 12, (2 * i + 2) % 12)]
    column = g.mesh(g.primitive(corners, indices=sides))
    g.node(mesh=column, translation=[2, 1, 0.4], scale=[1.2, 1, 1.2], extras={"clip_volume": {"name": "hexagon"}})
    for x, color, volume in ((-1.2, [1, 0.65, 0.3], "left room"), (1.6, [0.35, 0.6, 1], "hexagon")):
        extras = {"casts_shadow": False, "clip_volume": volume}
        g.light([x, 1.4, 0.4], [0, 0, 0, 1], name=volume, type="point", intensity=4, color=color, extras=extras)
    g.camera([0, 6.4, 6.4], [0, 0.2, -0.2])
    return g


def ambient_lights():
    """Balls of paint, plastic and metal in a row before a wall: a cool ellipsoid darkens the left end, a warm sphere
    brightens the right one."""
    g = Gltf()
    grey = g.material([0.6, 0.6, 0.6, 1], roughness=0.8)
    g.node(mesh=g.mesh(g.primitive(**ground(8), material=grey)))
    g.node(mesh=g.mesh(g.primitive(**quad(8, 4), material=grey)), translation=[0, 2, -1])
    ball = g.primitive(**sphere(0.4, 20, 40))
    for k, (metallic, roughness) in enumerate(((0, 1), (0, 0.2), (1, 0.15)) * 2):
        material = g.material([0.75, 0.7, 0.65, 1], metallic=float(metallic), roughness=roughness)
        g.node(mesh=g.mesh(dict(ball, material=material)), translation=[0.9 * (k - 2.5), 0.4, 0])
    for name, place, scale, color in (
        ("shade", [-1.35, 0.5, 0.2], [1.2, 0.7, 0.8], [0.1, 0.15, 0.25]),
        ("glow", [1.35, 1, 0.8], [1, 1, 1], [3, 2.2, 1.2]),
    ):
        light = {"color": [single(c) for c in color], "range": 2}
        g.node(name=name, translation=place, scale=scale, extras={"ambient_light": light})
    g.camera([0, 1.6, 6.8], [0, 0.6, 0])
    return g


def area_lights():
    """A bulb of 25 cm over a floor and metal balls from smooth to rough, and a far disc of 6 degrees. No shadows."""
    g = Gltf()
    dark = g.material([0.12, 0.12, 0.13, 1], roughness=0.3)
    g.node(mesh=g.mesh(g.primitive(**ground(10), material=dark)))
    ball = g.primitive(**sphere(0.42, 24, 48))
    for k, roughness in enumerate((0.1, 0.2, 0.35, 0.5, 0.7)):
        metal = g.material([0.85, 0.83, 0.8, 1], metallic=1.0, roughness=roughness)
        g.node(mesh=g.mesh(dict(ball, material=metal)), translation=[k - 2, 0.42, 0])
    bulb = {"radius": 0.25, "casts_shadow": False}
    g.light([0, 1.5, 0.5], [0, 0, 0, 1], name="bulb", type="point", intensity=4, color=[1, 0.8, 0.6], extras=bulb)
    disc = {"angular_radius": single(math.radians(6)), "casts_shadow": False}
    toward = looking([0.6, 0.5, -1.6], [0, 0, 0])
    g.light([0, 3, 0], toward, name="disc", type="directional", intensity=1, color=[0.5, 0.7, 1], extras=disc)
    g.camera([0, 1.3, 5], [0, 0.35, 0])
    return g


def projectors():
    """Two spots throw a wide picture onto a floor and a wall, one with soft edges, one of them a bulb that ends at 7 m."""

    def pixel(x, y):
        bar = x % 8 == 0 or y % 8 == 0
        return (0, 0, 0, 255) if bar else (255 - 6 * x, 60 + 14 * y % 196, 70 + 7 * x, 255)

    g = Gltf()
    grey = g.material([0.7, 0.7, 0.7, 1], roughness=0.9)
    g.node(mesh=g.mesh(g.primitive(**ground(8), material=grey)))
    g.node(mesh=g.mesh(g.primitive(**quad(8, 4), material=grey)), translation=[0, 2, -1.5])
    image = g.image(png(24, 16, pixel))
    for side, more, thrown in (
        (-1, {}, {"soft_edge": 0, "field_of_view": 0.6}),
        (1, {"radius": single(0.04), "falloff": "bulb", "cutoff": 7}, {"soft_edge": 0.5}),
    ):
        extras = {"casts_shadow": False, "projector": {"image": image, **thrown}, **more}
        cone = {"innerConeAngle": 0.45, "outerConeAngle": 0.5}
        place = [1.3 * side, 1.6, 3]
        toward = looking(place, [1.1 * side, 0.9, -1.5])
        name = "hard" if side < 0 else "soft"
        g.light(place, toward, name=name, type="spot", intensity=60, spot=cone, extras=extras)
    g.camera([0, 1.5, 5.2], [0, 0.9, 0])
    return g


def texture_transform():
    """As it is; moved by a quarter; turned by 30 degrees; scaled and turned."""
    g = Gltf()
    texture = g.texture(g.image(letter_picture()), magFilter=LINEAR, minFilter=LINEAR_MIPS)
    transforms = [{}, {"offset": [0.25, 0.25]}, {"rotation": 0.5235988}, {"scale": [2, 3], "rotation": -0.4, "offset": [0.1, 0.3]}]
    for k, transform in enumerate(transforms):
        info = {"index": texture}
        if transform:
            g.extension("KHR_texture_transform")
            info["extensions"] = {"KHR_texture_transform": transform}
        mesh = g.mesh(g.primitive(**quad(), material=g.material(texture=info, roughness=0.9)))
        g.node(mesh=mesh, translation=[1.06 * (k % 2) - 0.53, 0.53 - 1.06 * (k // 2), 0])
    g.camera([0, 0, 3.7], [0, 0, 0])
    return g


def unlit():
    """A shaded and an unlit ball of one colour, before an unlit picture."""
    g = Gltf()
    texture = g.texture(g.image(letter_picture()), magFilter=NEAREST, minFilter=LINEAR_MIPS)
    none = {"KHR_materials_unlit": {}}
    board = g.mesh(g.primitive(**quad(3, 3), material=g.material([0.5, 0.5, 0.5, 1], texture=texture, extensions=none)))
    g.node(mesh=board, translation=[0, 0, -0.8])
    ball = g.primitive(**sphere(0.5, 14, 28))
    for x, extensions in ((-0.6, None), (0.6, none)):
        material = g.material([0.9, 0.45, 0.05, 1], roughness=0.4, extensions=extensions)
        g.node(mesh=g.mesh(dict(ball, material=material)), translation=[x, 0, 0])
    g.camera([0, 0, 4], [0, 0, 0])
    return g


def emissive_strength():
    """Five bars in front of a dark wall, each twice as bright as the one before it; a faint sun."""
    g = Gltf()
    dark = g.material([0.1, 0.1, 0.1, 1], roughness=0.6)
    g.node(mesh=g.mesh(g.primitive(**quad(6, 6), material=dark)), translation=[0, 0, -0.6])
    bar = g.primitive(**box(0.3, 1.6, 0.3))
    for k in range(5):
        strength = {"KHR_materials_emissive_strength": {"emissiveStrength": 2.0**k}}
        material = g.material([0, 0, 0, 1], emissiveFactor=[0.9, 0.35, 0.12], extensions=strength)
        g.node(mesh=g.mesh(dict(bar, material=material)), translation=[0.55 * (k - 2), 0, 0])
    g.light([0, 2, 2], looking([-1, 2, 3], [0, 0, 0]), name="sun", type="directional", intensity=1)
    g.camera([0, 0.4, 4.8], [0, 0, 0])
    return g


def specular_and_ior():
    """Dark smooth balls. Upper row: index of refraction 1, 1.33, 1.8, 2.4. Lower row: specular 0, 0.5, 1, 1 tinted."""
    g = Gltf()
    upper = [{"KHR_materials_ior": {"ior": ior}} for ior in (1.0, 1.33, 1.8, 2.4)]
    lower = [{"KHR_materials_specular": {"specularFactor": s}} for s in (0.0, 0.5, 1.0)]
    lower.append({"KHR_materials_specular": {"specularColorFactor": [1.0, 0.3, 0.1]}})
    ball = g.primitive(**sphere(0.46, 14, 28))
    for row, extensions in enumerate((upper, lower)):
        for column, extension in enumerate(extensions):
            material = g.material([0.03, 0.03, 0.05, 1], roughness=0.15, extensions=extension)
            mesh = g.mesh(dict(ball, material=material))
            g.node(mesh=mesh, translation=[column - 1.5, 0.5 - row, 0])
    g.camera([0, 0, 6.9], [0, 0, 0])
    return g


def torus_knot(rings=72, sides=8):
    """The trefoil, within 1 of the origin: positions, normals, uv, indices."""

    def curve(t):
        r = 0.55 + 0.22 * math.cos(3 * t)
        return [r * math.cos(2 * t), r * math.sin(2 * t), 0.28 * math.sin(3 * t)]

    out = dict(positions=[], normals=[], uv=[], indices=[])
    for i in range(rings + 1):
        t = 2 * math.pi * i / rings
        here = curve(t)
        along = unit(sub(curve(t + 1e-3), here))
        side = unit(cross(along, here))
        up = cross(side, along)
        for j in range(sides + 1):
            angle = 2 * math.pi * j / sides
            n = [math.cos(angle) * a + math.sin(angle) * b for a, b in zip(side, up)]
            out["positions"].append([h + 0.13 * c for h, c in zip(here, n)])
            out["normals"].append(n)
            out["uv"].append([i / rings, j / sides])
    for i in range(rings):
        for j in range(sides):
            a = i * (sides + 1) + j
            b = a + sides + 1
            out["indices"] += [a, b, a + 1, a + 1, b, b + 1]
    return out


def quantized():
    """A knot in 16-bit positions and uv and 8-bit normals, scaled back by its node; stripes follow its uv."""
    g = Gltf().extension("KHR_mesh_quantization", required=True)
    knot = torus_knot()

    def to_int(rows, scale):
        return [[round(scale * x) for x in row] for row in rows]

    def pixel(x, y):
        return (230, 170, 60, 255) if (x + y) % 8 < 4 else (120, 40, 90, 255)

    texture = g.texture(g.image(png(32, 8, pixel)), magFilter=LINEAR, minFilter=LINEAR_MIPS)
    transform = {"KHR_texture_transform": {"scale": [6, 1]}}
    g.extension("KHR_texture_transform")
    material = g.material(texture={"index": texture, "extensions": transform}, roughness=0.35)
    attributes = {
        "POSITION": g.attribute(to_int(knot["positions"], 16000), "VEC3", I16, bounds=True, stride=8),
        "NORMAL": g.attribute(to_int(knot["normals"], 127), "VEC3", I8, normalized=True, stride=4),
        "TEXCOORD_0": g.attribute(to_int(knot["uv"], 65535), "VEC2", U16, normalized=True),
    }
    mesh = g.mesh({"attributes": attributes, "indices": g.indices(knot["indices"]), "material": material})
    g.node(mesh=mesh, scale=[1 / 16000] * 3)
    g.camera([0.5, 0.6, 3.1], [0, 0, 0])
    return g


def normal_map():
    """Domes in a plate and on a ball, by a normal map alone; no tangents in the file. The plate's right half has its
    texture mirrored: its domes stand out all the same."""
    g = Gltf()

    def pixel(x, y):
        dx, dy = (x % 16 - 7.5) / 7.0, (y % 16 - 7.5) / 7.0
        rise = math.hypot(dx, dy)
        n = [0.8 * dx, -0.8 * dy, math.sqrt(1 - 0.64 * rise * rise)] if rise < 1 else [0, 0, 1]
        return tuple(round(127.5 + 127.5 * c) for c in n) + (255,)

    texture = g.texture(g.image(png(16, 16, pixel)), magFilter=LINEAR, minFilter=LINEAR_MIPS)
    material = g.material([0.55, 0.6, 0.65, 1], metallic=0.0, roughness=0.35, normalTexture={"index": texture})
    plate = dict(positions=[], normals=[[0, 0, 1]] * 6, uv=[], indices=[0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4])
    for v, y in ((2, -0.6), (0, 0.6)):
        for u, x in ((0, -1.2), (2, 0), (0, 1.2)):
            plate["positions"].append([x, y, 0])
            plate["uv"].append([u, v])
    g.node(mesh=g.mesh(g.primitive(**plate, material=material)), translation=[0, -0.62, 0])
    ball = sphere(0.6, 12, 24, with_uv=True)
    ball["uv"] = [[8 * u, 4 * v] for u, v in ball["uv"]]
    g.node(mesh=g.mesh(g.primitive(**ball, material=material)), translation=[0, 0.66, 0])
    g.light([0, 2, 2], looking([-2, 2.5, 3], [0, 0, 0]), name="sun", type="directional", intensity=3)
    g.camera([0, 0, 4.3], [0, 0, 0])
    return g


def bumpy_metal():
    """A metal floor under a sun before the camera. Its bumps, a normal map alone, are soon smaller than pixels."""
    g = Gltf()
    size, waves = 64, []
    numbers = random.Random(3)
    while len(waves) < 24:  # of whole periods a tile, each as steep as the others: a deviation of 0.1 along each axis
        u, v = (math.floor(25 * numbers.random()) - 12 for _ in range(2))
        if math.hypot(u, v) >= 3:
            steepness = 0.1 * math.sqrt(4 / 24)
            waves.append((u, v, steepness / math.hypot(u, v), 2 * math.pi * numbers.random()))

    def pixel(x, y):
        du = dv = 0.0
        for u, v, height, phase in waves:
            slope = height * math.cos(2 * math.pi * (u * x + v * y) / size + phase)
            du, dv = du + u * slope, dv + v * slope
        return tuple(round(127.5 + 127.5 * c) for c in unit([-du, dv, 1])) + (255,)

    texture = g.texture(g.image(png(size, size, pixel)), magFilter=LINEAR, minFilter=LINEAR_MIPS)
    metal = g.material([0.9, 0.88, 0.85, 1], metallic=1.0, roughness=0.4, normalTexture={"index": texture})
    floor = ground(120)
    floor["uv"] = [[240 * c for c in uv] for uv in floor["uv"]]
    g.node(mesh=g.mesh(g.primitive(**floor, material=metal)))
    g.light([0, 5, 0], turn([1, 0, 0], 215), name="sun", type="directional", intensity=0.5)
    g.camera([0, 7, 7], [0, 0, -3])
    return g


def orthographic():
    """A stair of cubes in isometric view: edges of equal length are equally long in the picture."""
    g = Gltf()
    cube = g.primitive(**box())
    colors = ([0.8, 0.25, 0.2, 1], [0.85, 0.7, 0.2, 1], [0.2, 0.5, 0.75, 1])
    meshes = [g.mesh(dict(cube, material=g.material(c, roughness=0.7))) for c in colors]
    for x in range(3):
        for z in range(3):
            for y in range(3 - max(x, z)):
                g.node(mesh=meshes[y], translation=[x - 1, y - 1, z - 1])
    lens = {"type": "orthographic", "orthographic": {"xmag": 2.7, "ymag": 2.7, "znear": 0.1, "zfar": 20}}
    g.node(name="camera", camera=g.add("cameras", lens), translation=[5, 5, 5], rotation=looking([1, 1, 1], [0, 0, 0]))
    return g


def embedded():
    """A crate: positions, picture and all in one binary file."""
    g = Gltf()

    def pixel(x, y):
        frame = min(x, y, 31 - x, 31 - y) < 4 or abs(x - y) < 3
        grain = 18 * ((x * 7 + y * 3) % 5)
        return (150 + grain // 2, 100 + grain // 2, 50 + grain // 3, 255) if frame else (190, 140 + grain // 4, 80, 255)

    texture = g.texture(g.image(png(32, 32, pixel)), magFilter=LINEAR, minFilter=LINEAR_MIPS, wrapS=CLAMP, wrapT=CLAMP)
    g.node(mesh=g.mesh(g.primitive(**box(), material=g.material(texture=texture, roughness=0.8))))
    g.camera([1.5, 1.3, 2.2], [0, -0.03, 0])
    return g


def vase_shape(segments=12, rings=8):
    """Turned on a lathe, without a bottom: what vase, vase_draco and vase_meshopt hold, each in its way."""

    def radius(t):
        return 0.34 + 0.2 * math.sin(2.6 * math.pi * t + 0.2) * (1 - 0.55 * t)

    out = dict(positions=[], normals=[], indices=[])
    for i in range(rings + 1):
        t = i / rings
        slope = (radius(t + 1e-3) - radius(t - 1e-3)) / 2e-3 / 1.6
        for j in range(segments + 1):
            turned = [math.sin(2 * math.pi * j / segments), math.cos(2 * math.pi * j / segments)]
            out["positions"].append([single(c) for c in (radius(t) * turned[0], 1.6 * t - 0.8, radius(t) * turned[1])])
            out["normals"].append([single(c) for c in unit([turned[0], -slope, turned[1]])])
    for i in range(rings):
        for j in range(segments):
            a = i * (segments + 1) + j
            b = a + segments + 1
            out["indices"] += [a, a + 1, b, b, a + 1, b + 1]
    return out


def vase_scene(g, primitive):
    primitive["material"] = g.material([0.15, 0.35, 0.55, 1], roughness=0.3, doubleSided=True)
    g.node(mesh=g.mesh(primitive))
    g.light([0, 2, 2], looking([2, 2.5, 3], [0, 0, 0]), name="sun", type="directional", intensity=2)
    g.camera([0, 1.0, 3.4], [0, 0, 0])
    return g


def vase():
    """As it is; two more files hold the same, compressed."""
    g = Gltf()
    return vase_scene(g, g.primitive(**vase_shape()))


def without_view(g, rows, kind, component=FLOAT, **more):
    """An accessor that an extension fills."""
    item = {"componentType": component, "count": len(rows), "type": kind, **more}
    if kind != "SCALAR":
        item["min"] = [min(column) for column in zip(*rows)]
        item["max"] = [max(column) for column in zip(*rows)]
    return g.add("accessors", item)


def vase_draco():
    g = Gltf().extension("KHR_draco_mesh_compression", required=True)
    shape = vase_shape()
    data = draco_mesh(
        [(DRACO_POSITION, 0, shape["positions"]), (DRACO_NORMAL, 1, shape["normals"])], shape["indices"]
    )
    extension = {"bufferView": g.view(data), "attributes": {"POSITION": 0, "NORMAL": 1}}
    attributes = {
        "POSITION": without_view(g, shape["positions"], "VEC3"),
        "NORMAL": without_view(g, shape["normals"], "VEC3"),
    }
    primitive = {
        "attributes": attributes,
        "indices": without_view(g, shape["indices"], "SCALAR", U16),
        "extensions": {"KHR_draco_mesh_compression": extension},
    }
    return vase_scene(g, primitive)


def compressed_view(g, data, stride, count, mode, compression_filter="NONE", **more):
    """A view of a buffer without data, whose bytes `data` holds compressed."""
    index = g.view(data)
    packed = g.root["bufferViews"][index]
    extension = dict(packed, byteStride=stride, count=count, mode=mode, filter=compression_filter)
    view = {"buffer": 1, "byteOffset": g.fallback, "byteLength": stride * count, **more}
    g.fallback += (stride * count + 3) // 4 * 4
    return g.add("bufferViews", dict(view, extensions={"EXT_meshopt_compression": extension}))


def vase_meshopt():
    """Positions by the exponential filter, normals in bytes by the octahedral one, triangles."""
    g = Gltf().extension("EXT_meshopt_compression", required=True).extension("KHR_mesh_quantization", required=True)
    g.fallback = 0
    shape = vase_shape()
    points, corners = len(shape["positions"]), len(shape["indices"])
    position = without_view(g, shape["positions"], "VEC3")
    data = meshopt_attributes([exponential(p) for p in shape["positions"]])
    g.root["accessors"][position]["bufferView"] = compressed_view(g, data, 12, points, "ATTRIBUTES", "EXPONENTIAL")
    data = meshopt_attributes([octahedral(n) for n in shape["normals"]])
    view = compressed_view(g, data, 4, points, "ATTRIBUTES", "OCTAHEDRAL", byteStride=4)
    normal = {"bufferView": view, "componentType": I8, "normalized": True, "count": points, "type": "VEC3"}
    view = compressed_view(g, meshopt_triangles(shape["indices"]), 2, corners, "TRIANGLES")
    index = {"bufferView": view, "componentType": U16, "count": corners, "type": "SCALAR"}
    primitive = {
        "attributes": {"POSITION": position, "NORMAL": g.add("accessors", normal)},
        "indices": g.add("accessors", index),
    }
    g.more_buffers = [{"byteLength": g.fallback, "extensions": {"EXT_meshopt_compression": {"fallback": True}}}]
    return vase_scene(g, primitive)


def gpu_instancing():
    """A ring of twelve blocks, copies of one node: each is farther along, turned and taller. The node itself is raised."""
    g = Gltf().extension("EXT_mesh_gpu_instancing", required=True)
    g.node(mesh=g.mesh(g.primitive(**ground(6), material=g.material([0.5, 0.5, 0.5, 1], roughness=0.9))))
    block = g.mesh(g.primitive(**box(0.35, 0.5, 0.2), material=g.material([0.8, 0.45, 0.2, 1], roughness=0.5)))
    angles = [30 * k for k in range(12)]
    places = [[1.5 * math.sin(math.radians(a)), 0.25 * (1 + 0.15 * k), 1.5 * math.cos(math.radians(a))] for k, a in enumerate(angles)]
    columns = {
        "TRANSLATION": g.accessor(places, "VEC3"),
        "ROTATION": g.accessor([[round(32767 * c) for c in turn([0, 1, 0], a)] for a in angles], "VEC4", I16, normalized=True),
        "SCALE": g.accessor([[1, 1 + 0.15 * k, 1] for k in range(12)], "VEC3"),
    }
    g.node(mesh=block, translation=[0, 0.1, 0], extensions={"EXT_mesh_gpu_instancing": {"attributes": columns}})
    g.light([0, 3, 0], looking([2, 3, 2], [0, 0, 0]), name="sun", type="directional", intensity=2)
    g.camera([0.8, 2.4, 4.6], [0, 0.25, 0])
    return g


def webp_texture():
    """An F in WebP; the texture's other picture, for those who cannot read it, is plain grey."""
    g = Gltf().extension("EXT_texture_webp")

    def pixel(x, y):
        letter = (x in (4, 5) and 3 <= y < 13) or (y in (3, 4) and 4 <= x < 12) or (y in (7, 8) and 4 <= x < 10)
        if letter:
            return (250, 240, 40)
        return (20, 60, 160) if (x // 8 + y // 8) % 2 else (20, 240, 160)

    grey = g.image(png(1, 1, lambda x, y: (128, 128, 128, 255)))
    picture = g.image(webp(16, 16, pixel), "image/webp")
    texture = g.texture(grey, magFilter=NEAREST, minFilter=LINEAR_MIPS)
    g.root["textures"][texture]["extensions"] = {"EXT_texture_webp": {"source": picture}}
    g.node(mesh=g.mesh(g.primitive(**quad(2, 2), material=g.material(texture=texture, roughness=0.9))))
    g.camera([0, 0, 3.7], [0, 0, 0])
    return g


def variants():
    """A bench of one mesh: 'beech' and 'walnut' change the seat, 'walnut' and 'steel' the legs; steel keeps its seat."""
    g = Gltf().extension("KHR_materials_variants")
    names = ("beech", "walnut", "steel")
    g.root["extensions"] = {"KHR_materials_variants": {"variants": [{"name": name} for name in names]}}
    white = g.material([0.8, 0.8, 0.8, 1], roughness=0.8)
    beech = g.material([0.75, 0.5, 0.28, 1], roughness=0.6)
    walnut = g.material([0.16, 0.07, 0.03, 1], roughness=0.5)
    steel = g.material([0.6, 0.6, 0.62, 1], metallic=1.0, roughness=0.3)

    def mapped(shape, *mappings):
        primitive = g.primitive(**shape, material=white)
        entries = [{"material": material, "variants": list(which)} for material, which in mappings]
        primitive["extensions"] = {"KHR_materials_variants": {"mappings": entries}}
        return primitive

    seat, leg = box(2.0, 0.15, 0.7), box(0.12, 0.7, 0.6)
    seat_mesh = g.mesh(mapped(seat, (beech, (0,)), (walnut, (1,))))
    leg_mesh = g.mesh(mapped(leg, (walnut, (1,)), (steel, (2,))))
    g.node(mesh=seat_mesh, translation=[0, 0.42, 0])
    for x in (-0.8, 0.8):
        g.node(mesh=leg_mesh, translation=[x, 0, 0])
    g.camera([1.2, 1.3, 3.4], [0, 0.05, 0])
    return g


def gloss_balls(material_of):
    """Four balls: matt clay, polished clay, gold, and gold that is dull on its right; material_of(g, number) is of each."""
    g = Gltf()
    materials = [material_of(g, k) for k in range(4)]
    ball = g.primitive(**sphere(0.48, 8, 16, with_uv=True), material=materials[3])
    for k in range(4):
        g.node(mesh=g.mesh(dict(ball, material=materials[k])), translation=[k % 2 - 0.5, 0.5 - k // 2, 0])
    g.camera([0, 0, 3.9], [0, 0, 0])
    return g


CLAY, GOLD = [0.5, 0.2, 0.1], [1.0, 0.78, 0.34]
# Gloss of the fourth ball, of 255, for u below and above a half.
DULL, SHINY = 64, 204


def half_picture(left, right):
    return png(8, 1, lambda x, y: left if x < 4 else right)


def specular_glossiness():
    """Clay reflects 4 %, as any dielectric of index 1.5; gold has no diffuse light. The fourth ball's gloss is a picture."""

    def material(g, k):
        clay = k < 2
        extension = {
            "diffuseFactor": (CLAY if clay else [0, 0, 0]) + [1],
            "specularFactor": [0.04, 0.04, 0.04] if clay else GOLD,
            "glossinessFactor": (0.2, 0.8, 0.8, 1.0)[k],
        }
        if k == 3:
            picture = half_picture((255, 255, 255, DULL), (255, 255, 255, SHINY))
            texture = g.texture(g.image(picture), magFilter=NEAREST, minFilter=NEAREST)
            extension["specularGlossinessTexture"] = {"index": texture}
        return g.material([1, 0, 1, 1], extensions={"KHR_materials_pbrSpecularGlossiness": extension})

    return gloss_balls(material)


def metallic_roughness():
    """What specular_glossiness.gltf says, in the core's own terms."""

    def material(g, k):
        clay = k < 2
        out = g.material((CLAY if clay else GOLD) + [1], metallic=0.0 if clay else 1.0, roughness=(0.8, 0.2, 0.2, 1.0)[k])
        if k == 3:
            picture = half_picture((0, 255 - DULL, 255, 255), (0, 255 - SHINY, 255, 255))
            texture = g.texture(g.image(picture), magFilter=NEAREST, minFilter=NEAREST)
            g.root["materials"][out]["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {"index": texture}
        return out

    return gloss_balls(material)


SCENES = [
    triangle,
    wrap_modes,
    vertex_colors,
    sparse,
    primitive_modes,
    morph_cube,
    skinned_bar,
    mirrored_and_masked,
    blend_layers,
    lights,
    clip_volumes,
    ambient_lights,
    area_lights,
    projectors,
    texture_transform,
    unlit,
    emissive_strength,
    specular_and_ior,
    quantized,
    normal_map,
    bumpy_metal,
    orthographic,
    vase,
    vase_draco,
    vase_meshopt,
    gpu_instancing,
    webp_texture,
    variants,
    specular_glossiness,
    metallic_roughness,
]


def main():
    default = pathlib.Path(__file__).resolve().parent.parent / "tests" / "data"
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else default
    folder.mkdir(parents=True, exist_ok=True)
    for scene in SCENES:
        scene().write_gltf(folder / f"{scene.__name__}.gltf")
    embedded().write_glb(folder / "embedded.glb")


if __name__ == "__main__":
    main()
