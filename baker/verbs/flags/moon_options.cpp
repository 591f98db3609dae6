// SPDX-License-Identifier: MIT
#include "verbs/flags/moon_options.h"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <utility>

#include "verbs/flags/air_options.h"

namespace coppermoon::verbs {

void add_map_options(CLI::App& verb, uses::MoonRequest& request) {
  using enum surface::Photometry;
  add_flag(verb, "--albedo-map", request.albedo_map,
           "albedo map: an image of 2:1 with longitude 0 in the middle, or built-in: NASA's CGI Moon "
           "Kit of 2019, 4096 texels wide")
      .reads_file();
  add_choice<int>(verb, "--albedo-map-centre", request.albedo_map_centre_deg,
                  {{"0", 0}, {"180", 180}},
                  "longitude in the middle of the albedo map [degrees]: 0, or 180 for a map from 0 "
                  "to 360");
  request.when_near_side_brighter = [said = std::make_shared<bool>()](double ratio) {
    if (std::exchange(*said, true)) return;
    fmt::print(stderr,
               "coppermoon: the albedo map's near side is {:.0f} % brighter than its far side: if "
               "the map is from 0 to 360 degrees, add --albedo-map-centre 180\n",
               100 * (ratio - 1));
  };
  add_choice<surface::Photometry>(
      verb, "--photometry", request.photometry,
      {{"lommel-seeliger-rolo", lommel_seeliger_rolo}, {"yapo-cutler", yapo_cutler}},
      "photometric function of the ground: lommel-seeliger-rolo (as telescopes measured, with the "
      "opposition surge) or yapo-cutler (the paper's, the same at every phase)");
  using enum uses::AlbedoEncoding;
  add_choice<uses::AlbedoEncoding>(
      verb, "--albedo-encoding", request.albedo_encoding,
      {{"image", image},
       {"normal-albedo", normal_albedo},
       {"cgi-moon-kit-2019", cgi_moon_kit_2019},
       {"cgi-moon-kit-2025", cgi_moon_kit_2025}},
      "how the numbers of a map's file stand for albedo: image (light, as the file says), "
      "normal-albedo (themselves), cgi-moon-kit-2019 or cgi-moon-kit-2025 (NASA's colour maps)");
  add_flag(verb, "--albedo-exponent", request.albedo_exponent,
           "exponent that undoes a tone curve of the map beyond its encoding, 0.1 to 10");
  add_choice<bool>(
      verb, "--ground", request.ground_by_place, {{"by-place", true}, {"mean", false}},
      "colour and opposition surge of the ground: by-place (as a camera in lunar orbit "
      "measured them) or mean (everywhere those of the whole Moon)");
}

void add_width_option(CLI::App& verb, uses::MoonRequest& request) {
  add_flag(verb, "--texture-width", request.texture_width,
           "width of the texture [texels], even, 4 to 32768; default: 4096, for a frame as "
           "many as it can show")
      .not_negative();
}

void add_moon_options(CLI::App& verb, MoonOptions& options) {
  add_moment_options(verb, options.moment, "; or a file that coppermoon made, to make it again")
      .required();
  add_map_options(verb, options.request);
  add_width_option(verb, options.request);
  add_switch(verb, "--unshadowed", options.request.unshadowed,
             "lights the Moon as if the Earth were away");
  add_light_options(verb, options.light);
  add_photon_file_options(verb, options.light);
}

void add_film_moon_options(CLI::App& verb, MoonOptions& options) {
  add_map_options(verb, options.request);
  add_width_option(verb, options.request);
  add_light_options(verb, options.light);
}

uses::MoonRequest moon_request(const MoonOptions& options) {
  auto request = options.request;
  request.light = light_request(options.light);
  if (options.light.plan.quality == "draft") request.texels_per_pixel = 0.5;
  return request;
}

almanac::SkyState eclipsed_sky(const MoonOptions& options) {
  const auto sky = almanac::sky_at(instant_of(options.moment));
  if (options.request.unshadowed) return sky;
  uses::require_eclipse(sky.when, " (--unshadowed goes on without one)", options.moment.calendar);
  say_unless_danjon_is_reached(options.light.request.air, sky);
  return sky;
}

}  // namespace coppermoon::verbs
