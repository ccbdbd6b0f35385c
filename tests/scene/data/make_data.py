#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the glTF files of this folder. Run it here after a change; its outputs are committed."""
import base64
import json
import math
import struct
import zlib


class File:
    def __init__(self, buffer_uri=None):
        self.data = b""
        self.uri = buffer_uri
        self.doc = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}], "nodes": [], "meshes": [],
                    "accessors": [], "bufferViews": [], "buffers": []}

    def view(self, data, stride=None):
        self.data += b"\0" * (-len(self.data) % 4)
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data)}
        if stride:
            view["byteStride"] = stride
        self.data += data
        self.doc["bufferViews"].append(view)
        return len(self.doc["bufferViews"]) - 1

    def accessor(self, fmt, component, kind, rows, stride=None, **more):
        width = struct.calcsize("<" + fmt)
        pad = (stride or width) - width
        data = b"".join(struct.pack("<" + fmt, *row) + b"\0" * pad for row in rows)
        accessor = {"bufferView": self.view(data, stride), "componentType": component, "count": len(rows), "type": kind}
        if "min" in more:
            more["min"], more["max"] = [min(c) for c in zip(*rows)], [max(c) for c in zip(*rows)]
        self.doc["accessors"].append({**accessor, **more})
        return len(self.doc["accessors"]) - 1

    def positions(self, rows):
        return self.accessor("3f", 5126, "VEC3", rows, min=True)

    def add(self, key, value):
        self.doc.setdefault(key, []).append(value)
        return len(self.doc[key]) - 1

    def node(self, root=True, **members):
        index = self.add("nodes", members)
        if root:
            self.doc["scenes"][0]["nodes"].append(index)
        return index

    def write(self, name):
        uri = self.uri
        if uri:
            open(uri, "wb").write(self.data)
        else:
            uri = "data:application/octet-stream;base64," + base64.b64encode(self.data).decode()
        self.doc["buffers"] = [{"byteLength": len(self.data), "uri": uri}]
        doc = {k: v for k, v in self.doc.items() if v != []}
        open(name, "w").write(json.dumps(doc, indent=1) + "\n")


def png(width, height, pixels):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + bytes(v for x in range(width) for v in pixels[y * width + x]) for y in range(height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", width, height, 8, 6, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


QUAD = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]


def modes():
    """Each mesh has one primitive of one mode; indices of every type, and none. The buffer is a file beside this one."""
    f = File("modes%20buffer.bin".replace("%20", " "))
    p = f.positions(QUAD)
    z = f.positions([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)])
    u8 = f.accessor("B", 5121, "SCALAR", [(i,) for i in (0, 1, 2, 0, 2, 3)])
    u16 = f.accessor("H", 5123, "SCALAR", [(i,) for i in (0, 1, 2, 3)])
    u32 = f.accessor("I", 5125, "SCALAR", [(i,) for i in (0, 1, 2, 3)])
    primitives = [
        ("points", {"attributes": {"POSITION": p}, "mode": 0}),
        ("lines", {"attributes": {"POSITION": p}, "mode": 1, "indices": u16}),
        ("loop", {"attributes": {"POSITION": p}, "mode": 2, "indices": u32}),
        ("line strip", {"attributes": {"POSITION": p}, "mode": 3}),
        ("triangles", {"attributes": {"POSITION": p}, "mode": 4, "indices": u8}),
        ("strip", {"attributes": {"POSITION": z}, "mode": 5, "indices": u32}),
        ("fan", {"attributes": {"POSITION": p}, "mode": 6}),
    ]
    for name, primitive in primitives:
        f.node(name=name, mesh=f.add("meshes", {"primitives": [primitive]}))
    f.write("modes.gltf")
    text = open("modes.gltf").read().replace("modes buffer.bin", "modes%20buffer.bin")
    open("modes.gltf", "w").write(text)


def packed():
    """Sparse, normalised, quantised and interleaved accessors."""
    f = File()
    f.doc["extensionsUsed"] = f.doc["extensionsRequired"] = ["KHR_mesh_quantization"]
    # Shorts, normalised and not, eight bytes apart.
    half = 32767
    norm = f.accessor("3h", 5122, "VEC3", [(-half, -half, 0), (half, -half, 0), (half, half, 0), (-half, half, 0)], stride=8,
                      normalized=True, min=True)
    plain = f.accessor("3B", 5121, "VEC3", [(0, 0, 0), (200, 0, 0), (200, 100, 0), (0, 100, 0)], stride=4, min=True)
    normal = f.accessor("3b", 5120, "VEC3", [(0, 0, 127)] * 4, stride=4, normalized=True)
    index = f.accessor("H", 5123, "SCALAR", [(i,) for i in (0, 1, 2, 0, 2, 3)])
    uv = f.accessor("2H", 5123, "VEC2", [(0, 65535), (65535, 65535), (65535, 0), (0, 0)], normalized=True)
    color3 = f.accessor("3B", 5121, "VEC3", [(255, 0, 0), (0, 255, 0), (0, 0, 255), (51, 102, 153)], stride=4, normalized=True)
    color4 = f.accessor("4H", 5123, "VEC4", [(65535, 0, 0, 65535)] * 3 + [(0, 0, 0, 13107)], normalized=True)
    f.node(name="normalised", scale=[2, 2, 2], mesh=f.add("meshes", {"primitives": [
        {"attributes": {"POSITION": norm, "NORMAL": normal, "TEXCOORD_0": uv, "COLOR_0": color3}, "indices": index}]}))
    f.node(name="plain", scale=[0.01, 0.01, 0.01], mesh=f.add("meshes", {"primitives": [
        {"attributes": {"POSITION": plain, "NORMAL": normal, "COLOR_0": color4}, "indices": index}]}))
    # A quad whose third corner is moved, and one that starts from zeros.
    sparse_index = f.view(struct.pack("<H", 2))
    sparse_value = f.view(struct.pack("<3f", 5, 5, 5))
    base = f.positions(QUAD)
    moved = dict(f.doc["accessors"][base], max=[5, 5, 5], sparse={
        "count": 1, "indices": {"bufferView": sparse_index, "componentType": 5123}, "values": {"bufferView": sparse_value}})
    moved = f.add("accessors", moved)
    zero_index = f.view(struct.pack("<2B", 1, 2))
    zero_value = f.view(struct.pack("<6f", 3, 0, 0, 0, 4, 0))
    zeros = f.add("accessors", {"componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [3, 4, 0], "sparse": {
        "count": 2, "indices": {"bufferView": zero_index, "componentType": 5121}, "values": {"bufferView": zero_value}}})
    f.node(name="sparse", mesh=f.add("meshes", {"primitives": [{"attributes": {"POSITION": moved}, "indices": index}]}))
    f.node(name="zeros", mesh=f.add("meshes", {"primitives": [{"attributes": {"POSITION": zeros}}]}))
    # Positions and normals of one view, 24 bytes apart.
    rows = b"".join(struct.pack("<6f", *(p + (0, 0, 1))) for p in QUAD)
    view = f.view(rows, 24)
    both = [f.add("accessors", {"bufferView": view, "byteOffset": o, "componentType": 5126, "count": 4, "type": "VEC3"}) for o in (0, 12)]
    f.doc["accessors"][both[0]].update(min=[0, 0, 0], max=[1, 1, 0])
    f.node(name="interleaved", mesh=f.add("meshes", {"primitives": [
        {"attributes": {"POSITION": both[0], "NORMAL": both[1]}, "indices": index}]}))
    f.write("packed.gltf")


def textured():
    """One image as a file, one in the buffer, one as a data URI; a transformed texture, cut-out, samplers, a broken image."""
    f = File()
    f.doc["extensionsUsed"] = ["KHR_texture_transform", "KHR_materials_unlit"]
    red, clear = (255, 0, 0, 255), (0, 255, 0, 0)
    checker = png(2, 2, [red, clear, clear, red])
    open("checker.png", "wb").write(checker)
    f.add("images", {"uri": "checker.png"})
    f.add("images", {"bufferView": f.view(png(1, 2, [(1, 2, 3, 4), (5, 6, 7, 8)])), "mimeType": "image/png"})
    f.add("images", {"uri": "data:image/png;base64," + base64.b64encode(png(1, 1, [(9, 8, 7, 6)])).decode()})
    f.add("images", {"uri": "data:image/png;base64," + base64.b64encode(checker[:40]).decode()})
    f.add("samplers", {"wrapS": 33071, "wrapT": 33648, "magFilter": 9728})
    for source in range(4):
        f.add("textures", {"source": source, **({"sampler": 0} if source == 0 else {})})
    f.add("textures", {"source": 0})
    transform = {"KHR_texture_transform": {"offset": [0.5, 0.25], "rotation": math.pi / 2, "scale": [2, 3], "texCoord": 1}}
    names = ["file", "buffer", "data", "broken"]
    for texture, name in enumerate(names):
        f.add("materials", {"name": name, "pbrMetallicRoughness": {"baseColorTexture": {"index": texture}}})
    f.doc["materials"][0].update(alphaMode="MASK", alphaCutoff=0.25, doubleSided=True)
    f.doc["materials"][1]["extensions"] = {"KHR_materials_unlit": {}}
    f.add("materials", {"name": "transformed", "pbrMetallicRoughness": {
        "baseColorFactor": [0.5, 0.25, 1, 1], "baseColorTexture": {"index": 4, "extensions": transform}}})
    p = f.positions(QUAD)
    index = f.accessor("B", 5121, "SCALAR", [(i,) for i in (0, 1, 2, 0, 2, 3)])
    uv0 = f.accessor("2f", 5126, "VEC2", [(0, 1), (1, 1), (1, 0), (0, 0)])
    uv1 = f.accessor("2f", 5126, "VEC2", [(0, 0), (1, 0), (1, 1), (0, 1)])
    for material, name in enumerate(names + ["transformed"]):
        f.node(name=name, translation=[2 * material, 0, 0], mesh=f.add("meshes", {"primitives": [
            {"attributes": {"POSITION": p, "TEXCOORD_0": uv0, "TEXCOORD_1": uv1}, "indices": index, "material": material}]}))
    f.write("textured.gltf")


def posed():
    """A strip bent by two joints, and a morphed triangle. The skinned node's own translation must not count."""
    f = File()
    f.doc["extensionsUsed"] = []
    p = f.positions([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 2, 0), (1, 2, 0)])
    index = f.accessor("H", 5123, "SCALAR", [(i,) for i in (0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5)])
    joints = f.accessor("4B", 5121, "VEC4", [(0, 9, 9, 9)] * 2 + [(0, 1, 0, 0)] * 2 + [(1, 0, 0, 0)] * 2)
    weights = f.accessor("4f", 5126, "VEC4", [(1, 0, 0, 0)] * 2 + [(0.5, 0.5, 0, 0)] * 2 + [(1, 0, 0, 0)] * 2)
    bind = f.accessor("16f", 5126, "MAT4", [(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1),
                                            (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1)])
    strip = f.add("meshes", {"primitives": [{"attributes": {"POSITION": p, "JOINTS_0": joints, "WEIGHTS_0": weights}, "indices": index}]})
    f.node(name="strip", mesh=strip, skin=0, translation=[100, 100, 100])
    upper = f.node(False, name="upper", translation=[0, 1, 2])
    lower = f.node(name="lower", children=[upper])
    f.add("skins", {"joints": [lower, upper], "inverseBindMatrices": bind})
    triangle = f.positions([(0, 0, 0), (1, 0, 0), (0, 1, 0)])
    target = f.positions([(0, 0, 1), (0, 0, 1), (0, 0, 1)])
    f.node(name="morphed", mesh=f.add("meshes", {"weights": [1], "primitives": [
        {"attributes": {"POSITION": triangle}, "targets": [{"POSITION": target}]}]}))
    f.doc.pop("extensionsUsed")
    f.write("posed.gltf")


def lit():
    """A hierarchy with a mirrored and a matrix node, two cameras (one orthographic), a spot light and a point light."""
    f = File()
    f.doc["extensionsUsed"] = ["KHR_lights_punctual"]
    f.doc["extensions"] = {"KHR_lights_punctual": {"lights": [
        {"type": "spot", "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.5}}, {"type": "point"}]}}
    mesh = f.add("meshes", {"primitives": [{"attributes": {"POSITION": f.positions(QUAD)}, "mode": 6}]})
    mirrored = f.node(False, name="mirrored", mesh=mesh, scale=[-1, 1, 1])
    s = math.sqrt(0.5)
    f.node(name="turned", rotation=[s, 0, 0, s], translation=[1e9, 0.25, 3], children=[mirrored])
    f.node(name="matrix", mesh=mesh, matrix=[0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 1e9, 0, 0, 1])
    f.add("cameras", {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0.1, "zfar": 9}})
    f.add("cameras", {"type": "perspective", "perspective": {"yfov": math.pi / 4, "znear": 0.5}})
    f.node(name="flat", camera=0)
    f.node(name="eye", camera=1, translation=[1e9, 2, 10], scale=[3, 3, 3])
    f.node(name="lamp", translation=[1e9, 8, 0], rotation=[-s, 0, 0, s], extensions={"KHR_lights_punctual": {"light": 0}})
    f.node(name="bulb", extensions={"KHR_lights_punctual": {"light": 1}})
    f.write("lit.gltf")


for make in (modes, packed, textured, posed, lit):
    make()
