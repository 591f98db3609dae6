// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>

namespace coppermoon::texture {

/// Head of a USD layer: its default prim Moon, metres, Y up, and the Moon's true radius.
std::string usd_layer();

/// Scope `Looks` within Moon, with the material Moonlight: ground that shines by a texture and reflects nothing, as
/// UsdPreviewSurface and, with an emission, as MaterialX's standard surface.
///
/// Given  file      lines of the preview's attributes inputs:file and inputs:sourceColorSpace
///        emission  path of the output that MaterialX's ground shines by; empty: no MaterialX
///        nodes     prims of MaterialX's nodes
std::string usd_looks(const std::string& file, const std::string& emission = {},
                      const std::string& nodes = {});

/// Prim of MaterialX's node of an image on the Moon, within the material.
///
/// Given  file  as a value of type asset
std::string usd_image(const std::string& name, const std::string& file,
                      std::string_view colour_space);

/// A moment of the Moon's observer, for USD.
struct UsdMoment {
  double time_code = 0;
  glm::dvec3 position;        ///< Moon-fixed, lunar radii
  glm::dvec3 direction, up;   ///< of the camera, Moon-fixed, unit, at right angles
  double field_rad = 0;       ///< across the picture
  std::array<double, 3> lux;  ///< illuminance by channel at the observer
};

/// Prims `Observer`, a camera, and `Moonlight`, a distant light that shines from the Moon to it, within Moon; with
/// samples at each moment where there are several.
///
/// Given  height_over_width  of the picture
///        luminance          weights of the channels
std::string usd_observer(std::span<const UsdMoment> moments, double height_over_width,
                         const std::array<double, 3>& luminance);

/// Prim `Sky`, a dome light, within Moon: at each time code its file, zenith on top and north in the middle, and the
/// directions of zenith and north, Moon-fixed, unit, at right angles.
struct UsdSky {
  double time_code = 0;
  std::string file;
  glm::dvec3 zenith, north;
};
std::string usd_sky(std::span<const UsdSky> skies);

/// Refuses a name that USD does not find, of a layer or of a file beside it. USD takes the backslash of a layer's name
/// for the end of its folder, and what follows :SDF_FORMAT_ARGS: for no part of the name.
///
/// Throws  Error  unless it is a plain name without those and control characters
void require_usd_name(std::string_view file_name);

/// Path of a file beside the layer, as a value of type asset.
///
/// Throws  Error  as require_usd_name
std::string usd_asset(std::string_view file_name);

/// Prim `Surface` within Moon: sphere_mesh's sphere, bound to the material Looks/Moonlight.
std::string usd_mesh();

}  // namespace coppermoon::texture
