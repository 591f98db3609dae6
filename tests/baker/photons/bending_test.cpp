// SPDX-License-Identifier: MIT
#include "photons/bending.h"

#include "atmosphere/density.h"
#include "atmosphere/ozone.h"
#include "atmosphere/presets.h"
#include "support/testing.h"

namespace coppermoon::photons::bending_test {

using algebra::nanometres;
using atmosphere::Atmosphere;
using atmosphere::Column;
using atmosphere::Optics;
using atmosphere::sea_level_optics;

constexpr double arcminute = std::numbers::pi / 180 / 60;
const Atmosphere air;
const double radius_m = air.earth.equatorial_radius_m;
const Optics green = sea_level_optics(nanometres(550));

/// A ray worked out another way: no derivative of n, the midpoint rule, nothing known of where the
/// air breaks.
struct Independent {
  Optics optics;
  double impact_height_m;
  double b_m = radius_m + impact_height_m;
  double tangent_m = tangent_height();

  /// (n − 1) r
  double optical_excess(double h) const {
    return refractivity(air.column, optics, h) * (radius_m + h);
  }
  double tangent_height() const {
    double h = impact_height_m;
    for (int i = 0; i < 200; ++i) h = impact_height_m - optical_excess(h);  // n r = b; slope < 0.2
    return h;
  }
  /// ∫ f(h) / √(n²r² − b²) dh from the tangent height to the top, over u = √(h − h_t).
  double along_half(const std::function<double(double)>& f) const {
    constexpr int points = 100'000;
    const double width = std::sqrt(air.top_m() - tangent_m) / points;
    double sum = 0;
    for (int i = 0; i < points; ++i) {
      const double u = (i + 0.5) * width, h = tangent_m + u * u;
      const double excess = u * u + optical_excess(h) - optical_excess(tangent_m);  // n r − b
      sum += f(h) * 2 * u / std::sqrt(excess * (excess + 2 * b_m));
    }
    return sum * width;
  }
  /// The angle the ray sweeps about the Earth's centre inside the air, over what a straight line
  /// sweeps.
  double bending() const {
    const double swept = along_half([&](double h) { return b_m / (radius_m + h); });
    return 2 * swept - 2 * std::acos(b_m / air.top_radius_m());
  }
  double optical_depth() const {
    return 2 * along_half([&](double h) {
             return extinction_per_m(air.column, optics, h) * (radius_m + h + optical_excess(h));
           });
  }
};

LimbRay ray_at(double impact_height_m, const Column& column = {}, const Optics& optics = green) {
  const auto ray = limb_ray(impact_height_m, radius_m, column, optics);
  if (!ray) throw algebra::Error("the ray meets the ground");
  return *ray;
}

struct Printed {
  double impact_height_m, tangent_height_m, bending_arcmin, optical_depth, bending_tolerance;
};

// A table computed elsewhere for 550 nm. Its quadrature did not split where the density's slope
// breaks, which puts its bending off by up to 3.6e-4 against the swept angle below; its optical
// depths hold no slope.
constexpr Printed printed[] = {{2500, 876.4, 60.807, 6.6729, 1.5e-4},
                               {5000, 3790.9, 46.189, 4.7152, 4e-4},
                               {10000, 9353.3, 26.334, 2.26635, 3e-5},
                               {20000, 19868.7, 5.6940, 0.42626, 3e-5},
                               {30000, 29973.2, 1.1517, 0.08196, 4e-4}};

TEST(LimbRay, IsThatOfATableComputedElsewhere) {
  for (const auto& row : printed) {
    const auto ray = ray_at(row.impact_height_m);
    EXPECT_WITHIN(ray.tangent_height_m, row.tangent_height_m, 0.06, "printed to 0.1 m");
    EXPECT_WITHIN_RELATIVE(ray.bending_rad / arcminute, row.bending_arcmin, row.bending_tolerance,
                           "that table's quadrature, see above; else 5 digits");
    EXPECT_WITHIN_RELATIVE(ray.optical_depth, row.optical_depth, 1e-4, "printed to 4 or 5 digits");
  }
}

void expect_the_swept_angle(double impact_height_m, double nm) {
  const Independent other{sea_level_optics(nanometres(nm)), impact_height_m};
  const auto ray = ray_at(impact_height_m, {}, other.optics);
  constexpr auto reason = "1e-8 is what the documentation states";
  EXPECT_WITHIN(ray.tangent_height_m, other.tangent_m, 1e-7, "rounding");
  EXPECT_WITHIN_RELATIVE(ray.bending_rad, other.bending(), 1e-8, reason) << impact_height_m;
  EXPECT_WITHIN_RELATIVE(ray.optical_depth, other.optical_depth(), 1e-8, reason) << impact_height_m;
}

TEST(LimbRay, IsThatOfTheSweptAngle) {
  for (const double impact_height_m : {2500.0, 5000.0, 10e3, 20e3, 30e3, 38e3, 41e3})
    for (const double nm : {380.0, 780.0}) expect_the_swept_angle(impact_height_m, nm);
}

// At 380 nm a ray of b − R = 11554 m grazes 2.1 m below the tropopause, one of 40 999.1 m in the
// ramp.
TEST(LimbRay, IsThatOfTheSweptAngleJustBelowABreakOfTheAir) {
  expect_the_swept_angle(11554, 380);
  expect_the_swept_angle(20186, 780);
  expect_the_swept_angle(39006.5, 550);
}

// Nautical and astronomical almanacs refract the Sun on the horizon by 34'; a ray that grazes the
// ground and leaves again is bent twice as much. At sea level b = n₀ R.
TEST(LimbRay, GrazingTheGroundIsBentTwiceTheRefractionOfTheHorizon) {
  const double grazing_m = green.refractivity * radius_m;
  const auto ray = ray_at(grazing_m + 1e-6);
  EXPECT_WITHIN(ray.tangent_height_m, 0.0, 1e-5, "n r rises by 0.8 for every metre of altitude");
  EXPECT_WITHIN(ray.bending_rad / arcminute, 2 * 34.0, 2 * 2.0,
                "almanacs round to 1' and assume 10 °C; 15 °C refracts 2 % less");
  EXPECT_FALSE(limb_ray(grazing_m - 1e-6, radius_m, {}, green));
}

// Under the top dn/dr is all but constant, so δ ∝ ∫ dr/√(r − r_t) ∝ √(r₁ − r_t).
TEST(LimbRay, FadesAsTheSquareRootOfDepthUnderTheTop) {
  for (const double depth_m : {1e-6, 1e-4, 1e-2, 1.0})
    EXPECT_WITHIN(ray_at(42e3 - 4 * depth_m).bending_rad / ray_at(42e3 - depth_m).bending_rad, 2.0,
                  2e-3, "metres of a ramp of 3 km");
  const auto top = ray_at(42e3);
  EXPECT_EQ(top.bending_rad, 0);
  EXPECT_EQ(top.optical_depth, 0);
  EXPECT_EQ(top.transmittance, 1);
}

TEST(LimbRay, IsFiniteOverTheWholeRange) {
  const Column full{.ozone_du = 300, .dust_extinction_per_m = 1e-5};
  for (const double nm : {380.0, 780.0}) {
    const auto optics = sea_level_optics(nanometres(nm));
    for (double h = -1e4; h <= 42e3; h += 6.5)
      if (const auto ray = limb_ray(h, radius_m, full, optics)) {
        ASSERT_GE(h, optics.refractivity * radius_m);
        ASSERT_TRUE(ray->bending_rad >= 0 && ray->bending_rad < 75 * arcminute) << h;
        ASSERT_TRUE(ray->optical_depth >= 0 && std::isfinite(ray->optical_depth)) << h;
        ASSERT_TRUE(ray->transmittance > 0 && ray->transmittance <= 1) << h;
        ASSERT_TRUE(ray->tangent_height_m >= 0 && ray->tangent_height_m <= h) << h;
      }
  }
}

double impact_height_of(double tangent_m) {
  return tangent_m + refractivity({}, green, tangent_m) * (radius_m + tangent_m);
}

TEST(LimbRay, LosesNothingOfASliverOfAirBelowABreak) {
  for (const double h : {11019.067832, 20063.123682, 39e3}) {
    const Independent other{green, impact_height_of(h - 5e-4)};
    EXPECT_WITHIN_RELATIVE(ray_at(other.impact_height_m).bending_rad, other.bending(), 1e-6,
                           "the midpoint rule has forty points in the sliver");
  }
}

/// A ray that grazes d below a break differs from one that grazes the break by the other slope of the air in d, as √d.
TEST(LimbPath, KnowsABreakSixRoundingsAboveIt) {
  const Column column{.density = atmosphere::Density::us_1976};
  const auto breaks = atmosphere::breaks_m(column);
  const double break_m = *std::ranges::lower_bound(breaks, 11e3);  // the tropopause
  const auto bending = [&](double h) {
    return limb_path(h, radius_m, column, green.refractivity).bending_rad;
  };
  const auto over_root = [&](double below_m) {
    const double h = break_m - below_m;
    return (bending(h) - bending(break_m)) / std::sqrt(break_m - h);
  };
  for (const double below_m : {1.2e-11, 1e-9, 1e-7})
    EXPECT_WITHIN_RELATIVE(over_root(below_m), over_root(1e-5), 0.1, "heights are rounded by d/6");
}

TEST(LimbRay, IsFiniteAndContinuousAtEveryBreakOfTheAir) {
  for (const double h : atmosphere::density_breaks_m())
    for (const double above_m : {-1e-3, -1e-6, -1e-9, -1e-11, 0.0, 1e-11, 1e-9, 1e-6, 1e-3}) {
      const double at_m = std::min(impact_height_of(h + above_m), 42e3);
      EXPECT_WITHIN(ray_at(at_m).bending_rad, ray_at(at_m - 0.01).bending_rad, 0.01 * arcminute,
                    "a centimetre of air: at the tropopause the bending drops by 0.007' within");
    }
}

// A straight line crosses a shell in 2 (√(r₂² − b²) − √(r₁² − b²)).
TEST(LimbRay, WithoutRefractionGoesStraightThroughTheDust) {
  const Column dust{.refraction = false, .rayleigh = false, .dust_extinction_per_m = 4.7e-6};
  const auto half_chord = [](double top_m, double b_m) {
    const double r = radius_m + top_m, b = radius_m + b_m;
    return std::sqrt((r - b) * (r + b));
  };
  const auto below = ray_at(5000, dust), inside = ray_at(17e3, dust), above = ray_at(21e3, dust);
  EXPECT_EQ(below.bending_rad, 0);
  EXPECT_WITHIN(below.tangent_height_m, 5000.0, 1e-8, "rounding");
  EXPECT_WITHIN_RELATIVE(below.optical_depth,
                         2 * 4.7e-6 * (half_chord(20e3, 5000) - half_chord(15e3, 5000)), 1e-10,
                         "rounding");
  EXPECT_WITHIN_RELATIVE(inside.optical_depth, 2 * 4.7e-6 * half_chord(20e3, 17e3), 1e-10,
                         "rounding");
  EXPECT_EQ(above.optical_depth, 0);
}

TEST(LimbRay, DimsByBeerLambertAndTheOzoneFilter) {
  const Column ozone{.ozone_du = 300};
  const auto clear = ray_at(15e3), filtered = ray_at(15e3, ozone);
  EXPECT_WITHIN(clear.transmittance, std::exp(-clear.optical_depth), 1e-15, "rounding");
  EXPECT_WITHIN(filtered.transmittance / clear.transmittance, limb_filter(ozone, green, 15e3),
                1e-14, "rounding");
}

// US 1976 goes on to 86 km; an exponential tail of scale height H above 42 km bends and dims by
// √(2πR/H) of what it stands for.
TEST(LimbRay, ReachesTheTopOfUs1976) {
  const Column full{.density = atmosphere::Density::us_1976};
  EXPECT_EQ(ray_at(86e3, full).optical_depth, 0);
  const double h = 50e3, scale_m = 8e3, density = atmosphere::density_ratio_us_1976(h);
  EXPECT_WITHIN_RELATIVE(
      ray_at(h, full).optical_depth,
      green.rayleigh_per_m * density * std::sqrt(2 * std::numbers::pi * (radius_m + h) * scale_m),
      0.03, "the scale height at 50 km is 8.0 km and falls by 5 % in 10 km");
}

TEST(LimbRay, CrossesTheOzoneOnItsOwnPath) {
  const Column path{.density = atmosphere::Density::us_1976,
                    .refraction = false,
                    .rayleigh = false,
                    .ozone_du = 300,
                    .ozone_path = atmosphere::OzonePath::bent};
  const auto amount = [&](double h) {  // over the vertical column
    return limb_path(h, radius_m, path, 0).amounts[atmosphere::ozone];
  };
  // Straight lines, by the midpoint rule along the path.
  const auto along_the_line = [&](double h) {
    constexpr double step_m = 100;
    double sum = 0;
    for (double s = step_m / 2; s < 1.2e6; s += step_m)
      sum += 2 * step_m * atmosphere::ozone_profile_per_m(std::hypot(radius_m + h, s) - radius_m);
    return sum;
  };
  for (const double h : {0., 20e3, 40e3})
    EXPECT_WITHIN_RELATIVE(amount(h), along_the_line(h), 1e-4,
                           "the profile's second derivative jumps every 2 km");
  EXPECT_WITHIN(amount(0), 24.1, 4, "a thin layer at 22 km: the filter's air mass");
}

// limb_path's integrals by midpoints, which knees in the profiles do not disturb.
atmosphere::Amounts amounts_by_midpoints(const Column& column, double tangent_m,
                                         int points = 400'000) {
  const auto excess = [&](double h) { return refractivity(column, green, h) * (radius_m + h); };
  const double at_tangent = excess(tangent_m);
  const double width = std::sqrt(atmosphere::top_m(column) - tangent_m) / points;
  atmosphere::Amounts sums{};
  for (int i = 0; i < points; ++i) {
    const double u = (i + 0.5) * width, h = tangent_m + u * u, nr = radius_m + h + excess(h);
    const double over_b = u * u + excess(h) - at_tangent;  // n r − b
    const double ds = nr / std::sqrt(over_b * (2 * nr - over_b)) * 4 * u * width;
    const auto profiles = atmosphere::profiles(column, h);
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += profiles[k] * ds;
  }
  return sums;
}

void expect_stated_amounts(const Column& column, double of_the_stratosphere) {
  constexpr auto reason = "as the header says";
  const auto spectra = atmosphere::spectra(column, green);
  for (const double h : {37., 2500., 5000., 7319., 8643., 12e3, 16256., 22e3, 24862., 29e3}) {
    const auto exact = amounts_by_midpoints(column, h);
    const auto amounts = limb_path(h, radius_m, column, green.refractivity).amounts;
    for (const auto k : {atmosphere::air, atmosphere::troposphere})
      EXPECT_WITHIN_RELATIVE(amounts[k], exact[k], 1e-8, reason) << h;
    EXPECT_WITHIN_RELATIVE(amounts[atmosphere::ozone], exact[atmosphere::ozone], 5e-5, reason) << h;
    EXPECT_WITHIN_RELATIVE(amounts[atmosphere::stratosphere], exact[atmosphere::stratosphere],
                           of_the_stratosphere, reason)
        << h;
    const bool background = column.stratosphere == atmosphere::StratosphericAerosol::background;
    EXPECT_WITHIN_RELATIVE(atmosphere::product(amounts, spectra),
                           atmosphere::product(exact, spectra),
                           background ? 5e-5 : of_the_stratosphere, reason)
        << h;
  }
}

TEST(LimbRay, HasAirOzoneAndAerosolToWhatIsStated) {
  auto column = atmosphere::preset("undated", algebra::degrees(0)).column;
  expect_stated_amounts(column, 2e-4);
  column.stratosphere = atmosphere::StratosphericAerosol::moderate;
  expect_stated_amounts(column, 2e-4);
  column.stratosphere = atmosphere::StratosphericAerosol::extreme;
  expect_stated_amounts(column, 1e-3);
}

/// limb_path's integral of the bending, likewise.
double bending_by_midpoints(const Column& column, double tangent_m, int points) {
  const auto excess = [&](double h) { return refractivity(column, green, h) * (radius_m + h); };
  const double at_tangent = excess(tangent_m), b = radius_m + tangent_m + at_tangent;
  const double width = std::sqrt(atmosphere::top_m(column) - tangent_m) / points;
  double sum = 0;
  for (int i = 0; i < points; ++i) {
    const double u = (i + 0.5) * width, h = tangent_m + u * u, nr = radius_m + h + excess(h);
    const double over_b = u * u + excess(h) - at_tangent;  // n r − b
    const double slope = green.refractivity * atmosphere::density_ratio(column, h).slope_per_m;
    sum -= 2 * b * slope * (radius_m + h) / nr / std::sqrt(over_b * (nr + b)) * 2 * u * width;
  }
  return sum;
}

TEST(LimbPaths, AreThoseOfEachRefractivityAlone) {
  const auto belts = atmosphere::preset("standard", algebra::degrees(20), 2018.57).belts;
  const std::vector<double> refractivities{0, 2.7e-4, 2.78e-4, 2.9e-4};
  for (const auto& column : {air.column, belts[3].column}) {
    const ProfileTable table(column);
    const double edge_m = atmosphere::breaks_m(column).front();
    for (const double h : {0., 7319., edge_m - 1e-5, edge_m, 30e3, 90e3}) {
      const auto paths = limb_paths(h, radius_m, column, refractivities, &table);
      ASSERT_EQ(paths.size(), refractivities.size());
      for (std::size_t k = 0; k < paths.size(); ++k) {
        const auto one = limb_path(h, radius_m, column, refractivities[k], &table);
        EXPECT_EQ(paths[k].tangent_height_m, h);
        EXPECT_EQ(paths[k].impact_height_m, one.impact_height_m) << "the same sums, bit by bit";
        EXPECT_EQ(paths[k].bending_rad, one.bending_rad) << h << " m, " << k;
        EXPECT_EQ(paths[k].amounts, one.amounts) << h << " m, " << k;
      }
    }
  }
}

TEST(LimbRay, KnowsTheKneesOfAMonthsAir) {
  constexpr int points = 50'000;  // err by 1e-6 here
  const auto belts = atmosphere::preset("standard", algebra::degrees(20), 2018.57).belts;
  for (const auto& belt : {belts.front(), belts[belts.size() / 2], belts.back()}) {
    const auto& column = belt.column;
    const ProfileTable table(column);
    const auto spectra = atmosphere::spectra(column, green);
    for (const double h : {37., 7319., 12e3, 16256., 22e3, 29e3}) {
      const double bending = bending_by_midpoints(column, h, points),
                   depth = atmosphere::product(amounts_by_midpoints(column, h, points), spectra);
      for (const auto* profiles : {&table, static_cast<const ProfileTable*>(nullptr)}) {
        const auto path = limb_path(h, radius_m, column, green.refractivity, profiles);
        EXPECT_WITHIN_RELATIVE(path.bending_rad, bending, h < 25e3 ? 2e-5 : 2e-4,
                               "as the header says")
            << h << " m, " << belt.from_north_rad;
        EXPECT_WITHIN_RELATIVE(atmosphere::product(path.amounts, spectra), depth, 2e-4,
                               "as the header says")
            << h << " m, " << belt.from_north_rad;
      }
    }
  }
}

TEST(LimbRay, RefusesImpactHeightsOutsideItsRange) {
  EXPECT_THROW(limb_ray(42000.001, radius_m, {}, green), algebra::Error);
  EXPECT_THROW(limb_ray(-10000.1, radius_m, {}, green), algebra::Error);
  EXPECT_THROW(limb_ray(std::numeric_limits<double>::quiet_NaN(), radius_m, {}, green),
               algebra::Error);
}

}  // namespace coppermoon::photons::bending_test
