// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "photons/limb.h"
#include "shadow/irradiance.h"
#include "shadow/photon_rows.h"

namespace coppermoon::shadow {

/// A photon of all wavelengths, before it has passed the limb: which part of it, at what tangent
/// height, from where on the Sun.
struct Aim {
  std::size_t part, cell;  ///< of the limb; between two of its rays
  double along;            ///< of the cell: 0 at the lower ray, 1 at the upper
  double tangent_height_m;
  glm::dvec2 toward;  ///< from the axis to the limb, unit
  glm::dvec2 source;  ///< on the Sun's disc, in solar radii
  /// density of a place on a uniform disc, over the density [m⁻¹] of height and place it was drawn
  /// with
  double weight_m;
};

/// Tables of where on each plane light lands that passed the limb, and of how much it is, by
/// tangent height and wavelength: all that photons need. A photon that stands for 1/N of all
/// carries
///
///     2π T b (db/dh) / p(h)
///
/// square metres of unshaded sunlight: T the transmittance, b the impact parameter, p the density
/// of tangent heights. T b runs exponentially in the limb's table; here it is straight from ray to
/// ray, with the same sum.
///
/// Landings of the middle wavelength are drawn: their distances from the axis spread evenly, so
/// that rings near the axis get as many photons as the others; tangent heights by the light that
/// each brings there, in the mean of the wavelengths, but for a fifth by the way that landings go
/// from ray to ray and by height; directions evenly over those that come from the Sun's disc. From
/// the landing follows the place on the Sun.
class LimbLandings {
 public:
  LimbLandings(const atmosphere::Atmosphere& atmosphere, const Arrangement& arrangement,
               std::span<const double> wavelengths_nm, int rays);

  /// A block of photons (algebra::scrambled_block), part by part of the limb, from the lowest cell
  /// up; those that no light could reach from the Sun are left out.
  ///
  /// Given  around  whether from all position angles; else from one, for all
  std::vector<Aim> aims(std::uint64_t seed, std::uint64_t block, bool around) const;

  /// The limb that they pass.
  const std::vector<photons::WholeLimb::Part>& parts() const { return limb_.parts(); }

  /// Writes the light that photons carry behind the limb, by wavelength [m²], the Sun's brightness
  /// where they come from included.
  ///
  /// Given  light  as many rows as aims, or more
  void pass(std::span<const Aim> aims, algebra::Grid<float>& light) const;

  /// Multiplies light by the Sun's brightness where each photon comes from, by wavelength.
  void darken(std::span<const Aim> aims, algebra::Grid<float>& light) const;

  /// Writes the signed distances from the axis where light from the Sun's centre would land, by
  /// wavelength.
  void land(std::span<const Aim> aims, std::size_t plane, algebra::Grid<float>& landing_m) const;

 private:
  /// The tables of one part of the limb.
  struct Table {
    std::vector<double> heights_m;       ///< by ray
    std::vector<double> middle_landing;  ///< of the middle wavelength, in projected solar radii
    algebra::Grid<float> light;          ///< (2 cell + end, wavelength)
    std::vector<algebra::Grid<float>> landing_m;  ///< by plane, (ray, wavelength)
    /// probability that a photon of this axis distance passes below a ray, (bin of the distance, ray);
    /// all 0 where none lands
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

  photons::WholeLimb limb_;
  Arrangement arrangement_;
  std::size_t waves_;
  std::vector<Table> tables_;
  double reach_ = 0;                 ///< of landings [projected solar radii]
  algebra::Grid<float> brightness_;  // (μ, wavelength); none for a uniform disc
};

}  // namespace coppermoon::shadow
