// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "photons/earth_limb.h"
#include "shadow/irradiance.h"
#include "shadow/photon_spectra.h"

namespace coppermoon::shadow {

/// A photon that carries all wavelengths, before it passes the limb: its part of the limb, tangent height and source
/// on the Sun.
struct Aim {
  std::size_t part, cell;  ///< part of the limb, and interval between two of the part's rays
  double along;            ///< place in the cell: 0 at the lower ray, 1 at the upper ray
  double tangent_height_m;
  glm::dvec2 toward;  ///< unit vector from the axis to the limb
  glm::dvec2 source;  ///< point on the Sun's disc, in solar radii
  /// probability density of the source on a uniform disc, divided by the joint density [m⁻¹] of height and source
  /// with which the photon was drawn
  double weight_m;
};

/// Tables of landing place and light on each plane, by tangent height and wavelength, from which photons are drawn.
/// Each of N photons carries as much light as falls, in unshaded sunlight, on an area [m²] of 1/N times
///
///     2π T b (db/dh) / p(h)
///
/// with T the transmittance, b the impact parameter and p the probability density of tangent heights h. Between rays,
/// the product T b varies exponentially in the limb's table. In this class it varies linearly, with the same integral.
///
/// Landings are drawn for the middle wavelength. Axis distances are distributed uniformly, so that rings near the axis
/// get as many photons as others. Tangent heights are distributed like the light, over all wavelengths, that each
/// height sends to the axis distance; for a fifth of the photons they are uniform in landing distance or in height
/// instead. Directions are uniform over the arc within the Sun's disc. The source on the Sun follows from the landing.
class LimbLandings {
 public:
  LimbLandings(const atmosphere::Atmosphere& atmosphere, const Arrangement& arrangement,
               std::span<const double> wavelengths_nm, int rays);

  /// Photons of a block (algebra::scrambled_block), ordered by part of the limb and then by the two rays between which
  /// they pass, lowest first. Landings that no ray from the Sun reaches are left out.
  ///
  /// Given  around  whether to draw position angles; if not, the position angle of every photon is 0
  std::vector<Aim> aims(std::uint64_t seed, std::uint64_t block, bool around) const;

  /// Writes the light that photons carry after they have passed the limb, at each wavelength, as the area [m²] that
  /// receives as much unshaded sunlight. The Sun's brightness at each photon's source is included.
  ///
  /// Given  light  grid with at least as many rows as there are aims
  void pass(std::span<const Aim> aims, algebra::Grid<float>& light) const;

  /// Writes the signed axis distances at which photons would land if they came from the Sun's centre, by wavelength.
  void land(std::span<const Aim> aims, std::size_t plane, algebra::Grid<float>& landing_m) const;

 private:
  /// Tables for one part of the limb.
  struct Table {
    std::vector<double> heights_m;  ///< [ray], tangent heights
    /// [ray], signed axis distances at which rays of the middle wavelength land [projected solar radii]
    std::vector<double> middle_landing;
    algebra::Grid<float> light;  ///< (2 × interval + end, wavelength); end 0 is the lower ray
    std::vector<algebra::Grid<float>> landing_m;  ///< [plane](ray, wavelength)
    /// (bin of axis distance, ray): probability that a photon passes below the ray; all 0 if no light lands in the bin
    algebra::Grid<double> chance;
  };

  Table table(const photons::WholeLimb::Part& part) const;
  void fill_light(const photons::WholeLimb::Part& part, Table& table) const;
  void fill_landings(const photons::WholeLimb::Part& part, Table& table) const;
  algebra::Grid<double> brought(const Table& table) const;
  void fill_chances(Table& table) const;
  std::optional<Aim> aim(std::span<const double> point, bool around) const;
  std::size_t part_at(double position_angle_rad, double uniform) const;
  void darken_limb(std::span<const double> wavelengths_nm);
  void darken(std::span<const Aim> aims, algebra::Grid<float>& light) const;

  photons::WholeLimb limb_;
  Arrangement arrangement_;
  std::size_t waves_;
  std::vector<Table> tables_;
  double reach_ = 0;                 ///< largest axis distance of landings [projected solar radii]
  algebra::Grid<float> brightness_;  // (μ, wavelength); empty for a uniform disc
};

}  // namespace coppermoon::shadow
