// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

#include "algebra/error.h"
#include "almanac/instant.h"
#include "colour/exposure.h"
#include "colour/limb.h"
#include "colour/working_space.h"
#include "texture/read_image.h"
#include "texture/write_image.h"
#include "verbs/comparison.h"
#include "verbs/comparison_sheet.h"
#include "verbs/moon_options.h"
#include "verbs/one_line.h"
#include "verbs/photo_file.h"
#include "verbs/recipe.h"
#include "verbs/verbs.h"

namespace coppermoon::verbs {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string photo, render, output, recipe_in, coding = "as-file-says";
  std::string exposure;  ///< empty: exif where there is one
  std::size_t bins = 12;
  bool json = false;
};

void require_rec709(const std::string& render) {
  const auto space = texture::read_attribute(render, "coppermoon:colour_space");
  if (space && *space != colour::name(colour::WorkingSpace::linear_rec709))
    throw algebra::Error(fmt::format("{}: colour space = {}, allowed {}", render, *space,
                                     colour::name(colour::WorkingSpace::linear_rec709)));
}

texture::Image read_render(const Options& options, const FramePlaces& places) {
  require_rec709(options.render);
  auto render = texture::read_light(options.render, texture::Coding::linear);
  if (render.width != places.camera.width || render.height != places.camera.height)
    throw algebra::Error(fmt::format("{}: {} x {} pixels, allowed {} x {}, as its recipe says",
                                     options.render, render.width, render.height,
                                     places.camera.width, places.camera.height));
  return render;
}

/// All that was found.
struct Comparison {
  almanac::Instant when;
  colour::Registration registration;
  std::optional<colour::Exposure> exif;
  double exposure, fitted;  ///< photograph's value per cd/m²
  std::vector<Difference> differences;
};

Json as_json(const colour::Registration& registration) {
  const auto& is = registration.render_to_photo;
  return {{"scale", is.scale},       {"rotation_deg", is.rotation_rad * 180 / std::numbers::pi},
          {"x_px", is.x_px},         {"y_px", is.y_px},
          {"mirrored", is.mirrored}, {"correlation", registration.correlation}};
}

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json as_json(const Difference& difference) {
  const auto part = [](const std::optional<std::array<double, 2>>& uv, std::size_t k) {
    return uv ? Json((*uv)[k]) : Json();
  };
  return {{"axis_distance_from_km", difference.from_km},
          {"axis_distance_to_km", difference.to_km},
          {"pixels", difference.pixels},
          {"clipped_pixels", difference.clipped},
          {"difference_stops", or_null(difference.stops)},
          {"photo_u", part(difference.photo_uv, 0)},
          {"photo_v", part(difference.photo_uv, 1)},
          {"render_u", part(difference.render_uv, 0)},
          {"render_v", part(difference.render_uv, 1)},
          {"delta_e_2000", or_null(difference.delta_e_2000)}};
}

Json exposure_json(const Comparison& found) {
  Json all{{"from", found.exif ? "exif" : "fit"},
           {"value_per_cd_m2", found.exposure},
           {"fitted_value_per_cd_m2", found.fitted},
           {"fitted_over_used_stops", std::log2(found.fitted / found.exposure)}};
  if (found.exif)
    all.update(Json{{"time_s", found.exif->time_s},
                    {"f_number", found.exif->f_number},
                    {"iso", found.exif->iso}});
  return all;
}

void print_json(const Options& options, const Comparison& found) {
  Json all{{"photo", options.photo},
           {"render", options.render},
           {"instant", almanac::utc_text(found.when)},
           {"registration", as_json(found.registration)},
           {"exposure", exposure_json(found)},
           {"bins", Json::array()},
           {"disc", as_json(found.differences.back())}};
  for (std::size_t i = 0; i + 1 < found.differences.size(); ++i)
    all["bins"].push_back(as_json(found.differences[i]));
  if (!options.output.empty()) all["file"] = options.output;
  fmt::print("{}\n", all.dump(2));
}

std::string number_or_dash(const std::optional<double>& value, const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value) : "-";
}

void print_line(const Difference& row) {
  const auto uv = [](const std::optional<std::array<double, 2>>& value) {
    return value ? fmt::format("{:.4f} {:.4f}", (*value)[0], (*value)[1]) : std::string("-");
  };
  fmt::print("{:>6.0f} to {:>5.0f} {:>9} {:>8} {:>8}  {:>13}  {:>13} {:>8}\n", row.from_km,
             row.to_km, row.pixels, row.clipped, number_or_dash(row.stops, "{:+.3f}"),
             uv(row.photo_uv), uv(row.render_uv), number_or_dash(row.delta_e_2000, "{:.2f}"));
}

void print_table(const Options& options, const Comparison& found) {
  const auto& is = found.registration.render_to_photo;
  fmt::print(
      "{}: scale {:.4f}, rotation {:.2f} degrees, shift {:.2f}, {:.2f} pixels{}, "
      "correlation {:.3f}\n",
      one_line(options.photo), is.scale, is.rotation_rad * 180 / std::numbers::pi, is.x_px, is.y_px,
      is.mirrored ? ", mirrored" : "", found.registration.correlation);
  fmt::print("exposure by {}: {:.4g} per cd/m2; a fit says {:+.3f} stops\n",
             found.exif ? "exif" : "fit", found.exposure, std::log2(found.fitted / found.exposure));
  fmt::print("{:>15} {:>9} {:>8} {:>8}  {:>13}  {:>13} {:>8}\n", "axis [km]", "pixels", "clipped",
             "stops", "photo u' v'", "render u' v'", "dE2000");
  for (const auto& row : found.differences) print_line(row);
}

void require_sound(const Options& options) {
  algebra::require_within("bins", static_cast<double>(options.bins), 1, 1000);
  if (std::filesystem::path(options.render).extension() != ".exr")
    throw algebra::Error(fmt::format("{}: a render ends in .exr", options.render));
  if (options.output.empty()) return;
  if (std::filesystem::path(options.output).extension() != ".png")
    throw algebra::Error(fmt::format("{}: a picture ends in .png", options.output));
  require_place_for(options.output);
}

/// Nothing where the exposure is to be fitted.
std::optional<colour::Exposure> exif_to_use(const Options& options) {
  if (options.exposure == "fit") return std::nullopt;
  const auto exif = exif_of(options.photo);
  if (!exif && options.exposure == "exif")
    throw algebra::Error(fmt::format(
        "{}: its header has not all of exposure time, f-number and ISO speed; allowed is "
        "--exposure fit",
        options.photo));
  return exif;
}

void write_sheet(const Options& options, const texture::Image& photo, texture::Image render,
                 const Comparison& found) {
  for (float& value : render.values) value *= static_cast<float>(found.exposure);
  const auto disc = colour::limb_of(luminance_of(photo)).value();
  texture::write_png(options.output, comparison_sheet(photo, render, disc), 8);
}

void run(const Options& options) {
  require_sound(options);
  const auto exif = exif_to_use(options);
  const auto places = frame_places(options.recipe_in.empty() ? options.render : options.recipe_in);
  const auto photo = read_photo(options.photo, options.coding),
             frame = read_render(options, places);
  const auto registration = colour::registered(luminance_of(photo), luminance_of(frame));
  const auto render = resampled(frame, registration.render_to_photo, photo.height, photo.width);
  const auto pixels = shared_pixels(photo, render, places, registration.render_to_photo);
  const double fitted = fitted_exposure(pixels);
  const double exposure = exif ? colour::exposure_scale(*exif) : fitted;
  const Comparison found{
      places.sky.when, registration, exif,
      exposure,        fitted,       differences(pixels, exposure, options.bins)};
  if (!options.output.empty()) write_sheet(options, photo, render, found);
  if (options.json)
    print_json(options, found);
  else
    print_table(options, found);
}

}  // namespace

void add_compare(CLI::App& program) {
  auto* verb = add_verb(program, "compare",
                        "A photograph beside a rendered frame: registered, exposed, measured");
  const auto options = std::make_shared<Options>();
  add_flag(*verb, "photo,--photo", options->photo, "any image; integers are sRGB, floats linear")
      .reads_file()
      .required();
  add_flag(*verb, "render,--render", options->render,
           "scene-linear [cd/m²], .exr: what still --frame wrote")
      .reads_file()
      .required();
  add_flag(*verb, "-o,--output", options->output,
           "photograph, render and difference side by side, .png")
      .writes_file();
  add_flag(*verb, "--exposure", options->exposure,
           "exif: as the photograph's header says, ISO 12232; fit: what suits it best; "
           "without: exif where it is there")
      .one_of({"exif", "fit"});
  add_flag(*verb, "--bins", options->bins, "steps of distance from the shadow's axis, 1 to 1000");
  add_flag(*verb, "--coding", options->coding,
           "of the photograph: as-file-says, srgb or linear, which a TIFF never says")
      .one_of({"as-file-says", "srgb", "linear"});
  add_flag(*verb, "--recipe-in", options->recipe_in,
           "the .exr whose recipe tells what the render shows, as a scene's texture does; "
           "without: the render itself")
      .reads_file();
  add_switch(*verb, "--json", options->json, "one JSON document on stdout");
  add_recipe_option(*verb);
  on_run(*verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
