# SPDX-License-Identifier: MIT
"""python shade_in_cycles.py FOLDER SECONDS: Cycles of the module bpy renders a sphere that is as bright as the light which
FOLDER/eclipse.osl finds, FOLDER/light.exr, and once more as bright as its places on Moon-fixed axes, FOLDER/places.exr."""

import sys

import bpy

# Modules of Blender's own Python, which the module bpy brings but does not find: oslquery is among them.
version = f"python{sys.version_info.major}.{sys.version_info.minor}"
sys.path.append(f"{bpy.utils.resource_path('LOCAL')}/python/lib/{version}/site-packages")
import OpenImageIO  # noqa: E402,F401: its types are oslquery's

folder, seconds = sys.argv[1], float(sys.argv[2])
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.data.scenes[0]
scene.render.engine = "CYCLES"
scene.cycles.shading_system = True  # OSL
scene.cycles.samples = 1
scene.cycles.use_denoising = False
scene.render.resolution_x = scene.render.resolution_y = 64
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.image_settings.color_depth = "32"

bpy.ops.mesh.primitive_uv_sphere_add(segments=256, ring_count=128, radius=1)
sphere = bpy.context.object
camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
camera.data.type = "ORTHO"
camera.data.ortho_scale = 2.1
camera.location = (5, 0, 0)
camera.rotation_euler = (1.5707963, 0, 1.5707963)
scene.collection.objects.link(camera)
scene.camera = camera

material = bpy.data.materials.new("Moon")
if material.node_tree is None:  # before Blender 5
    material.use_nodes = True
nodes, links = material.node_tree.nodes, material.node_tree.links
nodes.clear()
emission, output = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeOutputMaterial")
links.new(emission.outputs[0], output.inputs["Surface"])
sphere.data.materials.append(material)


def render(colour, name):
    links.new(colour, emission.inputs["Color"])
    scene.render.filepath = f"{folder}/{name}"
    bpy.ops.render.render(write_still=True)


script = nodes.new("ShaderNodeScript")
script.mode = "EXTERNAL"
script.filepath = f"{folder}/eclipse.osl"
script.inputs["strip"].default_value = f"{folder}/eclipse.exr"
script.inputs["seconds"].default_value = seconds
render(script.outputs["light"], "light.exr")

places = nodes.new("ShaderNodeTexCoord")
half = nodes.new("ShaderNodeVectorMath")  # light is never negative
half.operation = "MULTIPLY_ADD"
half.inputs[1].default_value = half.inputs[2].default_value = (0.5, 0.5, 0.5)
links.new(places.outputs["Object"], half.inputs[0])
render(half.outputs[0], "places.exr")
