// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>

namespace coppermoon::texture {

/// Header of a USD layer: default prim Moon, metres, Y up, and the Moon's true radius.
std::string usd_layer();

/// Scope `Looks` within Moon, with the material Moonlight: ground that emits the light in a texture and reflects
/// nothing, as UsdPreviewSurface and, if `emission` is given, also as MaterialX's standard surface.
///
/// Given  file      lines with the preview's attributes inputs:file and inputs:sourceColorSpace
///        emission  path of the output that gives MaterialX's emission; if empty, no MaterialX
///        nodes     prims of MaterialX's nodes
std::string usd_looks(const std::string& file, const std::string& emission = {},
                      const std::string& nodes = {});

/// Prim within the material, for the MaterialX node that places an image on the Moon.
///
/// Given  file  as a USD value of type asset
std::string usd_image(const std::string& name, const std::string& file,
                      std::string_view colour_space);

/// The observer of the Moon at one moment, for USD.
struct UsdMoment {
  double time_code = 0;
  glm::dvec3 position;        ///< Moon-fixed, lunar radii
  glm::dvec3 direction, up;   ///< of the camera: Moon-fixed unit vectors at right angles
  double field_rad = 0;       ///< field of view across the picture
  std::array<double, 3> lux;  ///< illuminance at the observer, by channel
};

/// Prims within Moon: `Observer`, a camera, and `Moonlight`, a distant light that shines from the Moon towards it. If
/// there are several moments, each has time samples.
///
/// Given  height_over_width  of the picture
///        luminance          weights of the channels in luminance
std::string usd_observer(std::span<const UsdMoment> moments, double height_over_width,
                         const std::array<double, 3>& luminance);

/// Prim `Sky`, a dome light within Moon. At each time code it has a file with zenith on top and north in the middle,
/// and the directions of zenith and north, Moon-fixed unit vectors at right angles.
struct UsdSky {
  double time_code = 0;
  std::string file;
  glm::dvec3 zenith, north;
};
std::string usd_sky(std::span<const UsdSky> skies);

/// Refuses a layer or file name that USD would not resolve. USD takes a backslash in a layer's name as the end of its
/// folder, and ignores what follows :SDF_FORMAT_ARGS:.
///
/// Throws  Error  unless it is a plain name without either, and without control characters
void require_usd_name(std::string_view file_name);

/// Path of a file beside the layer, as a USD value of type asset.
///
/// Throws  Error  as require_usd_name
std::string usd_asset(std::string_view file_name);

/// Prim `Surface` within Moon: the sphere from sphere_mesh, bound to the material Looks/Moonlight.
std::string usd_mesh();

}  // namespace coppermoon::texture
