// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "algebra/error.h"
#include "almanac/instant.h"
#include "almanac/sky.h"
#include "colour/camera_spectra.h"
#include "colour/exposure.h"
#include "colour/working_space.h"
#include "files/whole_file.h"
#include "result/as_json.h"
#include "texture/read_image.h"
#include "texture/write_image.h"
#include "uses/compare/comparison.h"
#include "uses/compare/comparison_sheet.h"
#include "uses/picture/as_shot_balance.h"
#include "uses/picture/camera_colours.h"
#include "uses/picture/lit_scene.h"
#include "uses/picture/photo_file.h"
#include "uses/picture/picture_parameters.h"
#include "uses/picture/pixels.h"
#include "verbs/command_line.h"
#include "verbs/flags/camera_options.h"
#include "verbs/flags/coding_option.h"
#include "verbs/flags/moon_options.h"
#include "verbs/recipes/recipe_file.h"
#include "verbs/reports/in_words.h"
#include "verbs/reports/one_line.h"

namespace coppermoon::verbs {
namespace of_compare {
namespace {

struct Options {
  std::string photo, render, output, recipe_in;
  texture::Coding coding = texture::Coding::as_file_says;
  std::string exposure;  ///< "exif" or "fit"; if empty, "exif" if possible, else "fit"
  std::size_t bins = 12;
  std::optional<std::string> response;
  bool json = false, csv = false;
};

/// The options of the command `still` that determine a frame's moment, observer and camera.
struct StillFlags {
  MoonOptions moon;
  uses::ViewRequest view;
  uses::CameraRequest camera;  ///< supplies the view's focal length and sensor
};

StillFlags still_flags_of(const std::string& file) {
  StillFlags flags;
  Verb still;
  add_moon_options(still, flags.moon);
  add_described(still, flags.view);
  add_described(still, flags.camera);
  take_recipe(still, file);
  if (!is_given(still, "instant"))
    throw algebra::Error(fmt::format("{}: its recipe is not that of one frame", file));
  return flags;
}

/// Sky and camera of a frame, the glow that the camera adds around bright areas, and the camera response with which the
/// frame was rendered.
struct FrameGeometry {
  almanac::SkyState sky;
  povray_scenes::SceneCamera camera;
  double glow = 0;
  std::optional<std::string> response = {};
};

/// Geometry of a frame, read from the recipe in the frame's own header or in the header of its scene's texture.
FrameGeometry geometry_of(const std::string& file) {
  if (!holds_recipe(file))
    throw algebra::Error(
        fmt::format("{}: has no recipe, allowed are .exr files made by coppermoon", file));
  const auto flags = still_flags_of(file);
  const auto sky = almanac::sky_at(instant_of(flags.moon.moment, flags.view.observer));
  const auto view = uses::seen_through(flags.camera, flags.view);
  const auto camera = uses::camera_of(flags.camera);
  return {sky, uses::view_for_frame(view, sky).view.camera, camera ? camera->glow : 0,
          flags.camera.response};
}

/// Reads the light of a render and converts it to linear Rec.709 from the colour space that its header names.
texture::Image light_of(const std::string& render) {
  const auto name = texture::read_attribute(render, "coppermoon:colour_space");
  const auto space = name ? colour::working_space(*name) : uses::picture_space;
  const auto light = space == colour::WorkingSpace::ciexyz_d65
                         ? texture::read_channels(render, {"X", "Y", "Z"})
                         : texture::read_light(render, texture::Coding::linear);
  return space == uses::picture_space ? light : uses::in_space(light, space, uses::picture_space);
}

texture::Image read_render(const Options& options, const povray_scenes::SceneCamera& camera) {
  auto render = light_of(options.render);
  if (render.width != camera.width || render.height != camera.height)
    throw algebra::Error(fmt::format("{}: {} x {} pixels, allowed {} x {}, as its recipe says",
                                     options.render, render.width, render.height, camera.width,
                                     camera.height));
  return render;
}

/// Where the render lies in the photograph.
struct Placed {
  colour::Registration registration;
};

template <class Field>
void describe(Field&& is, const Placed& placed) {
  namespace unit = algebra::unit;
  const auto& to_photo = placed.registration.render_to_photo;
  is.a("Registration", "Where the render lies in the photograph.");
  is("scale", to_photo.scale, "factor on lengths");
  is("rotation_deg", algebra::radians(to_photo.rotation_rad), unit::degrees, "rotation");
  is("x_px", to_photo.x_px, unit::pixels, "shift to the right");
  is("y_px", to_photo.y_px, unit::pixels, "shift down");
  is("mirrored", to_photo.mirrored, "whether the photograph shows the Moon mirrored");
  is("correlation", placed.registration.correlation, "correlation of markings, -1 to 1");
}

/// Exposures of the photograph: the one in its header, the one used, and the one fitted.
struct Exposed {
  std::optional<colour::Exposure> exif;
  double used = 1, fitted = 1;

  double stops_of_fit() const { return std::log2(fitted / used); }
};

template <class Field>
void describe(Field&& is, const Exposed& exposed) {
  const auto of_header = [&](double colour::Exposure::*number) {
    return algebra::if_any(exposed.exif ? std::optional((*exposed.exif).*number) : std::nullopt);
  };
  is.a("Exposure", "Exposure of the photograph.");
  is("from", algebra::Word{exposed.exif ? "exif" : "fit", {"exif", "fit"}}, "what it is known by");
  is("value_per_cd_m2", exposed.used, "the photograph's number for a luminance of 1 cd/m²");
  is("fitted_value_per_cd_m2", exposed.fitted, "the number that suits best");
  is("fitted_over_used_stops", exposed.stops_of_fit(), algebra::unit::stops,
     "how much that is more");
  is("time_s", of_header(&colour::Exposure::time_s), algebra::unit::seconds,
     "exposure time by the header");
  is("f_number", of_header(&colour::Exposure::f_number), "f-number by the header");
  is("iso", of_header(&colour::Exposure::iso), "ISO speed by the header");
}

/// White-balance gains for red and blue that a camera applied to a photograph.
struct WhiteBalance {
  glm::dvec3 fitted{1};
  std::optional<glm::dvec3> as_shot = {};
};

template <class Field>
void describe(Field&& is, const WhiteBalance& balance) {
  const auto as_shot = [&](int k) {
    return algebra::if_any(balance.as_shot ? std::optional((*balance.as_shot)[k]) : std::nullopt);
  };
  is.a("WhiteBalance",
       "Gains of a camera's red and blue channel over those that make daylight white, green's "
       "being 1.");
  is("red", balance.fitted.r, "factor of red that suits best");
  is("blue", balance.fitted.b, "factor of blue that suits best");
  is("as_shot_red", as_shot(0), "factor of red by the maker's notes");
  is("as_shot_blue", as_shot(2), "factor of blue by the maker's notes");
}

/// Result of the comparison, and how the photograph was exposed and decoded.
struct Found {
  almanac::Instant when;
  std::optional<colour::Exposure> exif;
  texture::Coding coding = texture::Coding::as_file_says;  ///< how the photograph was decoded
  uses::Comparison comparison;
  std::optional<WhiteBalance> balance = {};  ///< set if the camera itself wrote the photograph

  Exposed exposed() const { return {exif, comparison.exposure, comparison.fitted_exposure}; }
};

/// How pixel values of the photograph were converted to light.
struct Coded {
  texture::Coding coding = texture::Coding::as_file_says;
  std::optional<colour::ToneCurve> curve;
};

template <class Field>
void describe(Field&& is, const Coded& coded) {
  is.a("Light", "How the photograph's numbers stand for light.");
  const auto* const known = std::ranges::find(texture::coding_words, coded.coding,
                                              [](const auto& word) { return word.second; });
  is("coding", known->first, "coding of its numbers");
  is("tone_curve", coded.curve ? std::optional(components_of(*coded.curve)) : std::nullopt,
     "principal components of its camera's tone curve, in standard deviations over cameras");
}

/// A comparison, with the names of its files.
struct Document {
  std::string photo, render, sheet;
  Found found;
};

template <class Field>
void describe(Field&& is, const Document& all) {
  const auto& found = all.found;
  const auto& comparison = found.comparison;
  const auto& differences = comparison.differences;
  is.a("Comparison", "A photograph beside a rendered frame, and how they differ.");
  is("photo", all.photo, "the photograph");
  is("render", all.render, "the rendered frame");
  is("instant", found.when, "the moment, UTC");
  is("registration", Placed{comparison.registration}, "where the render lies in the photograph");
  is("exposure", found.exposed(), "exposure of the photograph");
  is("light",
     Coded{found.coding,
           comparison.writing ? std::optional(comparison.writing->curve) : std::nullopt},
     "how its numbers stand for light");
  is("white_balance", algebra::if_any(found.balance), "how its camera weighted its channels");
  is(
      "bins", [&] { return std::vector(differences.begin(), differences.end() - 1); },
      "steps of distance from the shadow's axis");
  is(
      "disc", [&] { return differences.back(); }, "the whole disc");
  is("file", algebra::if_any(all.sheet.empty() ? std::nullopt : std::optional(all.sheet)),
     "the sheet that was made");
}

/// Describes in words how the photograph was decoded.
std::string coding_in_words(const Found& found) {
  switch (found.coding) {
    case texture::Coding::camera:
      break;
    case texture::Coding::srgb:
      return "sRGB";
    case texture::Coding::linear:
      return "linear";
    default:
      return "as the file says";
  }
  return "its camera's, " + in_words(found.comparison.writing->curve);
}

std::string number_or_dash(const std::optional<double>& value, const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value) : "-";
}

void print_line(const uses::Difference& row) {
  const auto uv = [](const std::optional<std::array<double, 2>>& value) {
    return value ? fmt::format("{:.4f} {:.4f}", (*value)[0], (*value)[1]) : std::string("-");
  };
  fmt::print("{:>6.0f} to {:>5.0f} {:>9} {:>8} {:>8}  {:>13}  {:>13} {:>8}\n", row.from_km,
             row.to_km, row.pixels, row.clipped, number_or_dash(row.stops, "{:+.3f}"),
             uv(row.photo_uv), uv(row.render_uv), number_or_dash(row.delta_e_2000, "{:.2f}"));
}

void print_table(const Options& options, const Found& found) {
  const auto& registration = found.comparison.registration;
  const auto& is = registration.render_to_photo;
  fmt::print(
      "{}: scale {:.4f}, rotation {:.2f} degrees, shift {:.2f}, {:.2f} pixels{}, "
      "correlation {:.3f}\n",
      one_line(options.photo), is.scale, is.rotation_rad * 180 / std::numbers::pi, is.x_px, is.y_px,
      is.mirrored ? ", mirrored" : "", registration.correlation);
  fmt::print("exposure {}: {:.4g} per cd/m2{}\n", found.exif ? "by the header" : "fitted",
             found.comparison.exposure,
             found.exif ? fmt::format("; the fitted one differs by {:+.3f} stops",
                                      found.exposed().stops_of_fit())
                        : "");
  fmt::print("tone curve: {}\n", coding_in_words(found));
  if (const auto& balance = found.balance)
    fmt::print("white balance: red {:.3f}, blue {:.3f} of daylight's{}\n", balance->fitted.r,
               balance->fitted.b,
               balance->as_shot ? fmt::format("; as shot {:.3f}, {:.3f}", balance->as_shot->r,
                                              balance->as_shot->b)
                                : "");
  fmt::print("{:>15} {:>9} {:>8} {:>8}  {:>13}  {:>13} {:>8}\n", "axis [km]", "pixels", "clipped",
             "stops", "photo u' v'", "render u' v'", "dE2000");
  for (const auto& row : found.comparison.differences) print_line(row);
}

void require_sound(const Options& options) {
  algebra::require_within("bins", static_cast<double>(options.bins), 1, 1000);
  if (options.response) colour::require_spectral(*options.response);
  if (std::filesystem::path(options.render).extension() != ".exr")
    throw algebra::Error(fmt::format("{}: a render ends in .exr", options.render));
  if (options.output.empty()) return;
  if (std::filesystem::path(options.output).extension() != ".png")
    throw algebra::Error(fmt::format("{}: a picture ends in .png", options.output));
  files::require_place_for(options.output);
}

/// Exposure from the photograph's header; absent if the exposure is to be fitted. Fitting is the default if the
/// photograph has a camera's own tone curve, because such a curve is known only up to a factor.
std::optional<colour::Exposure> exif_to_use(const Options& options, texture::Coding coding) {
  if (options.exposure == "fit") return std::nullopt;
  if (coding == texture::Coding::camera && options.exposure.empty()) return std::nullopt;
  const auto exif = uses::exif_of(options.photo);
  if (!exif && options.exposure == "exif")
    throw algebra::Error(fmt::format(
        "{}: its header has not all of exposure time, f-number and ISO speed; --exposure fit "
        "does without it",
        options.photo));
  return exif;
}

void run(const Options& options) {
  require_sound(options);
  const auto coding = uses::coding_of(options.photo, options.coding);
  const auto exif = exif_to_use(options, coding);
  warn_of_another_camera(options.render, options.response);
  warn_of_developers({options.photo}, options.coding);
  const auto [sky, camera, glow, of_frame] =
      geometry_of(options.recipe_in.empty() ? options.render : options.recipe_in);
  const auto photo = uses::photo_light(options.photo, coding, options.response),
             frame = read_render(options, camera);
  std::optional<uses::CameraColours> colours;
  if (coding == texture::Coding::camera)
    colours = uses::camera_colours(options.response ? options.response : of_frame,
                                   uses::as_shot_balance(options.photo));
  Found found{sky.when, exif, coding,
              uses::compared(photo, frame, sky, camera, {exif, colours, glow, options.bins})};
  if (colours) {
    // gains are 1 if the photograph has no maker's notes, or if the response does not describe the camera's channels
    const bool told = colours->gains != glm::dvec3(1);
    found.balance = {found.comparison.writing->colours.gains,
                     told ? std::optional(colours->gains) : std::nullopt};
  }
  if (!options.output.empty())
    texture::write_png(options.output, uses::comparison_sheet(photo, found.comparison), 8);
  if (const auto& writing = found.comparison.writing)
    if (const auto doubt = doubt_of(writing->curve); !doubt.empty())
      fmt::print(stderr, "coppermoon: {}\n", doubt);
  if (options.csv)
    fmt::print("{}", result::as_csv(found.comparison.differences));
  else if (options.json)
    fmt::print(
        "{}\n",
        result::as_json(Document{options.photo, options.render, options.output, found}).dump(2));
  else
    print_table(options, found);
}

}  // namespace
}  // namespace of_compare

void add_compare(Program& program) {
  using namespace of_compare;
  auto& verb = add_verb(program, "compare",
                        "lays a photograph beside a rendered frame and measures how they differ");
  const auto options = std::make_shared<Options>();
  add_flag(
      verb, "photo,--photo", options->photo,
      "photograph: any image, or a camera's raw file; whole numbers are read by the camera's tone "
      "curve where the header names one and no program that developed it, else as sRGB, floats and "
      "raw files as linear")
      .reads_file()
      .of(request::Affects::share)
      .required();
  add_flag(verb, "render,--render", options->render,
           "rendered frame, .exr [cd/m²], as still --frame writes it")
      .reads_file()
      .required();
  add_flag(verb, "-o,--output", options->output,
           "sheet, .png: photograph, render and difference side by side")
      .writes_file();
  add_flag(
      verb, "--exposure", options->exposure,
      "exposure of the photograph: exif (as its header says) or fit (what suits best, as with a "
      "camera's own tone curve); default: exif where there is a header")
      .one_of({"exif", "fit"});
  add_flag(verb, "--bins", options->bins,
           "number of steps of distance from the shadow's axis, 1 to 1000")
      .within(1, 1000);
  add_coding_option(
      verb, options->coding,
      "coding of the photograph's numbers: camera (its own tone curve, which the frame "
      "tells; so where the header names a camera), srgb or linear (a TIFF never says "
      "which)");
  add_flag(verb, "--recipe-in", options->recipe_in,
           ".exr whose recipe tells what the render shows, as a scene's texture does; default: "
           "the render itself")
      .reads_file();
  add_described(verb, options->response, uses::describe_response);
  add_run_switch(verb, "--csv", options->csv, "prints the steps of distance, and the disc, as CSV");
  add_json_switch(verb, options->json, {result::fields_of<Document>}).not_beside({{"csv"}});
  on_run(verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
