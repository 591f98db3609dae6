// SPDX-License-Identifier: MIT
#include "verbs/flags/moon_options.h"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <utility>

#include "uses/picture/picture_parameters.h"

namespace coppermoon::verbs {

void add_map_options(Verb& verb, uses::MoonRequest& request) {
  add_described(verb, request, uses::describe_map);
  request.when_near_side_brighter = [said = std::make_shared<bool>()](double ratio) {
    if (std::exchange(*said, true)) return;
    fmt::print(stderr,
               "coppermoon: the albedo map's near side is {:.0f} % brighter than its far side: if "
               "the map is from 0 to 360 degrees, add --albedo-map-centre 180\n",
               100 * (ratio - 1));
  };
}

void add_moon_options(Verb& verb, MoonOptions& options) {
  add_moment_options(verb, options.moment, "; or a file that coppermoon made, to make it again")
      .required();
  add_map_options(verb, options.request);
  add_described(verb, options.request, uses::describe_width);
  add_described(verb, options.request, uses::describe_unshadowed);
  add_light_options(verb, options.light);
  add_photon_file_options(verb, options.light);
}

void add_film_moon_options(Verb& verb, MoonOptions& options) {
  add_map_options(verb, options.request);
  add_described(verb, options.request, uses::describe_width);
  add_light_options(verb, options.light);
}

uses::MoonRequest moon_request(const MoonOptions& options) {
  auto request = options.request;
  request.light = light_request(options.light);
  if (options.light.effort.quality == "draft") request.texels_per_pixel = 0.5;
  return request;
}

almanac::SkyState eclipsed_sky(const MoonOptions& options,
                               const std::optional<almanac::Observer>& observer) {
  const auto sky = almanac::sky_at(instant_of(options.moment, observer));
  if (options.request.unshadowed) return sky;
  uses::require_eclipse(sky.when, " (--unshadowed goes on without one)", options.moment.calendar);
  say_unless_danjon_is_reached(options.light.request.air, sky);
  return sky;
}

}  // namespace coppermoon::verbs
