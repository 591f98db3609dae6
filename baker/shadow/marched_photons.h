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

/// A photon that was marched past the limb.
struct MarchedPhoton {
  std::size_t part;    ///< of the limb
  float radius_m;      ///< of its lowest point
  float excess_m;      ///< (b − radius) / (n₀ − 1)
  float excess_slope;  ///< of that over altitude
  float weight_m;      ///< as its aim's, times 2π
  std::size_t filter;  ///< 0 below the cloud's top, 1 above
  std::array<float, march_nodes> bending_rad;
  std::array<float, march_nodes * atmosphere::absorbers> amounts;  ///< [node][absorber at work]
};

/// Impact parameters, bending and light of a few photons, (photon, wavelength), padded.
struct MarchedRows {
  algebra::Grid<float> impact_m, bending_rad, light;  ///< b, δ and light as LimbLandings has it

  MarchedRows(std::size_t photons, std::size_t waves);
};

/// Sends photons through the air each on a ray of its own, marched step by step (photons::Marcher)
/// at a few refractivities, from which all wavelengths' rays follow (photons::Blend). Nothing is
/// read from a table of the limb: at a photon's own tangent height b and db/dh are exact, and
///
///     2π T b (db/dh) / p(h)
///
/// is what it carries.
///
/// Accuracy  the Marcher's; of the blend 3e-8 rad of bending; of single precision, in all that is
///           written: of landings at the Moon 3 m, of light 5e-7 and as much for each unit of
///           optical depth
class MarchedPhotons {
 public:
  /// Given  parts  of the limb;  optics: of each wavelength
  MarchedPhotons(std::span<const photons::WholeLimb::Part> parts,
                 std::span<const atmosphere::Optics> optics, const photons::Marching& marching);

  /// Given  aims  part by part, heights in order, so that those side by side take as many steps
  std::vector<MarchedPhoton> followed(std::span<const Aim> aims) const;

  /// Writes what photons carry; the Sun's brightness is not in it.
  void pass(std::span<const MarchedPhoton> photons, MarchedRows& rows) const;

 private:
  /// One part of the limb, as all wavelengths see it: (…, wavelength), padded.
  struct Part {
    double radius_m, curvature_radius_m;
    atmosphere::Column column;
    std::vector<double> nodes;           ///< refractivities
    std::vector<std::size_t> absorbers;  ///< those at work
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

/// Writes where on a plane they land: landing_m of each photon and wavelength, as floats.
void land(const MarchedRows& rows, std::size_t photons, double sun_distance_m, double depth_m,
          algebra::Grid<float>& landing_m);

}  // namespace coppermoon::shadow
