# SPDX-License-Identifier: MIT
"""check_stage.py FILM.usda COPPERMOON: OpenUSD reads a film's stage. Its material, node by node, is the Moon of the film's textures; its
moonlight is their illuminance; its camera looks at the Moon."""
import json
import math
import os
import subprocess
import sys

import numpy as np
import OpenImageIO as oiio
from pxr import Gf, Usd, UsdGeom, UsdLux, UsdShade

path, program = sys.argv[1:]
stage = Usd.Stage.Open(path)


def texels(name):
    pixels = oiio.ImageBuf(os.path.join(os.path.dirname(path), name)).get_pixels(oiio.FLOAT)
    return pixels[..., :3].astype(float)


def looked_up(image, u, v, periodic):
    """Texels between straight lines; v from below."""
    height, width, _ = image.shape
    x, y = u * width - 0.5, (1 - v) * height - 0.5
    i, j = np.floor(x).astype(int), np.floor(y).astype(int)
    a, b = (x - i)[..., None], (y - j)[..., None]
    columns = (lambda c: c % width) if periodic else (lambda c: np.clip(c, 0, width - 1))
    rows = lambda r: np.clip(r, 0, height - 1)
    return ((image[rows(j), columns(i)] * (1 - a) + image[rows(j), columns(i + 1)] * a) * (1 - b) +
            (image[rows(j + 1), columns(i)] * (1 - a) + image[rows(j + 1), columns(i + 1)] * a) * b)


class Nodes:
    """Values of shading nodes at places of the Moon, at one time."""

    def __init__(self, places, st, time):
        self.places, self.st, self.time, self.known = places, st, time, {}

    def input(self, prim, name):
        found = UsdShade.ConnectableAPI(prim).GetInput(name)
        source = found.GetConnectedSources()[0]
        if not source:
            value = found.Get(self.time)
            return np.atleast_1d(np.array(value, dtype=float)) if not hasattr(value, "path") else value.path
        prim, output = source[0].source.GetPrim(), source[0].sourceName
        if prim.IsA(UsdShade.NodeGraph) and not prim.IsA(UsdShade.Material):
            if source[0].sourceType == UsdShade.AttributeType.Input:
                return self.input(prim, output)
            inner = UsdShade.NodeGraph(prim).GetOutput(output).GetConnectedSources()[0][0]
            return self.value(inner.source.GetPrim())
        return self.value(prim)

    def value(self, prim):
        if prim.GetPath() not in self.known:
            self.known[prim.GetPath()] = self.computed(prim)
        return self.known[prim.GetPath()]

    def computed(self, prim):
        kind = UsdShade.Shader(prim).GetShaderId().split("_")[1]
        of = lambda name: self.input(prim, name)
        if kind == "position":
            return self.places
        if kind == "image":
            declared = UsdShade.Shader(prim).GetInput("texcoord")
            uv = of("texcoord") if declared and declared.HasConnectedSource() else self.st
            periodic = UsdShade.Shader(prim).GetInput("uaddressmode").Get() == "periodic"
            return looked_up(texels(of("file")), uv[..., 0], uv[..., 1], periodic)
        if kind == "combine2":
            a, b = np.broadcast_arrays(of("in1"), of("in2"))
            return np.concatenate([a, b], axis=-1)
        return {
            "add": lambda: of("in1") + of("in2"), "subtract": lambda: of("in1") - of("in2"),
            "multiply": lambda: of("in1") * of("in2"), "divide": lambda: of("in1") / of("in2"),
            "min": lambda: np.minimum(of("in1"), of("in2")), "clamp": lambda: np.clip(of("in"), 0, 1),
            "dotproduct": lambda: np.sum(of("in1") * of("in2"), axis=-1, keepdims=True),
            "normalize": lambda: of("in") / np.linalg.norm(of("in"), axis=-1, keepdims=True),
            "sqrt": lambda: np.sqrt(of("in")), "floor": lambda: np.floor(of("in")),
            "atan2": lambda: np.arctan2(of("iny"), of("inx")),
            "mix": lambda: of("bg") + (of("fg") - of("bg")) * of("mix")}[kind]()


def places_of(height):
    """Places of a texture's texels on the stage's axes, [row][column], and their st."""
    latitude = np.pi / 2 - (np.arange(height) + 0.5) * np.pi / height
    longitude = (np.arange(2 * height) + 0.5) * np.pi / height - np.pi
    latitude, longitude = np.meshgrid(latitude, longitude, indexing="ij")
    places = np.stack([np.cos(latitude) * np.sin(longitude), np.sin(latitude), np.cos(latitude) * np.cos(longitude)], -1)
    return places, np.stack([longitude / (2 * np.pi) + 0.5, latitude / np.pi + 0.5], -1)


assert UsdGeom.GetStageUpAxis(stage) == "Y" and UsdGeom.GetStageMetersPerUnit(stage) == 1
first, last = stage.GetStartTimeCode(), stage.GetEndTimeCode()
data = stage.GetRootLayer().customLayerData["coppermoon"]
contacts = data["contacts"]
assert first <= contacts["U1"] < contacts["U2"] < contacts["U3"] < contacts["U4"] <= last, contacts
surface = stage.GetPrimAtPath("/Moon/Looks/Moonlight/MaterialX")
camera = UsdGeom.Camera(stage.GetPrimAtPath("/Moon/Observer"))
light = UsdLux.DistantLight(stage.GetPrimAtPath("/Moon/Moonlight"))
assert light.GetNormalizeAttr().Get()
weights = np.array([0.2126, 0.7152, 0.0722])
worst = 0
for time in (first, (first + contacts["U1"]) // 2, contacts["U2"] // 1, (first + last) // 2, last):
    name = stage.GetPrimAtPath("/Moon/Looks/Moonlight/Texture").GetAttribute("inputs:file").Get(time).path
    texture = texels(name)
    height = texture.shape[0]
    places, st = places_of(height)
    drawn = Nodes(places, st, time).input(surface, "emission_color")
    brightest = texture.max(axis=-1, keepdims=True)
    # the limb, where the Sun's own way counts, is seen from the side
    view = camera.ComputeLocalToWorldTransform(time)
    eye = np.array(view.ExtractTranslation())
    facing = places @ eye > 1 + 0.2 * np.linalg.norm(eye)
    off = np.abs(drawn - texture) / np.maximum(brightest, 1e-12)
    worst = max(worst, off[facing].max())
    print(f"{time:g}: {off[facing].max():.4f} of the brightest channel, mean {off[facing].mean():.5f}")
    assert off[facing].max() < 0.02, "1 %, ground of another colour than the mean, and what air by altitude reddens"

    # moonlight: sum of L cos e dA / d^2 over the texture
    area = (np.pi / height) ** 2 * np.sqrt(1 - places[..., 1] ** 2)
    towards = places @ eye
    squared = eye @ eye + 1 - 2 * towards
    lux = ((area * np.maximum(towards - 1, 0) / squared ** 1.5)[..., None] * texture).sum(axis=(0, 1))
    shining = light.GetIntensityAttr().Get(time) * np.array(light.GetColorAttr().Get(time))
    assert np.all(np.abs(shining - lux) < 0.01 * lux.max()), (shining, lux)
    ray = np.array(light.ComputeLocalToWorldTransform(time).TransformDir(Gf.Vec3d(0, 0, -1)))
    assert np.allclose(ray, eye / np.linalg.norm(eye), atol=1e-6), "light shines from the Moon to the observer"

    # the camera: the Moon's centre in the middle, and its disc as wide as it is
    seen = view.GetInverse().Transform(Gf.Vec3d(0, 0, 0))
    assert abs(seen[0]) < 1e-3 and abs(seen[1]) < 1e-3 and seen[2] < -200, seen
    field = 2 * math.atan(camera.GetHorizontalApertureAttr().Get(time) / 2 / camera.GetFocalLengthAttr().Get(time))
    assert abs(math.degrees(field) - 0.9) < 1e-3, math.degrees(field)

# the sky: its zenith is the observer's, and the Moon stands where its altitude is
dome = UsdLux.DomeLight(stage.GetPrimAtPath("/Moon/Sky"))
assert dome.GetTextureFormatAttr().Get() == "latlong"


def moon_at(time):
    """True altitude and azimuth [degrees] of the Moon at a frame's moment."""
    name = os.path.join(os.path.dirname(path), f"moon_lin_rec709.{int(time):04d}.exr")
    said = subprocess.run([program, "sky", name, "--at", "Nairobi", "--json"], check=True, capture_output=True)
    sky = json.loads(said.stdout)
    return sky["geometric_altitude_deg"], sky["azimuth_deg"]


for time in (first, last):
    axes = dome.ComputeLocalToWorldTransform(time)
    zenith = np.array(axes.TransformDir(Gf.Vec3d(0, 1, 0)))
    eye = np.array(camera.ComputeLocalToWorldTransform(time).ExtractTranslation())
    altitude = math.degrees(math.asin(-zenith @ eye / np.linalg.norm(eye)))
    east = np.array(axes.TransformDir(Gf.Vec3d(-1, 0, 0)))
    north = np.array(axes.TransformDir(Gf.Vec3d(0, 0, 1)))
    azimuth = math.degrees(math.atan2(-east @ eye, -north @ eye)) % 360
    given = moon_at(time)
    assert abs(altitude - given[0]) < 0.01 and abs(azimuth - given[1]) < 0.01, (altitude, azimuth, given)
    image = texels(dome.GetTextureFileAttr().Get(time).path)
    assert image.shape[1] == 256 and image.max() > 0
bright = texels(dome.GetTextureFileAttr().Get(first).path).sum(axis=-1)
row, column = np.unravel_index(bright.argmax(), bright.shape)
beside = (column + 0.5) / 256 * 360 - 180 - moon_at(first)[1]
assert abs((beside + 180) % 360 - 180) < 20, "moonlight is brightest beside the Moon"
print("alike")
