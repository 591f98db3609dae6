// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "uses/light/moonlight.h"
#include "wrappers/python/arguments.h"
#include "wrappers/python/described.h"

namespace coppermoon::python {

/// Request for light that combines the arguments `air` and `light`. If one is absent, the library's defaults apply.
inline uses::LightRequest light_request(const std::optional<uses::Air>& air,
                                        const std::optional<uses::LightRequest>& light) {
  auto request = light.value_or(uses::LightRequest{});
  if (air) request.air = *air;
  return request;
}

/// Puts the objects that Python has passed (air, light, place) into the requests for a texture.
inline void take_objects(TextureKeywords& keywords, const std::optional<uses::Air>& air,
                         const std::optional<uses::LightRequest>& light,
                         const std::optional<Place>& at) {
  keywords.moon.light = light_request(air, light);
  if (at) keywords.view.observer = at->observer;
}

}  // namespace coppermoon::python
