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

/// A moment, its air, and the plane behind the Earth where the Moon's centre is.
struct MeasuredScene {
  almanac::SkyState sky;
  atmosphere::Atmosphere air;
  shadow::Arrangement arrangement;
  algebra::Grid<float> normal_albedo;
  surface::Photometry photometry;
};

/// The scene of one moment, its light spread over one plane.
///
/// Given   moon   its air and limb darkening, its map, photometry and texture width; nothing else counts
/// Throws  Error  when the air or the map is not sound
MeasuredScene measured_scene(const MoonRequest& moon, const almanac::SkyState& sky);

/// How finely the reference is made.
struct ReferenceSettings {
  int rays = 6000;
  std::size_t bands = 400;
  double spacing_m = 25e3;  ///< step of axis distance, over all that refracted light reaches
  std::size_t texture_width = 512;
};

/// Settings of a reference that takes seconds.
constexpr ReferenceSettings quick_reference{3000, 200, 50e3, 256};

/// Error of an irradiance, relative to the reference's total there, refracted and direct: root mean
/// square over the area, and the worst place's.
struct Spread {
  double rms = 0, worst = 0;
};

/// Difference between two pictures: CIEDE2000 over the Moon's disc, mean and 99th percentile.
struct PictureErrors {
  double mean = 0, percentile_99 = 0;
};

/// Errors of light: in the umbra (within 4500 km of the axis), beyond it, and in the picture.
struct LightErrors {
  Spread umbra, penumbra;
  PictureErrors picture;
};

/// The light that others are held to, in one scene.
///
/// Irradiance counts as the eye sees it: Σ over bands of ȳ times sunlight times ratio. Light of the
/// quadrature is compared place by place; that of photons at the middles of their rings, with the
/// reference's mean over each sector. The picture is the scene's Moon baked in that light, seen from the Earth's centre, and
/// developed at the exposure that suits the reference's.
class Yardstick {
 public:
  Yardstick(MeasuredScene scene, const ReferenceSettings& settings,
            const algebra::Progress& progress = {});

  const MeasuredScene& scene() const { return scene_; }
  const ReferenceSettings& settings() const { return settings_; }

  /// The places where a quadrature is asked.
  const std::vector<double>& axis_distances_m() const { return distances_m_; }

  /// Given  light  on the scene's plane; of photons: in rings, else at axis_distances_m
  LightErrors errors_of(const shadow::RefractedLight& light, bool in_rings);

  /// The scene's Moon in that light, linear Rec.709 [cd/m²].
  texture::Image baked(const shadow::RefractedLight& light, std::size_t width) const;

  /// Given  pixels  across the disc as the Earth's centre sees it; between texels bilinear
  PictureErrors picture_errors(const texture::Image& reference, const texture::Image& other,
                               std::size_t pixels) const;

 private:
  using Field = algebra::Grid<double>;  // (sector, place): luminance

  const Field& direct(std::size_t bands);
  void compare_at_places(const Field& refracted, const Field& clear, LightErrors& errors) const;
  void compare_in_rings(const Field& refracted, const Field& clear, std::span<const double> rings_m,
                        LightErrors& errors) const;

  MeasuredScene scene_;
  ReferenceSettings settings_;
  std::vector<double> distances_m_;
  std::size_t sectors_ = 1;
  std::map<std::size_t, Field> direct_;  // by the number of bands
  Field total_;
  texture::Image texture_;
};

}  // namespace coppermoon::uses
