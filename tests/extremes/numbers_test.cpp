// SPDX-License-Identifier: MIT
// Rays pushed over every edge: where they graze, how they are stepped, what the air is made of.
#include <glm/geometric.hpp>

#include "atmosphere/presets.h"
#include "extremes/worst.h"
#include "photons/bending.h"
#include "photons/photon.h"
#include "photons/trace.h"
#include "support/testing.h"

namespace coppermoon::extremes::numbers_test {

using atmosphere::Column;
using atmosphere::Density;
using photons::LimbPath;

constexpr double radius_m = 6.378e6;
constexpr double green = 2.770936e-4;  // n₀ − 1 at 550 nm
const atmosphere::Optics green_optics = atmosphere::sea_level_optics(algebra::nanometres(550));

Column full_column() { return atmosphere::preset("undated", {}).column; }

/// limb_path's integrals by midpoints over √(h − h_t), break by break, crowded above each.
LimbPath by_midpoints(const Column& column, double tangent_m, double refractivity) {
  constexpr int points = 20'000;
  const auto excess = [&](double h) {
    return refractivity * density_ratio(column, h).value * (radius_m + h);
  };
  const double at_tangent = excess(tangent_m), b = radius_m + tangent_m + at_tangent;
  LimbPath path{tangent_m, tangent_m + at_tangent, 0, {}};
  double from_m = tangent_m, over_from = 0;
  for (const double to_m : atmosphere::breaks_m(column)) {
    if (to_m <= from_m) continue;
    const auto rise = [&](double h, const atmosphere::ValueAndSlope& density) {  // of n r
      return 1 + refractivity * (density.value + density.slope_per_m * (radius_m + h));
    };
    const double u0 = std::sqrt(from_m - tangent_m), width = std::sqrt(to_m - tangent_m) - u0;
    for (int i = 0; i < points; ++i) {
      const double t = (i + 0.5) / points, u = u0 + width * t * t, h = tangent_m + u * u;
      const auto density = density_ratio(column, h);
      const double n = 1 + refractivity * density.value;
      const double over_b = u * u > 1e-3 ? u * u + (excess(h) - at_tangent)
                                         : over_from + (u * u - u0 * u0) * rise(h, density);
      const double dh = 4 * u * width * t / points, root = std::sqrt(over_b * (2 * b + over_b));
      path.bending_rad -= 2 * b * refractivity * density.slope_per_m / (n * root) * dh;
      path.amounts[atmosphere::air] += 2 * density.value * n * (radius_m + h) / root * dh;
    }
    const double middle_m = from_m + (to_m - from_m) / 2;
    over_from += (to_m - from_m) * rise(middle_m, density_ratio(column, middle_m));
    from_m = to_m;
  }
  return path;
}

LimbPath exact(const Column& column, double h, double refractivity = green) {
  return photons::limb_path(h, radius_m, column, refractivity);
}

struct Place {
  const char* name;
  Density density;
  double height_m;
  bool above, below;  ///< there is air on that side
  double bound;
  const char* reason;
};

constexpr auto smooth = "1e-8 as limb_path states, 20 000 midpoints a layer leave 1e-8 more";
constexpr auto rounded = "altitudes are rounded to 7e-12 m, the micrometre under the top to 1e-5";

const std::array<Place, 7> places{
    {{"the ground", Density::us_1976, 0, true, false, 2e-8, smooth},
     {"a cloud deck at 10 km", Density::us_1976, 10e3, true, true, 2e-8, smooth},
     {"the tropopause", Density::us_1976, 11019.067832, true, true, 2e-8, smooth},
     {"the stratosphere's break at 20 km", Density::us_1976, 20063.123682, true, true, 2e-8,
      smooth},
     {"the taper's corner at 39 km", Density::yapo_cutler, 39e3, true, true, 2e-8, smooth},
     {"the taper's end at 42 km", Density::yapo_cutler, 42e3, false, true, 1e-4, rounded},
     {"the top at 86 km", Density::us_1976, 86e3, false, true, 0.06,
      "US 1976 ends somewhat under its top: of 4e-9 rad, in the last metre"}}};

TEST(Rays, ThatGrazeASingularPlaceAreTheIndependentIntegral) {
  for (const auto& place : places) {
    const Column column{.density = place.density};
    Worst worst;
    for (const double away_m : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.})
      for (const double side : {-1., 1.}) {
        if (side < 0 ? !place.below : !place.above) continue;
        const double h = place.height_m + side * away_m;
        const auto path = exact(column, h), other = by_midpoints(column, h, green);
        worst.see_relative(path.bending_rad, other.bending_rad);
        worst.see_relative(path.amounts[atmosphere::air], other.amounts[atmosphere::air]);
      }
    holds(fmt::format("rays 1 um to 1 m from {}", place.name), "bending and air, over themselves",
          place.bound, worst, place.reason);
  }
}

/// Just under a jump of the density's slope from s₋ to s₊, with κ = d(n r)/dr on either side:
///
///     δ(h − d) − δ(h) = −2 √(2 b) (n₀ − 1)/n √(κ₋ d) (s₋/κ₋ − s₊/κ₊)
double square_root_of_a_break(const Column& column, double at_m, double below_m) {
  const auto side = [&](double h) {
    const auto density = density_ratio(column, h);
    const double kappa = 1 + green * (density.value + density.slope_per_m * (radius_m + h));
    return std::pair(density.slope_per_m, kappa);
  };
  const auto [slope_below, kappa_below] = side(at_m - 1e-6);
  const auto [slope_above, kappa_above] = side(at_m + 1e-6);
  const double n = 1 + green * density_ratio(column, at_m).value, b = n * (radius_m + at_m);
  return -2 * std::sqrt(2 * b) * green / n * std::sqrt(kappa_below * below_m) *
         (slope_below / kappa_below - slope_above / kappa_above);
}

TEST(Rays, UnderABreakOfTheSlopeBendByTheSquareRootOfTheDepth) {
  for (const double at_m : {11019.067832, 20063.123682, 32161.9, 39e3}) {
    const Column column{};
    const double edge_m = [&] {
      const auto all = atmosphere::breaks_m(column);
      return *std::ranges::min_element(all, {}, [&](double h) { return std::abs(h - at_m); });
    }();
    Worst worst;
    for (const double below_m : {1e-7, 1e-6, 1e-5, 1e-4, 1e-3})
      worst.see_relative(
          exact(column, edge_m - below_m).bending_rad - exact(column, edge_m).bending_rad,
          square_root_of_a_break(column, edge_m, below_m));
    holds(fmt::format("rays 0.1 um to 1 mm under the slope's break at {:.0f} m", edge_m),
          "bending beyond that on the break, over the closed form", 0.02, worst,
          "the smooth part is 1 mm over H of the bending, a hundredth of the root's");
  }
}

TEST(Rays, OfTheCloudDeckAreCutByTheCoverThereAndNowhereElse) {
  Column column = full_column();
  const auto ray = [&](double tangent_m, double cover) {
    column.cloud_cover = cover;
    const double b = exact(column, tangent_m, green_optics.refractivity).impact_height_m;
    return photons::limb_ray(b, radius_m, column, green_optics)->transmittance;
  };
  Worst clouded, clear, step;
  for (const double cover : {0., 1e-12, 0.3, 1 - 1e-12, 1.}) {
    for (const double away_m : {1e-6, 1e-4, 1e-2, 1.}) {
      const double under = ray(10e3 - away_m, cover), over = ray(10e3 + away_m, cover);
      clouded.see(std::abs(under - (1 - cover) * ray(10e3 - away_m, 0)));
      clear.see(std::abs(over - ray(10e3 + away_m, 0)));
      step.see(std::abs(ray(10e3 - away_m, 0) / ray(10e3 + away_m, 0) - 1) / away_m);
    }
  }
  holds("cloud cover 0 to 1, 1 um to 1 m under its top", "the clear ray times 1 - cover", 1e-15,
        clouded, "rounding");
  holds("the same above its top", "the clear ray", 0, clear, "nothing of the cloud is there");
  holds("the deck without cover", "a ray under it over one above it, less 1, per metre", 2e-3, step,
        "optical depth falls by 2.8 in 3 km, and 1 um is 1e-6 of altitudes rounded to 1e-9");
}

constexpr double us_1976_scale_height_m = 288.15 / (34.163195e-3 - 6.5e-3);  // at sea level

TEST(Air, ThatBendsAsTheEarthDoesIsRefusedFromTheClosedFormOn) {
  // In air of ρ = exp(−h/H), n r falls where (n₀ − 1) (r/H − 1) > 1.
  Worst worst;
  for (const double r : {1e6, radius_m, 1e7, 6.378e7})
    for (const auto density : {Density::us_1976, Density::yapo_cutler})
      worst.see_relative(atmosphere::critical_refractivity({.density = density}, r),
                         1 / (r / us_1976_scale_height_m - 1));
  holds("refractivity at which light goes round, radii 1000 to 63 780 km",
        "that of exponential air, over itself", 1e-7, worst,
        "the standard prints its constants to eight digits");
  const double critical = atmosphere::critical_refractivity({}, radius_m);
  is_refused("n - 1 just over that: a ray followed exactly",
             [&] { exact({}, 20e3, critical * 1.001); });
  auto optics = green_optics;
  optics.refractivity = critical * 1.001;
  is_refused("... found by its impact height",
             [&] { photons::limb_ray(20e3, radius_m, {}, optics); });
  const photons::Ray ray{{radius_m + 1e3, 0, -8e5}, {0, 0, 1}};
  is_refused("... stepped",
             [&] { trace(*photons::entered(ray, radius_m + 42e3), {}, optics, {}); });
  is_refused("air at 15 degrees about an Earth ten times as large",
             [] { photons::limb_path(0, 10 * radius_m, {}, green); });
  EXPECT_EQ(atmosphere::critical_refractivity({.refraction = false}, radius_m),
            std::numeric_limits<double>::infinity());
  EXPECT_GT(atmosphere::critical_refractivity({}, 1e7), 1e-3) << "all ordinary air";
}

TEST(Air, ThatBendsLittleBendsInProportion) {
  EXPECT_EQ(exact({}, 0, 0).bending_rad, 0);
  Worst flat;
  for (const double h : {0., 5e3, 20e3, 41e3})
    for (const double part : {1e-3, 1e-6, 1e-12})
      flat.see(std::abs(exact({}, h, green * part).bending_rad /
                            (part * 1e3 * exact({}, h, green * 1e-3).bending_rad) -
                        1));
  holds("n - 1 from 1e-3 of air's to 1e-12", "bending in proportion, over itself", 3e-4, flat,
        "1e-3 of what the critical refractivity is to air's, 0.17, in the second order");
}

TEST(Air, ThatAllButTrapsLightLetsItOut) {
  Worst worst;
  const double critical = atmosphere::critical_refractivity({}, radius_m);
  for (const double part : {0.5, 0.9, 0.99, 0.999})
    for (const double h : {0., 1e-3, 1., 1e3, 11e3, 41e3}) {
      const auto path = exact({}, h, critical * part), other = by_midpoints({}, h, critical * part);
      worst.see_relative(path.bending_rad, other.bending_rad);
      auto optics = green_optics;
      optics.refractivity = critical * part;
      const auto found = photons::limb_ray(path.impact_height_m, radius_m, {}, optics);
      ASSERT_TRUE(found) << part << " " << h;
      worst.see(std::abs(found->tangent_height_m - h) * (1 - part) * 1e-3);
    }
  holds("n - 1 at 0.5 to 0.999 of what traps light", "bending, over itself; heights found", 1e-5,
        worst, "at 0.999 n r - b is a thousandth of h - h_t in the lowest 10 m, 16 points a piece");
}

/// A ray of that impact height, followed to the letter.
double literal_bending(double impact_m, const photons::Stepping& stepping) {
  const photons::Ray far{{radius_m + impact_m, 0, -1e8}, {0, 0, 1}};
  const auto out = trace(*photons::entered(far, radius_m + 42e3), {}, green_optics, stepping);
  if (!out) return std::numeric_limits<double>::quiet_NaN();
  return std::atan2(-out->leaving.direction.x, out->leaving.direction.z);
}

TEST(LiteralRays, HaveAnErrorThatFallsWithTheStep) {
  Worst over_law;
  for (const double step_m : {1., 10., 100., 1e3, 1e4})
    for (const double h : {1e3, 20e3}) {
      const auto path = exact({}, h, green_optics.refractivity);
      over_law.see(
          std::abs(literal_bending(path.impact_height_m, {step_m, 0.1}) / path.bending_rad - 1) /
          (2e-3 * step_m / 1e3 + 1e-5));
    }
  holds("rays stepped literally by 1 m to 10 km", "bending's error over 2e-3 step/km + 1e-5", 1,
        over_law, "first order; differences of 0.1 m");
  for (const double h : {1e3, 10e3, 20e3, 41e3})
    EXPECT_TRUE(std::isfinite(
        literal_bending(exact({}, h, green_optics.refractivity).impact_height_m, {1e5, 10})))
        << h;
  tried("rays stepped literally by 100 km", "they leave, finite");
  is_refused("a step of 0.5 m", [] { literal_bending(2e3, {0.5, 10}); });
  is_refused("a step of 101 km", [] { literal_bending(2e3, {1.01e5, 10}); });
  is_refused("a gradient over 0 m", [] { literal_bending(2e3, {1e3, 0}); });
}

TEST(Rays, OfOpticalDepthsFrom1em12To1e6DimByBeerAndLambert) {
  const double b0 = radius_m + 10e3, top = radius_m + 20e3;
  const double metres = 2 * std::sqrt((top - b0) * (top + b0));
  Worst depth, light;
  for (double expected = 1e-12; expected < 2e6; expected *= 10) {
    const Column dust{.refraction = false,
                      .rayleigh = false,
                      .dust_extinction_per_m = expected / metres,
                      .dust_bottom_m = 10e3 - 1};
    const auto ray = photons::limb_ray(10e3, radius_m, dust, green_optics);
    depth.see_relative(ray->optical_depth, expected);
    light.see(std::abs(ray->transmittance - std::exp(-ray->optical_depth)));
    EXPECT_TRUE(ray->transmittance >= 0 && ray->transmittance <= 1);
  }
  holds("dust of optical depth 1e-12 to 1e6", "that of the straight chord, over itself", 1e-9,
        depth, "the break a metre below the ray");
  holds("the same", "exp(-depth), 0 at last and never no number", 0, light, "the same expression");
}

TEST(Rays, CrossOzoneAndAerosolInProportionToTheirColumns) {
  Worst worst;
  const auto depth_of = [](const Column& column) {
    return photons::limb_ray(12e3, radius_m, column, green_optics)->optical_depth;
  };
  const Column none{.density = Density::us_1976, .rayleigh = false};
  for (double part = 1e-12; part < 2e4; part *= 10) {
    Column ozone = none, troposphere = none;
    ozone.ozone_path = atmosphere::OzonePath::bent;
    ozone.ozone_du = part;
    troposphere.tropospheric_optical_depth = part;
    const double first = depth_of(ozone), second = depth_of(troposphere);
    ozone.ozone_du = troposphere.tropospheric_optical_depth = 1;
    worst.see_relative(first / part, depth_of(ozone));
    worst.see_relative(second / part, depth_of(troposphere));
  }
  holds("ozone of 1e-12 to 1e4 DU, tropospheric aerosol of 1e-12 to 1e4", "in proportion", 1e-13,
        worst, "rounding");
}

TEST(Optics, AreThoseOfTheFormulasUpToTheirLastWavelengthAndNoFarther) {
  Worst worst;
  for (const double nm : {380., std::nextafter(380., 400.), std::nextafter(780., 700.), 780.}) {
    const auto optics = atmosphere::sea_level_optics(algebra::nanometres(nm));
    worst.see_relative(optics.refractivity,
                       2.72643e-4 + 1.2288 / (nm * nm) + 3.555e4 / std::pow(nm, 4));
    for (const auto& extinction : spectra(full_column(), optics))
      EXPECT_TRUE(std::isfinite(extinction) && extinction >= 0) << nm;
  }
  holds("380 and 780 nm, and their neighbours", "refractivity, over itself", 1e-15, worst,
        "rounding");
  for (const double nm : {std::nextafter(380., 0.), std::nextafter(780., 800.)})
    is_refused(fmt::format("{:.17g} nm", nm),
               [&] { atmosphere::sea_level_optics(algebra::nanometres(nm)); });
}

TEST(Rays, AreRefusedBelowTheGroundAndStraightAboveTheAir) {
  is_refused("a ray that grazes under the ground", [] { exact({}, -1e-9); });
  is_refused("a ray that grazes nowhere",
             [] { exact({}, std::numeric_limits<double>::quiet_NaN()); });
  for (const double h : {42e3, std::nextafter(42e3, 1e6), 86e3, 1e7}) {
    EXPECT_EQ(exact({}, h).bending_rad, 0) << h;
    EXPECT_EQ(exact({}, h).impact_height_m, h);
  }
  tried("rays on the top of the air and above it", "go straight, to the last bit");
}

}  // namespace coppermoon::extremes::numbers_test
