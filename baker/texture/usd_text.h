// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>

namespace coppermoon::texture {

/// Header of a USD layer. It states the default prim Moon, metres, Y up, and the Moon's true radius.
std::string usd_layer();

/// Scope `Looks` within Moon, with the material Moonlight: ground that emits the light in a texture and reflects
/// nothing. It is a UsdPreviewSurface and, if `emission` is given, also MaterialX's standard surface.
///
/// Given  file      lines with the attributes inputs:file and inputs:sourceColorSpace for UsdPreviewSurface
///        emission  path of the output that is MaterialX's emission; if empty, there is no MaterialX
///        nodes     prims of the MaterialX nodes
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
  glm::dvec3 position;        ///< in the Moon-fixed frame, lunar radii
  glm::dvec3 direction, up;   ///< of the camera: perpendicular unit vectors, Moon-fixed
  double field_rad = 0;       ///< field of view across the picture
  std::array<double, 3> lux;  ///< illuminance at the observer, by channel
};

/// Two prims within Moon: `Observer`, a camera, and `Moonlight`, a distant light that shines from the Moon towards the
/// camera. If they change between moments, they have time samples.
///
/// Given  height_over_width  ratio of the picture's sides
///        luminance          weights of the channels in luminance
std::string usd_observer(std::span<const UsdMoment> moments, double height_over_width,
                         const std::array<double, 3>& luminance);

/// Prim `Sky`, a dome light within Moon, at one time code. Its file is a picture with the zenith on top and north in
/// the middle; zenith and north are Moon-fixed unit vectors at right angles.
struct UsdSky {
  double time_code = 0;
  std::string file;
  glm::dvec3 zenith, north;
};
std::string usd_sky(std::span<const UsdSky> skies);

/// Refuses a layer or file name that USD would not resolve. USD takes a backslash in a layer's name for the end of its
/// folder's name, and ignores whatever follows :SDF_FORMAT_ARGS:.
///
/// Throws  Error  when the name is empty or a path, or contains a backslash, :SDF_FORMAT_ARGS: or control characters
void require_usd_name(std::string_view file_name);

/// Path of a file in the layer's folder, as a USD value of type asset.
///
/// Throws  Error  as for require_usd_name
std::string usd_asset(std::string_view file_name);

/// Prim `Surface` within Moon: the mesh from sphere_mesh with the material Looks/Moonlight.
std::string usd_mesh();

}  // namespace coppermoon::texture
