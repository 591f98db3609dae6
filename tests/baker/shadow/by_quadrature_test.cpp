// SPDX-License-Identifier: MIT
#include "shadow/by_quadrature.h"

#include <tbb/parallel_for.h>

#include "atmosphere/presets.h"
#include "baker/shadow/airs_in_belts.h"
#include "photons/bending.h"
#include "photons/limb_darkening.h"
#include "support/testing.h"

namespace coppermoon::shadow::by_quadrature_test {

const Arrangement february_2008{1.479e11, {3.83e8}};

std::vector<double> up_to(double last_m, double step_m) {
  std::vector<double> list;
  for (double x = 0; x <= last_m; x += step_m) list.push_back(x);
  return list;
}

atmosphere::Atmosphere straight_and_clear() {
  atmosphere::Atmosphere air;
  air.column.refraction = air.column.rayleigh = false;
  return air;
}

TEST(ByQuadrature, WithoutAirIsTheSunSeenThroughTheShellWhereItStood) {
  // Nothing bends, nothing dims: light through the ring is what the larger disc hides and the
  // smaller does not.
  const auto air = straight_and_clear();
  const auto distances = up_to(8.6e6, 1e5);
  const std::vector<double> waves{550};
  const auto light = by_quadrature(air, february_2008, waves, distances, {.rays = 1200});
  for (std::size_t d = 0; d < distances.size(); ++d) {
    const double z = february_2008.depths_m[0], sun = february_2008.sun_distance_m;
    const double ring = covered_part(distances[d], z, sun, air.top_radius_m()) -
                        covered_part(distances[d], z, sun, air.earth.equatorial_radius_m);
    EXPECT_WITHIN(light.ratio[0](d, 0), ring, 2e-6,
                  "1e-4 of a ring that is at most 1.4e-2 of the disc");
  }
}

/// ∫ E/E₀ dA over the plane is what enters the ring: (1 + z/D)² π (b₁² − b₀²), whatever bends on
/// the way.
TEST(ByQuadrature, KeepsTheEnergyThatEntersTheRing) {
  atmosphere::Atmosphere air;
  air.column.rayleigh = false;
  const std::vector<double> waves{450, 700};
  const auto distances = up_to(8.8e6, 1e4);
  const auto light = by_quadrature(air, february_2008, waves, distances);
  const double spread = 1 + february_2008.depths_m[0] / february_2008.sun_distance_m;
  for (std::size_t w = 0; w < waves.size(); ++w) {
    double flux = 0;
    for (std::size_t d = 0; d < distances.size(); ++d)
      flux += light.ratio[0](d, w) * 2 * std::numbers::pi * distances[d] * 1e4;
    const auto optics = atmosphere::sea_level_optics(algebra::nanometres(waves[w]));
    const double b0 = air.earth.equatorial_radius_m * (1 + optics.refractivity),
                 b1 = air.top_radius_m();
    const double entering = spread * spread * std::numbers::pi * (b1 * b1 - b0 * b0);
    EXPECT_WITHIN_RELATIVE(flux, entering, 2e-4, "10 km between the places summed over");
  }
}

/// A ray of light: where it lands, signed, and what it carries.
struct Ray {
  double landing_m, light;
};

/// The rays of one column, which crowd below the air's breaks as their square root does: no table.
std::vector<Ray> rays_of(const atmosphere::Column& column, const atmosphere::Atmosphere& air,
                         const Arrangement& arrangement, double nm, int rays) {
  const double radius = air.earth.equatorial_radius_m;
  const auto optics = atmosphere::sea_level_optics(algebra::nanometres(nm), air.molecules);
  const auto spectra = atmosphere::spectra(column, optics);
  std::vector<Ray> all;
  double low = 0;
  for (const double high : atmosphere::breaks_m(column)) {
    for (int i = 0; i < rays; ++i) {
      const double left = 1 - (i + 0.5) / rays, h = high - (high - low) * left * left;
      const auto path = photons::limb_path(h, radius, column, optics.refractivity);
      const auto density = density_ratio(column, h);
      const double stretched =  // db/dh
          1 + optics.refractivity * (density.value + density.slope_per_m * (radius + h));
      const double b = radius + path.impact_height_m,
                   db = stretched * (high - low) * 2 * left / rays;
      all.push_back(
          {landing_m(b, path.bending_rad, arrangement.sun_distance_m, arrangement.depths_m[0]),
           std::exp(-atmosphere::product(path.amounts, spectra)) * limb_filter(column, optics, h) *
               b * db});
    }
    low = high;
  }
  return all;
}

struct Spot {
  double gamma_m, theta_rad;
};

/// The same double integral, added up ray by ray and along each arc, by the columns' shares of the
/// limb that it comes from: no bins, no terms of the disc, no series.
std::vector<double> added_up(const atmosphere::Atmosphere& air, const Arrangement& arrangement,
                             double nm, const std::vector<Spot>& spots, int rays, int steps) {
  const double z = arrangement.depths_m[0], sun = arrangement.sun_distance_m,
               a = projected_solar_radius_m(arrangement, z), pi = std::numbers::pi;
  const auto columns = air.columns();
  std::vector<double> sums(spots.size());
  for (std::size_t c = 0; c < columns.size(); ++c)
    for (const auto& [landing, light] : rays_of(*columns[c], air, arrangement, nm, rays)) {
      const double r = std::abs(landing);
      for (std::size_t j = 0; j < spots.size(); ++j) {
        const double g = spots[j].gamma_m;
        if (std::abs(r - g) >= a) continue;
        const double half = r + g <= a ? pi : std::acos((g * g + r * r - a * a) / (2 * g * r));
        for (int k = 0; k < steps; ++k) {
          const double t = ((k + 0.5) / steps - 0.5) * pi, psi = half * std::sin(t);
          double share = 0;
          for (const auto& one : air.shares_at(spots[j].theta_rad + psi + (landing < 0 ? pi : 0)))
            if (one.column == c) share += one.share;
          if (share == 0) continue;
          const double out = (r * r + g * g - 2 * r * g * std::cos(psi)) / (a * a);
          const double shed = arrangement.limb_darkening
                                  ? photons::limb_darkening(algebra::nanometres(nm),
                                                            std::sqrt(std::max(0., 1 - out)))
                                  : 1;
          sums[j] += light * share * half * std::cos(t) * pi / steps * shed;
        }
      }
    }
  for (double& sum : sums) sum *= std::pow(1 + z / sun, 2) / (pi * a * a);
  return sums;
}

TEST(ByQuadrature, IsTheSumOverRaysAndArcs) {
  const auto air = atmosphere::preset("paper", algebra::degrees(10));
  auto arrangement = february_2008;
  arrangement.limb_darkening = true;
  const std::vector<double> gammas{1e6, 2.1e6, 3.5e6, 4.4e6};
  for (const double nm : {385., 550.}) {
    const auto sums =
        added_up(air, arrangement, nm, {{1e6, 0}, {2.1e6, 0}, {3.5e6, 0}, {4.4e6, 0}}, 1200, 120);
    const auto light = by_quadrature(air, arrangement, std::vector{nm}, gammas, {.rays = 1000});
    for (std::size_t j = 0; j < gammas.size(); ++j)
      EXPECT_WITHIN_RELATIVE(light.ratio[0](j, 0), sums[j], 1e-4,
                             "1200 rays between two breaks, added up: 6e-5 from 6000")
          << nm << " nm, " << gammas[j] << " m";
  }
}

/// Light of air that differs around the axis against the sums, at four of twelve position angles;
/// 120 degrees are 27 from a border at 147, as far as the Sun reaches at 4000 km.
void expect_the_sum_around(const atmosphere::Atmosphere& air, double tolerance, const char* why) {
  const std::vector<double> gammas{0.3e6, 1.5e6, 2.4e6, 4e6};
  const std::vector<std::size_t> sectors{1, 4, 5, 10};
  std::vector<Spot> spots;
  for (const double gamma : gammas)
    for (const auto s : sectors)
      spots.push_back({gamma, 2 * std::numbers::pi * static_cast<double>(s) / 12});
  const auto sums = added_up(air, february_2008, 600, spots, 300, 200);
  const auto light = by_quadrature(air, february_2008, std::vector<double>{600}, gammas,
                                   {.rays = 1000, .sectors = {12}});
  for (std::size_t g = 0; g < gammas.size(); ++g)
    for (std::size_t i = 0; i < sectors.size(); ++i)
      EXPECT_WITHIN_RELATIVE(light.ratio[sectors[i]](g, 0), sums[g * sectors.size() + i], tolerance,
                             why)
          << gammas[g] << " m, sector " << sectors[i];
}

TEST(ByQuadrature, OfThirteenBeltsIsTheSumOverRaysAndArcs) {
  auto air = atmosphere::preset("paper", algebra::degrees(10));
  air.earth = {};
  for (int i = 0; i < 13; ++i) {
    auto column = air.column;
    column.ozone_du = 100 + 30 * i;
    column.dust_extinction_per_m = i % 2 * 4e-6;
    air.belts.push_back({std::numbers::pi * i / 12, column});
  }
  expect_the_sum_around(air, 1e-3, "300 rays between two breaks, added up: sixteen times 6e-5");
}

TEST(ByQuadrature, OfARegionIsTheSumOverRaysAndArcs) {
  auto air = atmosphere::preset("paper", algebra::degrees(10));
  air.earth = {};
  auto column = air.column;
  column.dust_extinction_per_m = 2e-5;
  air.regions = {{algebra::degrees(33), algebra::degrees(147), column}};
  expect_the_sum_around(air, 2e-2, "as the header says of regions");
}

/// From north to south less of one column and more of another, by stripes of 15 degrees.
TEST(ByQuadrature, OfThinRegionsIsNearlyThatOfBelts) {
  auto belts = atmosphere::preset("paper", algebra::degrees(10));
  belts.earth = {};
  auto regions = belts, dusty = belts;
  dusty.column.dust_extinction_per_m = 4e-6;
  belts.belts = {{0, belts.column}, {std::numbers::pi, dusty.column}};
  for (int i = -12; i < 12; ++i) {
    const double middle = 15 * (i + 0.5), half = 7.5 * std::abs(middle) / 180;
    regions.regions.push_back(
        {algebra::degrees(middle - half), algebra::degrees(middle + half), dusty.column});
  }
  const std::vector<double> waves{600}, gammas{0.5e6, 1.5e6, 3e6};
  const auto straight = by_quadrature(belts, february_2008, waves, gammas, {.rays = 100}),
             striped = by_quadrature(regions, february_2008, waves, gammas, {.rays = 100});
  for (std::size_t s = 0; s < sectors_around; ++s)
    for (std::size_t g = 0; g < gammas.size(); ++g)
      EXPECT_WITHIN_RELATIVE(striped.ratio[s](g, 0), straight.ratio[s](g, 0), 0.02,
                             "stripes a fourth as wide as the Sun, seen from the axis, at 3000 km")
          << s << " " << gammas[g];
}

TEST(ByQuadrature, InSeveralAirsIsThatInEach) {
  const auto airs = airs_in_belts(std::array{0., 250., 500.}, std::array{0., 0.4, 1.});
  const std::vector<double> waves{450, 550, 600};
  const auto distances = up_to(8e6, 4e5);
  const auto together = by_quadrature_in(airs, february_2008, waves, distances);
  ASSERT_EQ(together.size(), airs.size());
  for (std::size_t i = 0; i < airs.size(); ++i) {
    const auto alone = by_quadrature(airs[i], february_2008, waves, distances);
    for (std::size_t s = 0; s < alone.sectors; s += 3)
      for (std::size_t d = 0; d < distances.size(); ++d)
        for (std::size_t w = 0; w < waves.size(); ++w)
          EXPECT_WITHIN(together[i].ratio[s](d, w), alone.ratio[s](d, w),
                        2 * (distances[d] <= 4.5e6 ? 1.3e-3 * alone.ratio[s](d, w) : 1e-5) + 1e-10,
                        "two times 300 rays at other heights, as the header says")
              << i << ": " << distances[d] << " m, " << waves[w] << " nm";
  }
}

TEST(ByQuadrature, RefusesAirsThatDifferInMoreThanAmounts) {
  auto airs = airs_in_belts(std::array{250.}, std::array{0.4, 1.});
  airs[1].belts[2].column.cloud_top_m = 5e3;
  const std::vector<double> waves{550};
  EXPECT_THROW(by_quadrature_in(airs, february_2008, waves, up_to(8e6, 4e6)), algebra::Error);
}

void expect_accuracy(const atmosphere::Atmosphere& air, bool limb_darkening, int rays, double worst,
                     double green) {
  const std::vector<double> waves{400, 450, 550, 650};
  const auto distances = up_to(8e6, 1e5);
  auto arrangement = february_2008;
  arrangement.limb_darkening = limb_darkening;
  const auto usual = by_quadrature(air, arrangement, waves, distances, {.rays = rays});
  const auto fine = by_quadrature(air, arrangement, waves, distances, {.rays = 8000});
  for (std::size_t s = 0; s < usual.sectors; s += 3)
    for (std::size_t d = 0; d < distances.size(); ++d)
      for (std::size_t w = 0; w < waves.size(); ++w) {
        const double exact = fine.ratio[s](d, w);
        const bool deep = distances[d] <= 4.5e6;
        EXPECT_WITHIN(usual.ratio[s](d, w), exact,
                      deep ? exact * (waves[w] < 550 ? worst : green) : 1e-5, "as the header says")
            << distances[d] << " m, " << waves[w] << " nm";
      }
}

TEST(ByQuadrature, ReachesItsAccuracyAtAThousandRays) {
  expect_accuracy({}, false, 1000, 1.5e-4, 8e-5);
}

TEST(ByQuadrature, ComputesOnlyTheSectorsAskedFor) {
  auto air = atmosphere::preset("paper", algebra::degrees(10));
  air.regions = {{algebra::degrees(20), algebra::degrees(100), {}}};
  const std::vector<double> waves{550};
  const auto distances = up_to(6e6, 1e6);
  const auto all = by_quadrature(air, february_2008, waves, distances);
  const auto some =
      by_quadrature(air, february_2008, waves, distances, {.sectors = {sectors_around, 22, 4}});
  for (std::size_t s = 0; s < sectors_around; ++s)
    for (std::size_t d = 0; d < distances.size(); ++d)
      EXPECT_EQ(some.ratio[s](d, 0), s >= 22 || s < 2 ? all.ratio[s](d, 0) : 0) << s;
}

TEST(ByQuadrature, OfFewerHarmonicsIsNearlyThatOfAllInBelts) {
  auto air = atmosphere::preset("paper", algebra::degrees(10));
  for (int i = 0; i < 13; ++i) {
    air.belts.push_back({std::numbers::pi * i / 12, air.column});
    air.belts.back().column.dust_extinction_per_m = i * 5e-7;
  }
  const std::vector<double> waves{550};
  const auto distances = up_to(4e6, 1e6);
  constexpr int rays = 768;  // whose light has 48
  const auto all = by_quadrature(air, february_2008, waves, distances, {.rays = rays});
  const auto fewer =
      by_quadrature(air, february_2008, waves, distances, {.rays = rays, .harmonics = 24});
  for (std::size_t s = 0; s < sectors_around; ++s)
    for (std::size_t d = 0; d < distances.size(); ++d)
      EXPECT_WITHIN_RELATIVE(fewer.ratio[s](d, 0), all.ratio[s](d, 0), 1e-3,
                             "belts are wider than 7.5 degrees; more beyond the umbra")
          << s << " " << distances[d];
  EXPECT_NE(fewer.ratio[3](4, 0), all.ratio[3](4, 0));
  EXPECT_THROW(by_quadrature(air, february_2008, waves, distances, {.harmonics = 1}),
               algebra::Error);
}

/// An ellipsoid's position angles come from two of them; air with a region has each computed.
TEST(ByQuadrature, OfAnEllipsoidIsTheSameByTwoPositionAnglesAsByEach) {
  atmosphere::Atmosphere air{.earth = atmosphere::ellipsoid(0.2)};
  auto each = air;
  each.regions = {{algebra::degrees(0), algebra::degrees(360), air.column}};
  const Arrangement arrangement{1.5e11, {3.8e8}};
  const std::vector<double> waves{600}, places{0.5e6, 3e6, 4.5e6, 4.65e6};
  const auto two = by_quadrature(air, arrangement, waves, places),
             all = by_quadrature(each, arrangement, waves, places);
  for (std::size_t s = 0; s < two.sectors; ++s)
    for (std::size_t d = 0; d < places.size(); ++d)
      EXPECT_WITHIN_RELATIVE(two.ratio[s](d, 0), all.ratio[s](d, 0), 1e-9,
                             "closed form; rounding, and of small differences")
          << s << " " << places[d];
}

TEST(ByQuadrature, ReachesItsAccuracyAtTheDefaultNumberOfRays) {
  expect_accuracy({}, false, 300, 1.3e-3, 3e-4);
}

TEST(ByQuadrature, ReachesItsAccuracyWithEveryTerm) {
  expect_accuracy(atmosphere::preset("undated", algebra::degrees(10)), true, 300, 1.3e-3, 3e-4);
}

TEST(ByQuadrature, IsSoundAtTheExtremes) {
  atmosphere::Atmosphere thick;
  thick.column.dust_extinction_per_m = 0.01;
  const std::vector<double> waves{380, 780};
  const auto distances = up_to(9e6, 3e5);
  for (const auto& air : {atmosphere::Atmosphere{}, thick})
    for (const double sun : {4.6e10, 4.4e11})
      for (const double depth : {1.01e8, 9.9e8}) {
        const auto light = by_quadrature(air, {sun, {depth}}, waves, distances, {.rays = 40});
        for (const auto value : light.ratio[0].values())
          EXPECT_TRUE(std::isfinite(value) && value >= 0) << value;
      }
}

TEST(ByQuadrature, IsFiniteAtEveryWavelengthOfAScene) {
  // Rays that graze a break of the air to rounding once came out as no number.
  std::vector<double> waves;
  for (double nm = 380; nm <= 780; nm += 0.5) waves.push_back(nm);
  const std::vector<double> distances{1e6, 4e6};
  const auto light = by_quadrature({}, february_2008, waves, distances, {.rays = 60});
  for (const auto value : light.ratio[0].values()) EXPECT_TRUE(std::isfinite(value) && value > 0);
}

/// A random recipe: 1e-50 of sunlight, which four hundred places followed from decade to decade.
TEST(ByQuadrature, PutsNoPlacesIntoDarkness) {
  auto air = atmosphere::preset("undated", algebra::degrees(0));
  air.earth = {};
  air.column.dust_extinction_per_m = 6e-4;
  const auto distances = up_to(2.6e6, 2e5);
  const auto light = by_quadrature(air, february_2008, std::vector<double>{450, 650}, distances,
                                   {.rays = 100, .place_error = 0.003});
  ASSERT_GT(light.ratio[0](0, 1), 0);
  EXPECT_LT(light.ratio[0](0, 1), darkness_ratio);
  EXPECT_LE(light.axis_distances_m.size(), 2 * distances.size());
}

TEST(ByQuadrature, PutsFewerPlacesWhereMoreIsTakenForDark) {
  auto air = atmosphere::preset("undated", algebra::degrees(0));
  air.earth = {};
  air.column.dust_extinction_per_m = 1e-4;
  const auto places = [&](double dark_ratio) {
    return by_quadrature(air, february_2008, std::vector<double>{450, 650}, up_to(4e6, 2e5),
                         {.rays = 200, .place_error = 0.003, .dark_ratio = dark_ratio})
        .axis_distances_m;
  };
  const auto all = places(darkness_ratio), fewer = places(1e-6);
  EXPECT_LT(fewer.size() + 10, all.size());
  EXPECT_TRUE(std::ranges::includes(all, fewer));
  EXPECT_THROW(places(darkness_ratio / 2), algebra::Error);
}

TEST(ByQuadrature, OfABareEarthIsNothing) {
  atmosphere::Atmosphere none;
  none.column.density = atmosphere::Density::none;
  const std::vector<double> waves{550}, distances{0, 5e6};
  const auto light = by_quadrature(none, february_2008, waves, distances);
  for (const auto value : light.ratio[0].values()) EXPECT_EQ(value, 0);
}

TEST(ByQuadrature, IsWholeWhereALoopAboutItIsEnded) {
  const auto air = atmosphere::preset("undated", algebra::degrees(0));
  const std::vector<double> waves{450, 550}, distances{0, 3e6};
  const auto whole = by_quadrature(air, february_2008, waves, distances, {.rays = 100});
  std::vector<RefractedLight> all(8);
  EXPECT_THROW(tbb::parallel_for(std::size_t{0}, all.size() + 1,
                                 [&](std::size_t i) {
                                   if (i == all.size()) throw algebra::Error("ended");
                                   all[i] = by_quadrature(air, february_2008, waves, distances,
                                                          {.rays = 100});
                                 }),
               algebra::Error);
  for (const auto& light : all)
    if (!light.ratio.empty()) {
      EXPECT_EQ(light.ratio[0](0, 1), whole.ratio[0](0, 1));
    }
}

}  // namespace coppermoon::shadow::by_quadrature_test
