// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "algebra/progress.h"
#include "almanac/sky.h"
#include "atmosphere/atmosphere.h"
#include "shadow/irradiance.h"
#include "surface/photometry.h"
#include "texture/image.h"
#include "uses/picture/moon.h"

namespace coppermoon::uses {

/// A scene at one moment, in which the shadow is computed in a single plane through the Moon's centre.
struct MeasuredScene {
  almanac::SkyState sky;
  atmosphere::Atmosphere air;
  shadow::Arrangement arrangement;
  algebra::Grid<float> normal_albedo;
  surface::Photometry photometry;
};

/// Makes the scene for one moment.
///
/// Given   moon   its air, limb darkening, map, photometry and texture width are used; the rest is ignored
/// Throws  Error  when the air or the map is invalid
MeasuredScene measured_scene(const MoonRequest& moon, const almanac::SkyState& sky);

struct ReferenceSettings {
  int rays = 6000;
  std::size_t bands = 400;
  double spacing_m = 25e3;  ///< step between axis distances, as far as refracted light reaches
  std::size_t texture_width = 512;
};

/// Settings for a reference that takes only seconds. Its error is at most a ninth of the error with 300 rays.
constexpr ReferenceSettings quick_reference{1000, 200, 50e3, 256};

/// Errors of irradiance, relative to the sum of refracted and direct light in the reference at the same place: the root
/// mean square over an area, and the largest error.
struct Spread {
  double rms = 0, worst = 0;
};

/// Colour difference CIEDE2000 between two pictures of the Moon's disc: its mean and its 99th percentile.
struct PictureErrors {
  double mean = 0, percentile_99 = 0;
};

/// Errors of light in the umbra (within 4500 km of the axis), in the penumbra (beyond that), and in the picture.
struct LightErrors {
  Spread umbra, penumbra;
  PictureErrors picture;
};

/// Reference light for one scene, relative to which the errors of other light are measured.
///
/// Irradiance is weighted as luminance: the sum over bands of ȳ times sunlight times the light's ratio to sunlight.
/// Light from the quadrature is compared place by place. Light from photons is compared at the middles of its rings,
/// with the mean of the reference over each sector. Pictures show the scene's Moon in the given light, as seen from the
/// Earth's centre, and are developed at the exposure that suits the reference.
class Yardstick {
 public:
  /// Computes the reference light.
  ///
  /// Throws  Error  when no light reaches the middle of the shadow
  Yardstick(MeasuredScene scene, const ReferenceSettings& settings,
            const algebra::Progress& progress = {});

  const MeasuredScene& scene() const { return scene_; }
  /// Axis distances at which the quadrature should compute the light to be compared.
  const std::vector<double>& axis_distances_m() const { return distances_m_; }

  /// Errors of the given light relative to the reference light.
  ///
  /// Given  light     light in the scene's plane, at axis_distances_m or in rings
  ///        in_rings  whether the light is in rings, as it is if it comes from photons
  LightErrors errors_of(const shadow::RefractedLight& light, bool in_rings);

  /// Texture of the scene's Moon in the given light, linear Rec.709 [cd/m²].
  texture::Image baked(const shadow::RefractedLight& light, std::size_t width) const;

  /// Difference between two pictures, as seen from the Earth's centre, that are made with two textures.
  ///
  /// Given  pixels  number of pixels across the disc; texels are interpolated bilinearly
  PictureErrors picture_errors(const texture::Image& reference, const texture::Image& other,
                               std::size_t pixels) const;

 private:
  using Field = algebra::Grid<double>;  // luminance by sector and place

  const Field& direct(std::size_t bands);
  LightErrors errors_at_places(const Field& refracted, const Field& clear) const;
  LightErrors errors_in_rings(const Field& refracted, const Field& clear,
                              std::span<const double> rings_m) const;

  MeasuredScene scene_;
  ReferenceSettings settings_;
  std::vector<double> distances_m_;
  std::size_t sectors_ = 1;
  std::map<std::size_t, Field> direct_;  // keyed by number of bands
  Field total_;
  texture::Image texture_;
};

}  // namespace coppermoon::uses
