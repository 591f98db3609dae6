# SPDX-License-Identifier: MIT
"""check_files.py TOOL FOLDER: whether a tool finds the colour spaces of the files that make_files.sh made."""
import os
import sys

from expected import FILES


def of_openimageio(name):
    import OpenImageIO as oiio
    spec = oiio.ImageInput.open(name).spec()
    found = spec.get_string_attribute("oiio:ColorSpace")
    return {"sRGB": "srgb_rec709_scene"}.get(found, found)  # by OpenImageIO's own name


def of_blender(name):
    import bpy
    names = {"ACEScg": "lin_ap1_scene", "Linear Rec.709": "lin_rec709_scene",
             "Linear CIE-XYZ D65": "lin_ciexyzd65_scene", "sRGB": "srgb_rec709_scene"}
    if not name.endswith(".glb"):
        return names[bpy.data.images.load(os.path.abspath(name)).colorspace_settings.name]
    before = set(bpy.data.images)
    bpy.ops.import_scene.gltf(filepath=os.path.abspath(name))
    (picture,) = set(bpy.data.images) - before
    return names[picture.colorspace_settings.name]


def of_usd(name):
    from pxr import Gf, Usd
    stage = Usd.Stage.Open(name)
    cache = Usd.ColorSpaceHashCache()

    def space_of(shader):
        attribute = stage.GetPrimAtPath("/Moon/Looks/Moonlight/" + shader).GetAttribute("inputs:file")
        return str(Usd.ColorSpaceAPI.ComputeColorSpaceName(attribute, cache))

    assert space_of("Texture") == "lin_rec709_scene", space_of("Texture")
    assert Gf.ColorSpace.IsValid(space_of("Image"))
    return space_of("Image")


def of_materialx(name):
    """Transform that MaterialX puts behind a texture of the space that the layer names."""
    import MaterialX as mx
    import MaterialX.PyMaterialXGenGlsl as glsl
    import MaterialX.PyMaterialXGenShader as shaders
    transforms = {True: "lin_ap1_scene", False: "lin_rec709_scene"}
    library = mx.createDocument()
    mx.loadLibraries(mx.getDefaultDataLibraryFolders(), mx.getDefaultDataSearchPath(), library)
    document = mx.createDocument()
    document.importLibrary(library)
    document.setColorSpace("lin_rec709")
    picture = document.addNode("image", "picture", "color3").addInput("file", "filename")
    picture.setValueString("moon.exr")
    picture.setColorSpace(of_usd(name))
    surface = document.addNode("surface_unlit", "surface", "surfaceshader")
    surface.addInput("emission_color", "color3").setNodeName("picture")
    material = document.addMaterialNode("moon", surface)
    generator = glsl.GlslShaderGenerator.create()
    context = shaders.GenContext(generator)
    context.registerSourceCodeSearchPath(mx.getDefaultDataSearchPath())
    colours = shaders.DefaultColorManagementSystem.create(generator.getTarget())
    colours.loadLibrary(library)
    generator.setColorManagementSystem(colours)
    source = generator.generate("moon", material, context).getSourceCode("pixel")
    return transforms["acescg_to_lin_rec709" in source]


TOOLS = {"openimageio": (of_openimageio, (".exr", ".tx", ".png")),
         "blender": (of_blender, (".exr", ".tx", ".png", ".glb")),
         "usd": (of_usd, (".usda",)),
         "materialx": (of_materialx, (".usda",))}

if __name__ == "__main__":
    find, endings = TOOLS[sys.argv[1]]
    os.chdir(sys.argv[2])
    mine = {name: space for name, space in FILES.items() if name.endswith(endings)}
    wrong = [f"{name}: {found}, expected {space}" for name, space in mine.items()
             if (found := find(name)) != space]
    if sys.argv[1] == "openimageio":
        import OpenImageIO as oiio
        file, parts = oiio.ImageInput.open("acescg/a.exr"), {}
        while file.seek_subimage(len(parts), 0):
            spec = file.spec()
            parts[spec.get_string_attribute("oiio:subimagename")] = spec.get_string_attribute("oiio:ColorSpace")
        for part in ("lit", "direct", "refracted", "irradiance", "reflectance", "albedo"):
            expected = "data" if part in ("reflectance", "albedo") else "lin_ap1_scene"
            if parts.get(part) != expected:
                wrong.append(f"part {part}: {parts.get(part)}, expected {expected}")
    print("\n".join(wrong) or f"{len(mine)} of {len(mine)} found")
    sys.exit(bool(wrong))
