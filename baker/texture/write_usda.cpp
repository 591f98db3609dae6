// SPDX-License-Identifier: MIT
#include "texture/write_usda.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "algebra/error.h"
#include "almanac/lunar_orientation.h"
#include "files/whole_file.h"
#include "texture/sphere_mesh.h"
#include "texture/usda_text.h"

namespace coppermoon::texture {
namespace {

using algebra::Error;
namespace fs = std::filesystem;

constexpr std::string_view first_line = "#usda 1.0";
constexpr std::size_t most_bytes = 16 << 20;

void require_plain_name(const std::string& name) {
  const bool control =
      std::ranges::any_of(name, [](char c) { return (c >= 0 && c < ' ') || c == 127; });
  if (control || name.empty() || name == "." || name == ".." || name.find('/') != std::string::npos)
    throw Error(fmt::format(
        "texture file of the USD layer = {}, allowed a name in its folder without control "
        "characters",
        usda_quoted(name)));
}

/// inf and nan are USD's words too.
std::string as_usda(std::string_view name, const Attribute& value) {
  const auto key = usda_key(name);
  if (const auto* text = std::get_if<std::string>(&value))
    return fmt::format("string {} = {}", key, usda_quoted(*text));
  if (const auto* number = std::get_if<float>(&value))
    return fmt::format("float {} = {}", key, *number);
  if (const auto* number = std::get_if<int>(&value))
    return fmt::format("int {} = {}", key, *number);
  return fmt::format("float[] {} = [{}]", key,
                     fmt::join(std::get<std::vector<float>>(value), ", "));
}

/// USD's own way with names: `coppermoon:recipe` is `recipe` in the dictionary `coppermoon`.
std::string custom_layer_data(const Attributes& attributes) {
  std::map<std::string, std::string> dictionaries;
  for (const auto& [name, value] : attributes) {
    const auto colon = name.find(':');
    const bool apart = colon != std::string::npos && colon > 0 && colon + 1 < name.size();
    auto& entries = dictionaries[apart ? name.substr(0, colon) : ""];
    entries += fmt::format("{}{}\n", apart ? "            " : "        ",
                           as_usda(apart ? name.substr(colon + 1) : name, value));
  }
  std::string text;
  for (const auto& [name, entries] : dictionaries)
    text += name.empty() ? entries
                         : fmt::format("        dictionary {} = {{\n{}        }}\n", usda_key(name),
                                       entries);
  return text;
}

std::string layer_of(const Attributes& attributes) {
  auto all = attributes;
  all["coppermoon:radius_m"] = static_cast<float>(algebra::in_metres(almanac::lunar_radius));
  return fmt::format(R"({}
(
    defaultPrim = "Moon"
    metersPerUnit = 1
    upAxis = "Y"
    customLayerData = {{
{}    }}
)
)",
                     first_line, custom_layer_data(all));
}

template <std::size_t length>
std::string tuple(const double (&numbers)[length]) {
  std::string text;
  for (const double number : numbers)
    text += fmt::format("{}{:.7g}", text.empty() ? "(" : ", ", number + 0.);
  return text + ")";
}

std::string mesh_text() {
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

constexpr const char* looks = R"(    def Scope "Looks"
    {{
        def Material "Moonlight"
        {{
            token outputs:mtlx:surface.connect = </Moon/Looks/Moonlight/MaterialX.outputs:out>
            token outputs:surface.connect = </Moon/Looks/Moonlight/Preview.outputs:surface>

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
                asset inputs:file = {2}
                token inputs:sourceColorSpace = "raw"
                float2 inputs:st.connect = </Moon/Looks/Moonlight/Place.outputs:result>
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

            def Shader "MaterialX"
            {{
                uniform token info:id = "ND_standard_surface_surfaceshader"
                float inputs:base = 0
                float inputs:emission = 1
                color3f inputs:emission_color.connect = </Moon/Looks/Moonlight/Image.outputs:out>
                float inputs:specular = 0
                token outputs:out
            }}

            def Shader "Image"
            {{
                uniform token info:id = "ND_image_color3"
                asset inputs:file = {0} (
                    colorSpace = "{1}"
                )
                string inputs:uaddressmode = "periodic"
                string inputs:vaddressmode = "clamp"
                color3f outputs:out
            }}
        }}
    }}
)";

}  // namespace

void write_usda(const fs::path& path, const std::string& texture_file_name,
                std::string_view colour_space_name, const Attributes& layer_data,
                const std::string& preview_file_name) {
  const auto& preview = preview_file_name.empty() ? texture_file_name : preview_file_name;
  require_plain_name(texture_file_name);
  require_plain_name(preview);
  if (colour_space_name != "lin_rec709" && colour_space_name != "acescg")
    throw Error(fmt::format("colour space of a texture for USD = {}, allowed lin_rec709 or acescg",
                            colour_space_name));
  const auto look =
      fmt::format(fmt::runtime(looks), usda_asset(texture_file_name), colour_space_name,
                  usda_asset(preview));
  files::write_whole(
      path, fmt::format("{}\ndef Xform \"Moon\" (\n    kind = \"component\"\n)\n{{\n{}\n{}}}\n",
                        layer_of(layer_data), mesh_text(), look));
}

std::optional<std::string> recipe_in_usda(const fs::path& path) {
  const auto text = files::beginning_of(path, most_bytes);
  if (!text.starts_with(first_line)) throw Error(path.string() + ": is no USD text");
  return string_in_layer_data(text, "coppermoon", "recipe");
}

}  // namespace coppermoon::texture
