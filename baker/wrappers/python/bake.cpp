// SPDX-License-Identifier: MIT
#include <memory>

#include "uses/picture/baked_moon.h"
#include "wrappers/python/arguments.h"
#include "wrappers/python/computing.h"
#include "wrappers/python/nouns.h"
#include "wrappers/python/requests.h"

namespace coppermoon::python {
namespace {

/// A part of a texture, its texels in memory.
struct Texels {
  std::string name;
  texture::Image image;
};

/// A texture as arrays.
struct Texture {
  std::vector<std::string> channels;  ///< of the first part
  std::string space;
  py::dict parts, header;
};

py::array_t<float> array_of_image(texture::Image image) {
  const std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(image.height),
                                       static_cast<py::ssize_t>(image.width),
                                       static_cast<py::ssize_t>(image.channels.size())};
  return array_of<float>(std::move(image.values), shape);
}

/// Rows of a part, some at a time, so that one may stop between them.
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

Baked baked_of(const uses::MoonRequest& request, const almanac::Instant& when,
               const uses::ViewRequest& view, const uses::TextureContent& content,
               const algebra::Progress& progress) {
  const auto sky = almanac::sky_at(when);
  const auto seen = uses::view_of(view, sky);
  auto moon = uses::lit_moon(request, sky, part_of(progress, 0, 0.5));
  moon.observer = seen.observer;
  moon.sightline = seen.sightline;
  auto made = uses::baked(moon, content, {.progress = part_of(progress, 0.5, 1)});
  Baked baked{{}, std::move(made.attributes)};
  for (const auto& part : made.parts) baked.parts.push_back({part.name, image_of(part)});
  return baked;
}

Texture texture_of(const Moment& when, std::size_t width, const std::string& space,
                   const std::optional<uses::Air>& air,
                   const std::optional<uses::LightRequest>& light, const std::string& albedo_map,
                   uses::AlbedoEncoding albedo_encoding, int albedo_map_centre,
                   double albedo_exponent,
                   surface::Photometry photometry, bool unshadowed, const std::optional<Place>& at,
                   bool reddening, std::optional<double> spectral_nm, bool passes,
                   const Told& told) {
  auto request = moon_request(light_request(air, light),
                              {albedo_map, albedo_encoding, albedo_map_centre, albedo_exponent,
                               photometry, unshadowed});
  request.texture_width = width;
  const uses::TextureContent content{
      .space = colour::working_space(space), .spectral_nm = spectral_nm, .passes = passes};
  uses::require_sound(content);
  uses::texture_width_of(request);
  uses::require_map(request);
  auto baked = computed(told, [&](const algebra::Progress& progress) {
    return baked_of(request, when.instant, view_request(at, reddening), content, progress);
  });
  Texture texture{
      baked.parts.front().image.channels, std::string(colour::name(*content.space)), {}, {}};
  for (auto& [name, image] : baked.parts)
    texture.parts[py::str(name)] = array_of_image(std::move(image));
  for (const auto& [name, value] : baked.header) texture.header[py::str(name)] = value;
  return texture;
}

py::object first_of(const Texture& texture) {
  return texture.parts.begin()->second.cast<py::object>();
}

}  // namespace

void add_bake(py::module_& package) {
  using namespace py::literals;
  py::class_<Texture>(
      package, "Texture",
      "A texture of the Moon, plate carrée: row 0 north, longitude 0 in the middle, "
      "east to the right. numpy.asarray gives its pixels.")
      .def_property_readonly(
          "pixels", first_of,
          "scene-linear values [cd/m²], float32, shape (height, width, channels)")
      .def_readonly("channels", &Texture::channels,
                    "names of the channels: the colours; spectral ones are in W/(m² sr nm)")
      .def_readonly("space", &Texture::space,
                    "colour space: 'lin_rec709', 'acescg' or 'lin_ciexyzd65_scene'")
      .def_readonly("header", &Texture::header, "what the header of its file would say, by name")
      .def_readonly("parts", &Texture::parts,
                    "all arrays by name: with passes also what the light is made of")
      .def("__array__",
           [](const Texture& texture, const py::args& more) {
             return first_of(texture).attr("__array__")(*more);
           })
      .def("__repr__", [](const Texture& texture) {
        const auto shape = first_of(texture).attr("shape");
        return fmt::format("<Texture {} of shape {}>", texture.space,
                           py::str(shape).cast<std::string>());
      });
  package.def(
      "bake", texture_of, "when"_a, py::kw_only(), "width"_a = 4096, "space"_a = "lin_rec709",
      "air"_a = py::none(), "light"_a = py::none(), "albedo_map"_a = "built-in",
      "albedo_encoding"_a = uses::AlbedoEncoding::image, "albedo_map_centre"_a = 0, "albedo_exponent"_a = 1.,
      "photometry"_a = surface::Photometry::lommel_seeliger_rolo, "unshadowed"_a = false,
      "at"_a = py::none(), "reddening"_a = true, "spectral_nm"_a = py::none(), "passes"_a = false,
      "progress"_a = py::none(),
      R"(bake(when, *, width=4096, space='lin_rec709', air=None, light=None, albedo_map='built-in', albedo_encoding='image', albedo_map_centre=0, albedo_exponent=1.0, photometry='lommel-seeliger-rolo', unshadowed=False, at=None, reddening=True, spectral_nm=None, passes=False, progress=None)

The lit texture of the Moon at a moment of an eclipse: luminances of a scene-linear colour space [cd/m²].

width: of the texture [texels], even, 4 to 32768
space: 'lin_rec709', 'acescg' or 'lin_ciexyzd65_scene'
albedo_map: an image file of 2:1, or 'built-in'
albedo_encoding: how the numbers of a map's file stand for albedo, by the words of --albedo-encoding
albedo_map_centre: longitude in the map's middle [degrees], 0, or 180 of a map from 0 to 360
albedo_exponent: power of what is decoded, 0.1 to 10
photometry: of the ground, 'lommel-seeliger-rolo' or 'yapo-cutler'
unshadowed: lit as if the Earth were away
at: who sees it, through the air of that place; a city, or (latitude, longitude) in degrees
spectral_nm: width of bands of spectral radiance [nm], which follow the colours; it goes into 400 evenly
passes: also the parts that the light is made of
progress: called with the fraction that is done, some times a second

>>> moon = coppermoon.bake('2018-07-27T20:21:45Z', width=64, space='acescg',
...                        air=coppermoon.Air(atmosphere='clear'), light=coppermoon.Light(bands=4, rays=60))
>>> moon.pixels.shape, moon.pixels.dtype, moon.header['capDate']
((32, 64, 3), dtype('float32'), '2018:07:27 20:21:45')
)");
}

}  // namespace coppermoon::python
