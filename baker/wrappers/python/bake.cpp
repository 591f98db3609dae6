// SPDX-License-Identifier: MIT
#include <memory>

#include "uses/picture/baked_moon.h"
#include "wrappers/python/computing.h"
#include "wrappers/python/fields.h"
#include "wrappers/python/nouns.h"
#include "wrappers/python/requests.h"
#include "wrappers/python/results.h"

namespace coppermoon::python {
namespace {

/// One part of a texture, such as a pass, with its texels in memory.
struct Texels {
  std::string name;
  texture::Image image;
};

/// A texture as its Python object stores it: a dictionary of values by name.
struct Texture {
  py::dict values;
};

result::Fields fields_of_texture() {
  return {
      "Texture",
      "A texture of the Moon, plate carrée: row 0 north, longitude 0 in the middle, east to the "
      "right. numpy.asarray gives its pixels.",
      {{.key = "pixels",
        .unit = "cd/m²",
        .meaning = "scene-linear values, float32, shape (height, width, channels)"},
       {.key = "channels",
        .meaning = "names of the channels: the colours; spectral ones are in W/(m² sr nm)"},
       {.key = "space", .meaning = "colour space: 'lin_rec709', 'acescg' or 'lin_ciexyzd65_scene'"},
       {.key = "header",
        .meaning = "header of its file, by name; 'coppermoon:recipe' bakes the texture again"},
       {.key = "parts",
        .meaning = "all arrays by name: with passes also what the light is made of"}}};
}

py::array_t<float> array_of_image(texture::Image image) {
  const std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(image.height),
                                       static_cast<py::ssize_t>(image.width),
                                       static_cast<py::ssize_t>(image.channels.size())};
  return array_of<float>(std::move(image.values), shape);
}

/// Reads a part of a texture a few rows at a time, so that the work can be interrupted in between.
texture::Image image_of(const texture::Part& part) {
  const auto& layout = part.layout;
  texture::Image image(layout.width, layout.height, layout.channels);
  constexpr std::size_t at_a_time = 64;
  const std::size_t row = layout.width * layout.channels.size();
  for (std::size_t r = 0; r < layout.height; r += at_a_time) {
    const auto rows = std::min(at_a_time, layout.height - r);
    part.rows(r, std::span(image.values).subspan(r * row, rows * row));
  }
  return image;
}

struct Baked {
  std::vector<Texels> parts;
  texture::Attributes header;
};

Baked baked_of(const TextureKeywords& asked, const almanac::Instant& when,
               const algebra::Progress& progress) {
  const auto sky = almanac::sky_at(when);
  const auto seen = uses::view_of(asked.view, sky);
  auto moon = uses::lit_moon(asked.moon, sky, part_of(progress, 0, 0.5));
  moon.observer = seen.observer;
  moon.sightline = seen.sightline;
  auto made = uses::baked(moon, asked.content, {.progress = part_of(progress, 0.5, 1)});
  Baked baked{{}, std::move(made.attributes)};
  for (const auto& part : made.parts) baked.parts.push_back({part.name, image_of(part)});
  return baked;
}

Texture texture_of(const Moment& when, const std::optional<uses::Air>& air,
                   const std::optional<uses::LightRequest>& light, const std::optional<Place>& at,
                   const Callback& callback, const py::kwargs& more) {
  TextureKeywords asked;
  take_objects(asked, air, light, at);
  take(bake_keywords(asked), "bake", more);
  uses::require_sound(asked.content);
  uses::texture_width_of(asked.moon);
  auto baked = computed(callback, [&](const algebra::Progress& progress) {
    return baked_of(asked, when.seen_from(asked.view.observer), progress);
  });
  Texture texture;
  const auto channels = baked.parts.front().image.channels;
  py::dict parts;
  for (auto& [name, image] : baked.parts) parts[py::str(name)] = array_of_image(std::move(image));
  texture.values["pixels"] = parts[py::str(baked.parts.front().name)];
  texture.values["channels"] = channels;
  texture.values["space"] = std::string(colour::name(*asked.content.space));
  texture.values["header"] = header_of(baked.header);
  texture.values["parts"] = parts;
  return texture;
}

}  // namespace

void add_bake(py::module_& package) {
  using namespace py::literals;
  auto texture = add_kept<Texture>(package, fields_of_texture());
  add_array_protocol(texture, "pixels");
  TextureKeywords keywords;
  const auto parameters = bake_keywords(keywords);
  const auto doc = fmt::format(
      R"(bake(when, *, air=None, light=None, at=None, {}, progress=None)

The lit texture of the Moon at a moment of an eclipse: luminances of a scene-linear colour space [cd/m²]. The texture's
header['coppermoon:recipe'], saved to a file, is the recipe that bakes it again: coppermoon bake --recipe FILE -o OTHER.exr

at: place that sees it, through its air: a city, or (latitude, longitude) in degrees
{}progress: called with the fraction that is done, some times a second

>>> moon = coppermoon.bake('2018-07-27T20:21:45Z', width=64, space='acescg',
...                        air=coppermoon.Air(atmosphere='clear'), light=coppermoon.Light(bands=4, rays=60))
>>> moon.pixels.shape, moon.pixels.dtype, moon.header['capDate']
((32, 64, 3), dtype('float32'), '2018:07:27 20:21:45')
)",
      signature_of(parameters), lines_of(parameters));
  package.def("bake", texture_of, "when"_a, py::kw_only(), "air"_a = py::none(),
              "light"_a = py::none(), "at"_a = py::none(), "progress"_a = py::none(), doc.c_str());
}

}  // namespace coppermoon::python
