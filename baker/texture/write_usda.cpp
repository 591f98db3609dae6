// SPDX-License-Identifier: MIT
#include "texture/write_usda.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "algebra/error.h"
#include "almanac/lunar_orientation.h"
#include "files/whole_file.h"
#include "texture/sphere_mesh.h"
#include "texture/usd_text.h"

namespace coppermoon::texture {
namespace {

using algebra::Error;
namespace fs = std::filesystem;

}  // namespace

void require_usd_name(std::string_view file_name) {
  const bool barred = std::ranges::any_of(
      file_name, [](char c) { return (c >= 0 && c < ' ') || c == 127 || c == '/' || c == '\\'; });
  if (barred || file_name.empty() || file_name == "." || file_name == ".." ||
      file_name.find(":SDF_FORMAT_ARGS:") != std::string_view::npos)
    throw Error(fmt::format(
        "file of a USD layer = {:?}, allowed a name in its folder without control characters, \\ "
        "and :SDF_FORMAT_ARGS:, which USD does not find",
        file_name));
}

std::string usd_asset(std::string_view file_name) {
  require_usd_name(file_name);
  if (file_name.find('@') == std::string_view::npos) return fmt::format("@./{}@", file_name);
  std::string name(file_name);
  for (auto at = name.find("@@@"); at != std::string::npos; at = name.find("@@@", at + 4))
    name.insert(at, 1, '\\');
  return fmt::format("@@@./{}@@@", name);
}

std::string usd_layer() {
  return fmt::format(R"(#usda 1.0
(
    defaultPrim = "Moon"
    metersPerUnit = 1
    upAxis = "Y"
    customLayerData = {{
        dictionary coppermoon = {{
            float radius_m = {}
        }}
    }}
)
)",
                     algebra::in_metres(almanac::lunar_radius));
}

namespace {

template <std::size_t length>
std::string tuple(const double (&numbers)[length]) {
  std::string text;
  for (const double number : numbers)
    text += fmt::format("{}{:.7g}", text.empty() ? "(" : ", ", number + 0.);
  return text + ")";
}

}  // namespace

std::string usd_mesh() {
  const auto mesh = sphere_mesh();
  std::string points, places, triangles, counts;
  const auto add = [](std::string& list, std::string_view item) {
    if (!list.empty()) list += ", ";
    list += item;
  };
  for (const auto& p : mesh.points) add(points, tuple({p.x, p.y, p.z}));
  for (const auto& st : mesh.st) add(places, tuple({st.x, st.y}));
  for (const auto& triangle : mesh.triangles) {
    add(counts, "3");
    add(triangles, fmt::format("{}", fmt::join(triangle, ", ")));
  }
  return fmt::format(R"(    def Mesh "Surface" (
        prepend apiSchemas = ["MaterialBindingAPI"]
    )
    {{
        uniform bool doubleSided = 0
        float3[] extent = [(-1, -1, -1), (1, 1, 1)]
        int[] faceVertexCounts = [{}]
        int[] faceVertexIndices = [{}]
        rel material:binding = </Moon/Looks/Moonlight>
        normal3f[] normals = [{}] (
            interpolation = "vertex"
        )
        uniform token orientation = "rightHanded"
        point3f[] points = [{}]
        texCoord2f[] primvars:st = [{}] (
            interpolation = "vertex"
        )
        uniform token subdivisionScheme = "none"
    }}
)",
                     counts, triangles, points, points, places);
}

namespace {

constexpr const char* preview_prims = R"(
            def Shader "Preview"
            {{
                uniform token info:id = "UsdPreviewSurface"
                color3f inputs:diffuseColor = (0, 0, 0)
                color3f inputs:emissiveColor.connect = </Moon/Looks/Moonlight/Texture.outputs:rgb>
                float inputs:roughness = 1
                color3f inputs:specularColor = (0, 0, 0)
                int inputs:useSpecularWorkflow = 1
                token outputs:surface
            }}

            def Shader "Texture"
            {{
                uniform token info:id = "UsdUVTexture"
{}                float2 inputs:st.connect = </Moon/Looks/Moonlight/Place.outputs:result>
                token inputs:wrapS = "repeat"
                token inputs:wrapT = "clamp"
                float3 outputs:rgb
            }}

            def Shader "Place"
            {{
                uniform token info:id = "UsdPrimvarReader_float2"
                string inputs:varname = "st"
                float2 outputs:result
            }}
)";

constexpr const char* materialx_prims = R"(
            def Shader "MaterialX"
            {{
                uniform token info:id = "ND_standard_surface_surfaceshader"
                float inputs:base = 0
                float inputs:emission = 1
                color3f inputs:emission_color.connect = <{}>
                float inputs:specular = 0
                token outputs:out
            }}

{})";

}  // namespace

std::string usd_looks(const std::string& file, const std::string& emission,
                      const std::string& nodes) {
  const bool both = !emission.empty();
  return fmt::format(
      "    def Scope \"Looks\"\n    {{\n        def Material \"Moonlight\"\n        {{\n{}"
      "            token outputs:surface.connect = "
      "</Moon/Looks/Moonlight/Preview.outputs:surface>\n{}{}"
      "        }}\n    }}\n",
      both ? "            token outputs:mtlx:surface.connect = "
             "</Moon/Looks/Moonlight/MaterialX.outputs:out>\n"
           : "",
      fmt::format(fmt::runtime(preview_prims), file),
      both ? fmt::format(fmt::runtime(materialx_prims), emission, nodes) : "");
}

std::string usd_image(const std::string& name, const std::string& file,
                      std::string_view colour_space) {
  return fmt::format(R"(            def Shader "{}"
            {{
                uniform token info:id = "ND_image_color3"
                asset inputs:file = {} (
                    colorSpace = "{}"
                )
                string inputs:uaddressmode = "periodic"
                string inputs:vaddressmode = "clamp"
                color3f outputs:out
            }}
)",
                     name, file, colour_space);
}

void write_usda(const fs::path& path, const std::string& texture_file_name,
                std::string_view colour_space, const std::string& preview_file_name,
                const std::string& observer) {
  require_usd_name(path.filename().string());
  const auto& preview = preview_file_name.empty() ? texture_file_name : preview_file_name;
  if (colour_space != "lin_rec709_scene" && colour_space != "lin_ap1_scene")
    throw Error(
        fmt::format("colour space of a texture for USD = {}, allowed lin_rec709_scene or "
                    "lin_ap1_scene",
                    colour_space));
  const auto look = usd_looks(
      fmt::format("                asset inputs:file = {} (\n"
                  "                    colorSpace = \"lin_rec709_scene\"\n                )\n"
                  "                token inputs:sourceColorSpace = \"raw\"\n",
                  usd_asset(preview)),
      "/Moon/Looks/Moonlight/Image.outputs:out",
      usd_image("Image", usd_asset(texture_file_name), colour_space));
  files::write_whole(
      path, fmt::format("{}\ndef Xform \"Moon\" (\n    kind = \"component\"\n    prepend "
                        "apiSchemas = [\"ColorSpaceAPI\"]\n)\n{{\n"
                        "    uniform token colorSpace:name = \"{}\"\n\n{}\n{}{}{}}}\n",
                        usd_layer(), colour_space, usd_mesh(), look, observer.empty() ? "" : "\n",
                        observer));
}

}  // namespace coppermoon::texture
