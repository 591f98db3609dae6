// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "photons/limb.h"
#include "photons/march.h"
#include "shadow/irradiance.h"
#include "shadow/limb_landings.h"

namespace coppermoon::shadow {

/// Largest number of refractivities that a photon is marched at.
inline constexpr std::size_t march_nodes = 3;

/// Photon that was marched past the limb.
struct MarchedPhoton {
  std::size_t part;    ///< part of the limb
  float radius_m;      ///< distance of the ray's lowest point from the centre of curvature
  float excess_m;      ///< (b − radius) / (n₀ − 1)
  float excess_slope;  ///< derivative of excess_m with respect to altitude
  float weight_m;      ///< Aim::weight_m times 2π
  std::size_t filter;  ///< 0: tangent below the cloud's top, 1: above
  std::array<float, march_nodes> bending_rad;
  std::array<float, march_nodes * atmosphere::absorbers> amounts;  ///< [node][absorber at work]
};

/// Impact parameters b, bending angles δ and light (LimbLandings::pass) of a few photons.
struct MarchedRows {
  algebra::Grid<float> impact_m, bending_rad, light;  ///< (photon, wavelength), padded

  MarchedRows(std::size_t photons, std::size_t waves);
};

/// Marching of photons through the air, each along its own ray (photons::Marcher) at a few refractivities, from
/// which the rays of all wavelengths are interpolated (photons::Blend). No table of the limb is read: b and db/dh
/// are exact at a photon's tangent height. A photon carries, in units of 1/N (LimbLandings),
///
///     2π T b (db/dh) / p(h)
///
/// Accuracy  photons::Marcher's; interpolation between refractivities 3e-8 rad of bending; single precision of
///           the output: 3 m of landing at the Moon, 5e-7 of light, and as much for each unit of
///           optical depth
class MarchedPhotons {
 public:
  /// Given  parts   of the limb
  ///        optics  of each wavelength
  MarchedPhotons(std::span<const photons::WholeLimb::Part> parts,
                 std::span<const atmosphere::Optics> optics, const photons::Marching& marching);

  /// Photons marched along their rays.
  ///
  /// Given  aims  by part, then by height: neighbours take equally many steps in one vector
  std::vector<MarchedPhoton> followed(std::span<const Aim> aims) const;

  /// Writes b, δ and light of photons by wavelength; light without the Sun's limb darkening.
  void pass(std::span<const MarchedPhoton> photons, MarchedRows& rows) const;

 private:
  /// Part of the limb with its spectra, (…, wavelength), padded.
  struct Part {
    double radius_m, curvature_radius_m;
    atmosphere::Column column;
    std::vector<double> nodes;           ///< refractivities
    std::vector<std::size_t> absorbers;  ///< absorbers that the column has
    algebra::Grid<float> refractivity, shares, extinction, filter;
    photons::Marcher marcher;
  };

  static Part part_of(const photons::WholeLimb::Part& limb,
                      std::span<const atmosphere::Optics> optics,
                      const photons::Marching& marching);
  static void follow(const Part& part, std::span<const Aim> aims,
                     std::vector<MarchedPhoton>& photons);

  std::vector<Part> parts_;
};

/// Writes landing_m (see irradiance.h) of each photon and wavelength on a plane, in single precision.
void land(const MarchedRows& rows, std::size_t photons, double sun_distance_m, double depth_m,
          algebra::Grid<float>& landing_m);

}  // namespace coppermoon::shadow
