// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace coppermoon::texture {

/// Head of a USD layer: its default prim Moon, metres, Y up, and the Moon's true radius.
std::string usd_layer();

/// Prim `Surface` within Moon: sphere_mesh's sphere, bound to the material Looks/Moonlight.
std::string usd_mesh();

}  // namespace coppermoon::texture
