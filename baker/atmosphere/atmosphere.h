// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "algebra/quantity.h"
#include "atmosphere/aerosol.h"
#include "atmosphere/density.h"
#include "atmosphere/figure.h"
#include "atmosphere/ozone.h"
#include "atmosphere/seasonal_air.h"
#include "atmosphere/stratosphere.h"

namespace coppermoon::atmosphere {

/// How the air thins with altitude, and where it ends: no air at all; US 1976 with the paper's ramp
/// to 42 km; US 1976 to 86 km; by latitude and season, to 86 km.
enum class Density { none, yapo_cutler, us_1976, seasonal };

/// Ozone as one filter for all light that passed the limb, or along each ray's own path.
enum class OzonePath { filter, bent };

/// Air over one part of the limb, term by term: each can be switched off. Tables of a latitude and a
/// month are shared between columns, and never change.
struct Column {
  Density density = Density::yapo_cutler;
  bool refraction = true;  ///< off: light goes straight through the air
  bool rayleigh = true;    ///< off: molecules do not scatter
  double ozone_du = 0;     ///< vertical column [DU]; 0: off
  OzonePath ozone_path = OzonePath::filter;
  double dust_extinction_per_m = 0;  ///< grey extinction α of the layer, 0 to 0.01 m⁻¹; 0: off
  double dust_bottom_m = 15e3, dust_top_m = 20e3;
  double tropospheric_optical_depth = 0;  ///< of aerosol, vertical, at 550 nm, 0 to 10; 0: off
  double tropospheric_scale_m = 2e3;      ///< height in which it falls to 1/e, 500 to 10 000 m
  StratosphericAerosol stratosphere = StratosphericAerosol::none;
  double cloud_top_m = 10e3;
  double cloud_cover = 0;  ///< part of the limb where cloud stops all rays below its top; 0: off

  double tropopause_m = 11e3;  ///< 5 to 20 km; of the four terms below
  double cloud_per_m = 0;      ///< chance to meet cloud, 0 to 0.01 m⁻¹; 0: off
  double cirrus = 0;           ///< factor on cirrus_extinction_per_m, 0 to 100; 0: off
  double free_troposphere_per_m =
      0;  ///< extinction by aerosol at 7 km and 550 nm, 0 to 0.01; 0: off
  bool oxygen_pairs = false, nitrogen_dioxide = false;  ///< off: they absorb nothing
  std::shared_ptr<const SeasonalAir> seasonal_air{};    ///< of Density::seasonal
  std::shared_ptr<const OzoneClimate> ozone_climate{};  ///< without: the profile of US 1976
  /// instead of `stratosphere`, where there is any
  std::shared_ptr<const StratosphericLayer> stratospheric_layer{};

  bool operator==(const Column&) const = default;
};

/// Altitude where a column's air ends [m]: 0, 42 000 or 86 000.
double top_m(const Column& column);

/// A column of air at one distance from north along the limb, alike to the east and to the west.
struct Belt {
  double from_north_rad;  ///< 0 to π
  Column column{};

  bool operator==(const Belt&) const = default;
};

/// Belts from north to south. Between two the light is a mean of the light that either would pass,
/// straight in the position angle; beyond the first and the last it is that of these.
using Belts = std::vector<Belt>;

/// A part of the limb with air of its own: from one position angle through east to the other.
/// The position angle is measured at the Earth, about the shadow axis, from celestial north through
/// east.
struct Region {
  algebra::Angle from, to;
  Column column{};
  Belts belts{};  ///< instead of the column, where there are any

  bool operator==(const Region&) const = default;
};

/// The parts of the limb between two latitudes (south to north): two regions, east and west, as
/// position angles; one where they meet over a pole; none where no part of the limb reaches them.
///
/// Given   sun_declination  how far the north pole is tipped towards the Sun
/// Throws  Error            when a latitude is outside ±90°, or south is north of north
std::vector<Region> between_latitudes(algebra::Angle south, algebra::Angle north,
                                      algebra::Angle sun_declination, const Column& column);

enum class Dispersion { crc, ciddor_1996 };
enum class KingFactor { fixed, bates_1984 };  ///< fixed: 1.050

/// Models of refraction and scattering by the molecules of the air.
struct Molecules {
  Dispersion dispersion = Dispersion::crc;
  KingFactor king_factor = KingFactor::fixed;

  bool operator==(const Molecules&) const = default;
};

/// The Earth and its air, by position angle: that of the first region that holds it, else the air of no
/// region. As it stands: the paper's sphere and air, without ozone and dust.
struct Atmosphere {
  Figure earth{};
  Molecules molecules{};
  Column column{};  ///< of no region
  Belts belts{};    ///< of no region; instead of the column, where there are any
  std::vector<Region> regions{};

  bool operator==(const Atmosphere&) const = default;

  /// A column and its part of the light that passes the limb somewhere.
  struct Share {
    std::size_t column;  ///< index in `columns`
    double share;
  };

  /// Whether one column stands all around.
  bool one_column() const { return regions.empty() && belts.empty(); }
  /// Whether the air of some place is a mean of two columns.
  bool belted() const { return columns().size() > 1 + regions.size(); }
  /// Whether the air is alike all around: a sphere with one column.
  bool symmetric() const { return one_column() && earth.sphere(); }
  /// Altitude where the last of its air ends.
  double top_m() const;
  double top_radius_m() const { return earth.equatorial_radius_m + top_m(); }
  /// Columns: that of no region, then each region's; where there are belts, each belt's.
  std::vector<const Column*> columns() const;
  /// The region that a position angle is in, counted from 1; 0 where in none.
  std::size_t region_index(double position_angle_rad) const;
  /// The two columns whose light a place of the limb passes; shares add to 1, the second is 0 where
  /// there are no belts.
  std::array<Share, 2> shares_at(double position_angle_rad) const;
};

/// Air with every third of its belts, the first and the last among them: for a coarse look.
Atmosphere with_fewer_belts(Atmosphere atmosphere);

/// Air with the largest amount of dust, ozone and cloud cover that any of some airs has, in every column.
///
/// Given   airs   that differ in these amounts alone, and share their tables
/// Throws  Error  when there are none, or they differ in anything else
Atmosphere richest(std::span<const Atmosphere> airs);

/// Throws Error when a term is outside its range: names it, its unit and what is allowed.
void require_valid(const Atmosphere& atmosphere);

/// Optical properties of the air at sea level, for one wavelength: they do not depend on altitude.
struct Optics {
  double refractivity;    ///< n₀ − 1
  double rayleigh_per_m;  ///< β₀ = N₀ σ
  double wavelength_nm;
};

/// Throws Error when the wavelength is outside 380 to 780 nm
Optics sea_level_optics(algebra::Wavelength wavelength, const Molecules& molecules = {});

/// Constituents that take light out of a ray. Each has a profile over altitude and a spectrum;
/// extinction is the sum of their products, optical depth that of spectrum and profile summed along
/// the path. All else about them stands in one table, in atmosphere.cpp.
enum Absorber : std::size_t {
  air,
  ozone,
  dust_layer,
  troposphere,
  stratosphere,
  cloud,
  cirrus,
  free_troposphere,
  oxygen_pairs,
  nitrogen_dioxide,
  absorbers  ///< their number
};
using Amounts = std::array<double, absorbers>;

/// Names of the absorbers, one word each.
std::array<std::string_view, absorbers> absorber_names();

/// Whether a column has an absorber.
bool has(const Column& column, Absorber absorber);

/// Profile of one absorber at an altitude; 0 where the column has none.
double profile(const Column& column, Absorber absorber, double altitude_m);

/// The profiles at an altitude: air's density ratio; ozone's and the troposphere's aerosol's share
/// of their vertical column [m⁻¹]; 1 within the dust layer; the extinction by stratospheric aerosol
/// at 550 nm, the profile of cloud's chance; extinction by cirrus and by the free troposphere's aerosol at
/// 550 nm [m⁻¹]; the square of the density ratio, for pairs of oxygen; nitrogen dioxide [m⁻³].
Amounts profiles(const Column& column, double altitude_m);

/// The spectra: what each amount is multiplied with to make extinction [m⁻¹] or optical depth.
/// Ozone counts only along the path, not as a filter.
Amounts spectra(const Column& column, const Optics& optics);

/// Light scattered per steradian, over the light taken out of the ray, of each absorber.
///
///     ω P(χ) / (4π)        P = 3/4 (1 + cos² χ) for air, (1 − g²) / (1 + g² − 2 g cos χ)^3/2 for aerosol
///
/// (ω, g) = (1, 0.685) for background sulphuric acid, (0.947, 0.698) aged volcanic and dust, (0.855,
/// 0.747) fresh volcanic, (0.963, 0.651) tropospheric aerosol.
///
/// Given     cosine  cos χ, of the angle by which light turns
/// Returned  [1/sr]  0 for gases that absorb alone, and for cloud, which the twilight leaves out
/// Source    Henyey & Greenstein (1941), ApJ 93, 70; ω and g at 550 nm of LOWTRAN 7: Kneizys et al.
///           (1988), AFGL-TR-88-0177
Amounts scattering(const Column& column, double cosine);

double product(const Amounts& a, const Amounts& b);

/// The altitudes where the slope of a column's profiles jumps [m], lowest first, its top the last.
std::vector<double> breaks_m(const Column& column);

/// ρ/ρ₀ and its slope.
ValueAndSlope density_ratio(const Column& column, double altitude_m);

/// n(h, λ) − 1: the sea-level refractivity times the density ratio (Gladstone–Dale).
double refractivity(const Column& column, const Optics& optics, double altitude_m);

/// Refractivity n₀ − 1 at sea level from which on light can go round within the air: over the ground
/// n r, which has to rise for a ray to leave again, falls.
///
///     n₀ − 1 = −1 / (ρ/ρ₀ + R d(ρ/ρ₀)/dh)     on the ground, where density falls fastest
///
/// Given     earth_radius_m  R, of the ground's curvature along the path
/// Returned  1.636e-3 over R = 6378 km, six times that of air; infinite where light goes straight
double critical_refractivity(const Column& column, double earth_radius_m);

/// Throws Error when light could not leave the air: names its refractivity and what is allowed.
void require_no_trap(const Column& column, double earth_radius_m, double refractivity);

/// Extinction [m⁻¹] at an altitude.
double extinction_per_m(const Column& column, const Optics& optics, double altitude_m);

/// Transmittance, 0 to 1, of cloud and (where it is a filter) of ozone, for light that passed the
/// limb.
///
/// Given  tangent_height_m  the lowest altitude of its path
double limb_filter(const Column& column, const Optics& optics, double tangent_height_m);

/// Rayleigh optical depth of the whole air above sea level, straight up.
double vertical_rayleigh_optical_depth(const Optics& optics);

}  // namespace coppermoon::atmosphere
