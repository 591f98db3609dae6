// SPDX-License-Identifier: MIT
// Requests that several functions put together from the same arguments.
#pragma once

#include <optional>

#include "uses/picture/moon.h"
#include "uses/picture/view.h"
#include "wrappers/python/arguments.h"

namespace coppermoon::python {

/// Light through some air; without either, as the library has it.
inline uses::LightRequest light_request(const std::optional<uses::Air>& air,
                                        const std::optional<uses::LightRequest>& light) {
  auto request = light.value_or(uses::LightRequest{});
  if (air) request.air = *air;
  return request;
}

/// The Moon of an image function's arguments.
struct MoonArguments {
  std::string albedo_map;
  uses::AlbedoEncoding albedo_encoding;
  int albedo_map_centre;
  double albedo_exponent;
  surface::Photometry photometry;
  bool unshadowed;
};

inline uses::MoonRequest moon_request(const uses::LightRequest& light, const MoonArguments& told) {
  return {.light = light,
          .albedo_map = told.albedo_map,
          .photometry = told.photometry,
          .albedo_encoding = told.albedo_encoding,
          .albedo_exponent = told.albedo_exponent,
          .albedo_map_centre_deg = told.albedo_map_centre,
          .unshadowed = told.unshadowed};
}

/// Who looks, and whether the air above reddens the Moon.
inline uses::ViewRequest view_request(const std::optional<Place>& at, bool reddening) {
  uses::ViewRequest view{.reddening = reddening};
  if (at) view.observer = at->observer;
  return view;
}

}  // namespace coppermoon::python
