// SPDX-License-Identifier: MIT
// Light in the shadow pushed over every edge: the axis, the distances, darkness, sums of many photons.
#include "algebra/random.h"
#include "almanac/ephemeris.h"
#include "atmosphere/presets.h"
#include "extremes/worst.h"
#include "photons/bending.h"
#include "photons/solar_disc.h"
#include "shadow/by_photons.h"
#include "shadow/by_quadrature.h"
#include "shadow/lookup.h"
#include "shadow/photon_spectra.h"
#include "shadow/twilight.h"
#include "support/testing.h"

namespace coppermoon::extremes::numbers_of_light_test {

using atmosphere::Atmosphere;
using atmosphere::Density;
using shadow::Arrangement;

constexpr double au_m = almanac::astronomical_unit_m;
const Arrangement february_2008{1.479e11, {3.83e8}};
const std::vector<double> green{550};

Atmosphere transparent(Density density = Density::yapo_cutler) {
  Atmosphere air;
  air.column.density = density;
  air.column.rayleigh = false;
  return air;
}

bool is_light(double value) { return std::isfinite(value) && value >= 0; }

void expect_light(const shadow::RefractedLight& light, std::string_view what) {
  for (const auto& grid : light.ratio)
    EXPECT_TRUE(std::ranges::all_of(grid.values(), is_light)) << what;
  for (const auto& grid : light.standard_error)
    EXPECT_TRUE(std::ranges::all_of(grid.values(), is_light)) << what;
}

shadow::PhotonSettings photons_of(std::uint64_t count, bool literal, double ring_m,
                                  std::size_t sectors = 1) {
  shadow::PhotonSettings settings;
  settings.photons = count;
  settings.literal = literal;
  settings.ring_width_m = ring_m;
  settings.sectors = sectors;
  return settings;
}

/// On the axis the arcs are whole circles: E(0)/E₀ = (1 + z/D)² 2/a² ∫ T b db over |r(b)| < a.
double on_the_axis(const Atmosphere& air, const Arrangement& arrangement) {
  constexpr int rays = 4000;
  const double z = arrangement.depths_m[0], sun_m = arrangement.sun_distance_m,
               a = projected_solar_radius_m(arrangement, z), radius = air.earth.equatorial_radius_m;
  const auto optics = atmosphere::sea_level_optics(algebra::nanometres(green[0]), air.molecules);
  double sum = 0, low = 0;
  for (const double high : atmosphere::breaks_m(air.column)) {
    double r0 = 0, carried0 = 0, b0 = 0;
    for (int i = 0; i <= rays; ++i) {
      const double h = high - (high - low) * std::pow(1 - static_cast<double>(i) / rays, 2);
      const auto path = photons::limb_path(h, radius, air.column, optics.refractivity);
      const double b = radius + path.impact_height_m,
                   r = std::abs(shadow::landing_m(b, path.bending_rad, sun_m, z)),
                   carried = b * std::exp(-atmosphere::product(path.amounts,
                                                               spectra(air.column, optics)));
      const double inside =
          r0 == r ? 1 : std::clamp((a - std::min(r, r0)) / std::abs(r - r0), 0., 1.);
      const bool outer_first = r0 > r;
      const double edge =
          outer_first ? std::lerp(carried, carried0, inside) : std::lerp(carried0, carried, inside);
      if (i > 0) sum += inside * (b - b0) * (edge + (outer_first ? carried : carried0)) / 2;
      r0 = r, carried0 = carried, b0 = b;
    }
    low = high;
  }
  return std::pow(1 + z / sun_m, 2) * 2 / (a * a) * sum;
}

TEST(Light, OnTheAxisIsTheClosedFormAndTheLimitFromBesideIt) {
  const std::vector<double> gammas{0, 1e-9, 1e-3, 1, 1e3, 1e4};
  for (const auto& [name, air] : {std::pair{"transparent air", transparent()},
                                  std::pair{"the paper's air without ozone", Atmosphere{}}}) {
    const auto light = by_quadrature(air, february_2008, green, gammas, {.rays = 3000});
    Worst axis, limit;
    axis.see_relative(light.ratio[0](0, 0), on_the_axis(air, february_2008));
    for (std::size_t i = 1; i < gammas.size(); ++i)
      limit.see_relative(light.ratio[0](i, 0), light.ratio[0](0, 0));
    holds(fmt::format("the focus on the axis itself, {}", name), "irradiance, over closed form",
          1e-4, axis, "of 1000 rays 8e-5 is stated, of the trapezoids 1e-6");
    holds(fmt::format("1 nm to 10 km from the axis, {}", name), "over that on it", 1e-4, limit,
          "(10 km over the 1800 km of the Sun's disc)^2, and the bins");
  }
}

TEST(Light, AtTheCausticsIsFiniteAndTheSameHoweverManyRays) {
  std::vector<double> gammas;
  for (double g = 0; g < 9e6; g += 25e3) gammas.push_back(g);
  for (const auto density : {Density::yapo_cutler, Density::us_1976}) {
    const auto air = transparent(density);
    const auto light = by_quadrature(air, february_2008, green, gammas, {.rays = 1000}),
               finer = by_quadrature(air, february_2008, green, gammas, {.rays = 4000});
    expect_light(light, "caustics");
    Worst worst;
    for (std::size_t i = 0; i < gammas.size(); ++i)
      worst.see(std::abs(light.ratio[0](i, 0) - finer.ratio[0](i, 0)));
    holds(fmt::format("the caustics of air to {:.0f} km, every 25 km", air.top_m() / 1e3),
          "1000 rays against 4000, of unshaded sunlight", 3e-5, worst,
          "1e-5 is stated beyond 4500 km; transparent air is brighter");
  }
}

/// Where a point source's ray lands at γ: h by bisection, between two heights.
double point_source(const Arrangement& arrangement, double gamma_m) {
  const double z = arrangement.depths_m[0], sun_m = arrangement.sun_distance_m, radius = 6.378e6;
  const auto air = transparent();
  const auto optics = atmosphere::sea_level_optics(algebra::nanometres(green[0]), air.molecules);
  const auto landing = [&](double h, double& b) {
    const auto path = photons::limb_path(h, radius, air.column, optics.refractivity);
    b = radius + path.impact_height_m;
    return shadow::landing_m(b, path.bending_rad, sun_m, z);
  };
  double low = 0, high = 11e3, b0 = 0, b1 = 0;
  for (int i = 0; i < 60; ++i) {
    const double h = (low + high) / 2;
    (landing(h, b0) < gamma_m ? low : high) = h;
  }
  const double r0 = landing(low - 1, b0), r1 = landing(low + 1, b1);
  return std::pow(1 + z / sun_m, 2) * (b0 + b1) / 2 * (b1 - b0) / (gamma_m * (r1 - r0));
}

TEST(Light, OfASunThatShrinksTendsToThatOfAPoint) {
  const std::vector<double> gammas{4.9e6, 5e6, 5.1e6};
  std::array<double, 2> off{};
  Worst at_three;
  for (std::size_t k = 0; k < 2; ++k) {
    const Arrangement arrangement{(k == 0 ? 1.5 : 3) * au_m, {1e8}};
    const auto light = by_quadrature(transparent(), arrangement, green, gammas, {.rays = 8000});
    for (std::size_t i = 0; i < gammas.size(); ++i) {
      const double error = light.ratio[0](i, 0) / point_source(arrangement, gammas[i]) - 1;
      off[k] += error / 3;
      if (k == 1) at_three.see(std::abs(error));
    }
  }
  holds("the Sun at 3 au, light 1e5 km behind the limb", "that of a point source, over it", 0.01,
        at_three, "(150 km of the disc over 1000 km in which light changes)^2 / 8");
  Worst order;
  order.see(std::abs(off[0] / off[1] - 4));
  holds("the Sun twice as far", "a quarter of that difference: their ratio less 4", 0.3, order,
        "the fourth order of the disc's radius");
  is_refused("the Sun at 3.1 au", [&] {
    shadow::by_quadrature(transparent(), {3.1 * au_m, {1e8}}, green, gammas);
  });
}

/// The bare Earth's umbra ends at R (1 + z/D) − R☉ z/D from the axis.
TEST(DirectLight, EndsWhereSimilarTrianglesSay) {
  Worst worst;
  for (const double scale : {0.1, 0.5, 1., 2., 10.})
    for (const double sun_au : {0.3, 0.5, 1., 2., 3., 1e3})
      for (const double depth_m : {1e8, 1.9e8, 3.56e8, 4.07e8, 7.7e8, 1e9}) {
        Atmosphere bare;
        bare.column.density = Density::none;
        bare.earth.equatorial_radius_m = bare.earth.polar_radius_m = 6.378e6 * scale;
        const double sun_m = sun_au * au_m, umbra_m = 6.378e6 * scale * (1 + depth_m / sun_m) -
                                                      photons::solar_radius_m * depth_m / sun_m;
        if (umbra_m < 1e4) continue;
        const shadow::DirectLight direct(bare, {sun_m, {depth_m}}, green);
        const auto at = [&](double gamma_m) {
          double ratio = 0;
          direct.ratios(gamma_m, 0, depth_m, {&ratio, 1});
          return ratio;
        };
        double low = 0, high = direct.penumbra_m(depth_m);
        for (int i = 0; i < 60; ++i) {
          const double middle = (low + high) / 2;
          (at(middle) > 0 ? high : low) = middle;
        }
        worst.see_relative(low, umbra_m);
        EXPECT_EQ(at(0), 0);
        EXPECT_WITHIN(at(direct.penumbra_m(depth_m)), 1, 1e-9, "all is clear at its end");
      }
  holds("the Earth 0.1 to 10 times its size, Sun at 0.3 to 1000 au, Moon at 1e5 to 1e6 km",
        "the umbra's radius, over similar triangles", 2e-4, worst,
        "light under 1e-12 counts as none: 1e-8 of the disc's width; and b/D squared at 0.3 au");
}

TEST(Light, IsFiniteWhereverSunMoonAndGroundStand) {
  const std::vector<double> waves{380, 780}, gammas{0, 1e6, 4e6, 8e6};
  for (const double earth_m : {1e6, 6.378e6, 1e7})
    for (const double sun_au : {0.5, 1., 2.})
      for (const double depth_m : {1.9e8, 3.56e8, 4.07e8, 7.7e8}) {
        auto air = atmosphere::preset("undated", {});
        air.earth = {earth_m, earth_m, 0};
        expect_light(
            shadow::by_quadrature(air, {sun_au * au_m, {depth_m}}, waves, gammas, {.rays = 40}),
            "distances");
      }
  tried("an Earth of 1000 to 10 000 km, Sun at 0.5 to 2 au, Moon at half and double its distance",
        "light is finite and not negative");
  for (const double earth_m : {6.378e5, 6.378e7}) {
    Atmosphere air;
    air.earth = {earth_m, earth_m, 0};
    is_refused(fmt::format("air about an Earth of {:g} km", earth_m / 1e3),
               [&] { by_quadrature(air, february_2008, waves, gammas); });
  }
}

TEST(Light, OfAirThatIsBlackIsNoneAndNeverNoNumber) {
  const std::vector<double> waves{380, 550, 780}, gammas{0, 2e6, 4e6, 6e6};
  const shadow::ChannelWeights weights(3, 3, 1.);
  auto black = atmosphere::preset("undated", {});
  black.column.dust_extinction_per_m = 0.01;
  black.column.dust_bottom_m = 0;
  black.column.dust_top_m = 86e3;
  black.column.tropospheric_optical_depth = 10;
  black.column.ozone_du = 1000;
  black.column.stratosphere = atmosphere::StratosphericAerosol::extreme;
  auto overcast = atmosphere::preset("undated", {});
  overcast.column.cloud_cover = 1;
  overcast.column.cloud_top_m = 30e3;
  for (const auto& air : {black, overcast}) {
    auto light = by_quadrature(air, february_2008, waves, gammas, {.rays = 60});
    expect_light(light, "black air");
    const shadow::Lookup lookup(light, {air, february_2008, waves}, weights);
    std::array<double, 3> values{};
    lookup.read({algebra::metres(0), {}, algebra::metres(3.83e8)}, values);
    EXPECT_TRUE(std::ranges::all_of(values, is_light));
    EXPECT_TRUE(is_light(lookup.worst_relative_error(light, weights, 0, 4e6)));
    add_twilight(light, air);
    expect_light(light, "black air and twilight");
    for (const bool literal : {true, false}) {
      const auto photons = by_photons(air, february_2008, waves, photons_of(1, literal, 5e5, 2));
      expect_light(photons, "photons in black air");
    }
  }
  EXPECT_LT(by_quadrature(black, february_2008, green, {gammas.data(), 1}).ratio[0](0, 0), 1e-12);
  tried("all absorbers at their most, at once; cloud to 30 km all over",
        "light by three ways, look-up and twilight are finite and not negative");
}

TEST(Light, OfOnePhotonAndOneWavelengthIsFiniteAndItsErrorUnknown) {
  for (const bool literal : {true, false}) {
    const auto light = by_photons(Atmosphere{}, february_2008, green, photons_of(1, literal, 5e4));
    EXPECT_EQ(light.photons, shadow::photons_a_block);
    expect_light(light, "one photon");
    for (std::size_t i = 0; i < light.ratio[0].values().size(); ++i)
      EXPECT_EQ(light.standard_error[0].values()[i], light.ratio[0].values()[i]);
  }
  tried("one photon, one wavelength, by both ways", "one block, whose error is all of it");
}

/// Light that a transparent ring lets in: (1 + z/D)² π (b₁² − b₀²).
double flux_m2(const shadow::RefractedLight& light, std::size_t sector) {
  const double ring_m = light.axis_distances_m[1] - light.axis_distances_m[0];
  double sum = 0;
  for (std::size_t i = 0; i < light.axis_distances_m.size(); ++i)
    sum += light.ratio[sector](i, 0) * 2 * std::numbers::pi * light.axis_distances_m[i] * ring_m;
  return sum;
}

TEST(Light, OfRegionsWhoseAirEndsLowerOrIsNoneLosesNothing) {
  // Straight and clear, so that each place is lit by all that passes its own side of the ground.
  auto air = transparent(Density::us_1976);
  air.column.refraction = false;
  std::vector<double> gammas;
  for (double g = 5e3; g < 9e6; g += 1e4) gammas.push_back(g);
  const auto whole = by_quadrature(air, february_2008, green, gammas);
  for (const auto density : {Density::none, Density::yapo_cutler}) {
    auto region = air.column;
    region.density = density;
    auto mixed = air;
    mixed.regions = {{algebra::degrees(90), algebra::degrees(270), region}};
    Worst worst;
    const auto light = by_quadrature(mixed, february_2008, green, gammas);
    for (std::size_t s = 0; s < light.sectors; s += 6)
      worst.see_relative(flux_m2(light, s), flux_m2(whole, 0));
    const auto gathered = means_over_rings(
        shadow::traced(mixed, february_2008, green, photons_of(200'000, false, 2e6, 2)));
    holds(fmt::format("air to 86 km, in the south to {:.0f} km, straight and clear",
                      atmosphere::top_m(region) / 1e3),
          "light of the whole plane, over that of one air", 1e-3, worst, "10 km between places");
    Worst noise;
    for (std::size_t s = 0; s < 2; ++s) noise.see_relative(flux_m2(gathered, s), flux_m2(whole, 0));
    holds("the same by photons", "light north and south, over that of one air", 0.01, noise,
          "noise of 200 000 photons");
  }
}

shadow::PhotonSums of_one_cell() {
  shadow::PhotonSums sums;
  sums.arrangement = {1e11, {1e8}};
  sums.wavelengths_nm = {550};
  sums.ring_width_m = 1e3;
  sums.rings = 1;
  sums.sum = sums.sum_of_squares = {algebra::Grid<double>(1, 1)};
  return sums;
}

constexpr std::uint64_t blocks_of_1e9 = 976'563;

/// Photons in blocks of a light drawn by `draw`, merged so many blocks at a time.
template <class Draw>
double drift(std::uint64_t together, const Draw& draw) {
  auto all = of_one_cell();
  long double exact = 0;
  for (std::uint64_t block = 0; block < blocks_of_1e9;) {
    auto part = of_one_cell();
    const auto to = std::min(blocks_of_1e9, block + together);
    part.done = {{block, to}};
    for (; block < to; ++block) {
      const double light = draw();
      part.sum[0](0, 0) += light;
      exact += light;
    }
    all = merged(std::move(all), part);
  }
  EXPECT_EQ(blocks_in(all.done), blocks_of_1e9);
  return std::abs(static_cast<double>(all.sum[0](0, 0) / exact - 1));
}

void expect_no_drift(std::uint64_t together, const char* what) {
  algebra::Random random(1, 1);
  Worst worst;
  worst.see(drift(together, [] { return 0.1; }));
  worst.see(drift(together, [&] { return std::pow(random.uniform(), 8); }));
  holds(what, "their sum, over itself", 1e-12, worst, "what merging states");
}

TEST(PhotonSums, OfABillionPhotonsDoNotDrift) {
  expect_no_drift(4096, "1e9 photons in a million blocks, as a run adds them");
}

TEST(PhotonSumsThoroughly, OfABillionPhotonsDoNotDrift) {
  expect_no_drift(1, "1e9 photons in a million shards, added one by one");
}

TEST(PhotonRows, DrainABillionPhotonsWithoutADrift) {
  algebra::Random random(2, 1);
  shadow::Tally tally(1, 1);
  algebra::Grid<double> sum(1, 1), squares(1, 1);
  long double exact = 0, exact_squares = 0;
  for (std::uint64_t block = 0; block < 4096; ++block) {
    const auto light = static_cast<float>(std::pow(random.uniform(), 8) * 1e14);
    tally.light(0, 0) = light;
    tally.touched[0] = 1;
    exact += light;
    exact_squares += static_cast<long double>(light) * light;
    drain(tally, sum, squares);
  }
  Worst worst;
  worst.see(std::abs(static_cast<double>(sum(0, 0) / exact - 1)));
  worst.see(std::abs(static_cast<double>(squares(0, 0) / exact_squares - 1)));
  holds("the 4096 blocks that a run adds at once", "sum and squares, over themselves", 1e-12, worst,
        "rounding");
}

}  // namespace coppermoon::extremes::numbers_of_light_test
