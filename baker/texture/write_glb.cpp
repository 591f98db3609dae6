// SPDX-License-Identifier: MIT
#include "texture/write_glb.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "algebra/error.h"
#include "almanac/lunar_orientation.h"
#include "files/whole_file.h"
#include "texture/openimageio/picture_on_globe.h"
#include "texture/sphere_mesh.h"

namespace coppermoon::texture {
namespace {

using algebra::Error;
using json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr std::uint32_t magic = 0x46546C67, version = 2, json_chunk = 0x4E4F534A,
                        binary_chunk = 0x004E4942;
constexpr const char *unlit = "KHR_materials_unlit",
                     *emissive_strength = "KHR_materials_emissive_strength";
static_assert(std::endian::native == std::endian::little, "numbers are copied as they stand");

enum Component { unsigned_short = 5123, floating = 5126 };
enum Target { array = 34962, element_array = 34963 };

/// Divides texels by the brightest value and codes them as sRGB.
///
/// Source  IEC 61966-2-1
Image coded(Image image, double brightest) {
  for (float& value : image.values) {
    const double share = std::max(0., double{value}) / brightest;
    value = static_cast<float>(std::min(
        1., share <= 0.0031308 ? 12.92 * share : 1.055 * std::pow(share, 1 / 2.4) - 0.055));
  }
  return image;
}

/// The largest value of any channel in any texel; 1 if all texels are dark.
double brightest_in(const fs::path& path, const Image& image) {
  double most = 0;
  for (const float value : image.values) {
    if (!std::isfinite(value))
      throw Error(fmt::format("{}: a luminance is {}", path.string(), value));
    most = std::max(most, double{value});
  }
  return most > 0 ? most : 1;
}

template <class Number>
void append(std::string& bytes, std::initializer_list<Number> numbers) {
  bytes.append(reinterpret_cast<const char*>(numbers.begin()), numbers.size() * sizeof(Number));
}

void pad(std::string& bytes, char with) { bytes.resize((bytes.size() + 3) / 4 * 4, with); }

/// The binary chunk of a .glb file, with a glTF buffer view for each item in the chunk.
struct Buffer {
  std::string bytes{};
  json views = json::array();

  int add(const std::string& part, std::optional<Target> target) {
    json view{{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", part.size()}};
    if (target) view["target"] = *target;
    views.push_back(view);
    bytes += part;
    pad(bytes, '\0');
    return static_cast<int>(views.size()) - 1;
  }
};

json accessor(int view, Component component, std::size_t count, const char* type) {
  return {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}};
}

/// Adds the sphere's points (which are also its normals), texture coordinates and triangles. Returns their accessors.
json add_sphere(Buffer& buffer) {
  const auto mesh = sphere_mesh();
  std::string points, places, triangles;
  std::array<float, 3> low{1, 1, 1}, high{-1, -1, -1};
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const std::array point{static_cast<float>(mesh.points[i].x),
                           static_cast<float>(mesh.points[i].y),
                           static_cast<float>(mesh.points[i].z)};
    append(points, {point[0], point[1], point[2]});
    append(places, {static_cast<float>(mesh.st[i].x), static_cast<float>(1 - mesh.st[i].y)});
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], point[k]);
      high[k] = std::max(high[k], point[k]);
    }
  }
  for (const auto& [a, b, c] : mesh.triangles)
    append(triangles, {static_cast<std::uint16_t>(a), static_cast<std::uint16_t>(b),
                       static_cast<std::uint16_t>(c)});
  const std::size_t count = mesh.points.size();
  auto at = accessor(buffer.add(points, array), floating, count, "VEC3");
  at["min"] = low;
  at["max"] = high;
  return {at, accessor(buffer.add(places, array), floating, count, "VEC2"),
          accessor(buffer.add(triangles, element_array), unsigned_short, 3 * mesh.triangles.size(),
                   "SCALAR")};
}

/// A JSON list with one item.
json only(json item) {
  auto list = json::array();
  list.push_back(std::move(item));
  return list;
}

/// glTF material that shows a picture as it is. If a luminance [cd/m²] is given, the ground is black and emits the
/// picture times that luminance.
json material(std::optional<double> luminance) {
  const json picture{{"index", 0}};
  json ground =
      luminance ? json{{"baseColorFactor", {0, 0, 0, 1}}} : json{{"baseColorTexture", picture}};
  ground.update({{"metallicFactor", 0}, {"roughnessFactor", 1}});
  const json extension = luminance ? json{{emissive_strength, {{"emissiveStrength", *luminance}}}}
                                   : json{{unlit, json::object()}};
  return {{"name", "Moonlight"},        {"pbrMetallicRoughness", ground},
          {"emissiveTexture", picture}, {"emissiveFactor", {1, 1, 1}},
          {"doubleSided", false},       {"extensions", extension}};
}

json sampler() {
  constexpr int linear = 9729, linear_of_mipmaps = 9987, repeat = 10497, clamp_to_edge = 33071;
  return {{"magFilter", linear},
          {"minFilter", linear_of_mipmaps},
          {"wrapS", repeat},
          {"wrapT", clamp_to_edge}};
}

json document(Buffer& buffer, const std::string& png, const json& material,
              const std::string& generator) {
  const json primitive{{"attributes", {{"POSITION", 0}, {"NORMAL", 0}, {"TEXCOORD_0", 1}}},
                       {"indices", 2},
                       {"material", 0}};
  const auto accessors = add_sphere(buffer);
  const int picture = buffer.add(png, {});
  return {{"asset",
           {{"version", "2.0"},
            {"generator", generator},
            {"extras", {{"coppermoon:radius_m", algebra::in_metres(almanac::lunar_radius)}}}}},
          {"extensionsUsed", only(material["extensions"].begin().key())},
          {"scene", 0},
          {"scenes", only({{"name", "Moon"}, {"nodes", only(0)}})},
          {"nodes", only({{"name", "Moon"}, {"mesh", 0}})},
          {"meshes", only({{"name", "Moon"}, {"primitives", only(primitive)}})},
          {"materials", only(material)},
          {"textures", only({{"sampler", 0}, {"source", 0}})},
          {"images", only({{"name", "Moon"}, {"bufferView", picture}, {"mimeType", "image/png"}})},
          {"samplers", only(sampler())},
          {"accessors", accessors},
          {"bufferViews", buffer.views},
          {"buffers", only({{"byteLength", buffer.bytes.size()}})}};
}

void append_chunk(std::string& file, std::uint32_t type, const std::string& bytes) {
  append(file, {static_cast<std::uint32_t>(bytes.size()), type});
  file += bytes;
}

}  // namespace

void write_glb(const fs::path& path, const Image& image, const std::string& generator,
               GlbTexels texels) {
  const bool developed = texels == GlbTexels::developed;
  std::optional<double> brightest;
  if (!developed) brightest = brightest_in(path, image);
  const auto picture = developed ? image : coded(image, *brightest);
  Buffer buffer;
  const auto document_of_all = document(buffer, picture_on_globe(path, picture, developed ? 8 : 16),
                                        material(brightest), generator);
  auto text = document_of_all.dump(-1, ' ', false, json::error_handler_t::replace);
  pad(text, ' ');
  constexpr std::size_t heads = 12 + 2 * 8;
  std::string file;
  append(file,
         {magic, version, static_cast<std::uint32_t>(heads + text.size() + buffer.bytes.size())});
  append_chunk(file, json_chunk, text);
  append_chunk(file, binary_chunk, buffer.bytes);
  files::write_whole(path, file);
}

}  // namespace coppermoon::texture
