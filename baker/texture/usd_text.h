// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>

namespace coppermoon::texture {

/// Header of a USD layer: the default prim `Moon`, the unit metre, Y up, and the Moon's true radius.
std::string usd_layer();

/// Scope `Looks` inside the prim Moon, with the material Moonlight: ground that emits a texture's light and reflects
/// nothing. It is a UsdPreviewSurface and, if `emission` is given, also a standard surface of MaterialX.
///
/// Given  file      lines with the attributes inputs:file and inputs:sourceColorSpace for UsdPreviewSurface
///        emission  path of the output that supplies MaterialX's emission; if empty, there is no MaterialX surface
///        nodes     text of the prims that are MaterialX nodes
std::string usd_looks(const std::string& file, const std::string& emission = {},
                      const std::string& nodes = {});

/// A prim within the material: the MaterialX node that places an image on the Moon.
///
/// Given  file  the image, as a USD value of type asset
std::string usd_image(const std::string& name, const std::string& file,
                      std::string_view colour_space);

/// The observer of the Moon at one moment, to be written as USD.
struct UsdMoment {
  double time_code = 0;
  glm::dvec3 position;        ///< position of the observer, Moon-fixed [lunar radii]
  glm::dvec3 direction, up;   ///< axes of the camera: perpendicular unit vectors, Moon-fixed
  double field_rad = 0;       ///< horizontal field of view of the camera
  std::array<double, 3> lux;  ///< illuminance at the observer, by channel
};

/// Two prims inside the prim Moon: `Observer`, a camera, and `Moonlight`, a distant light that shines from the Moon
/// towards the camera. If they change from moment to moment, they have time samples.
///
/// Given  height_over_width  ratio of the picture's sides
///        luminance          weights with which the channels add up to luminance
std::string usd_observer(std::span<const UsdMoment> moments, double height_over_width,
                         const std::array<double, 3>& luminance);

/// Prim `Sky`, a dome light inside the prim Moon, at one time code. Its file is a picture with the zenith on top and
/// north in the middle. `zenith` and `north` are perpendicular unit vectors in the Moon-fixed frame.
struct UsdSky {
  double time_code = 0;
  std::string file;
  glm::dvec3 zenith, north;
};
std::string usd_sky(std::span<const UsdSky> skies);

/// Refuses the name of a layer or file if USD would not resolve it. USD takes a backslash in a layer's name for the end
/// of a folder's name, and ignores whatever follows :SDF_FORMAT_ARGS:.
///
/// Throws  Error  when the name is empty or a path, or contains a backslash, :SDF_FORMAT_ARGS: or control characters
void require_usd_name(std::string_view file_name);

/// Path of a file in the layer's folder, as a USD value of type asset.
///
/// Throws  Error  as for require_usd_name
std::string usd_asset(std::string_view file_name);

/// Prim `Surface` inside the prim Moon: the mesh from sphere_mesh with the material Looks/Moonlight.
std::string usd_mesh();

}  // namespace coppermoon::texture
