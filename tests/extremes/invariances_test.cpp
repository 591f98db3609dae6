// SPDX-License-Identifier: MIT
// What may not change when everything is turned, mirrored, reordered, rescaled or split. Cases are
// drawn at random under one seed, which a failure prints.
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "algebra/random.h"
#include "almanac/sky.h"
#include "atmosphere/presets.h"
#include "eclipse/shadow_axis.h"
#include "eclipse/shadow_cone.h"
#include "extremes/worst.h"
#include "photons/bending.h"
#include "photons/trace.h"
#include "shadow/by_photons.h"
#include "shadow/by_quadrature.h"
#include "support/testing.h"
#include "texture/globe.h"

namespace coppermoon::extremes::invariances_test {

using std::numbers::pi;

constexpr std::uint64_t seed = 20080221;
const shadow::Arrangement february_2008{1.479e11, {3.83e8}};
const std::vector<double> green{550};

/// Random numbers of one case.
class Drawn {
 public:
  explicit Drawn(std::uint64_t number) : random_(seed, number) {}
  double between(double from, double to) { return from + (to - from) * random_.uniform(); }
  std::uint64_t below(std::uint64_t count) {
    return static_cast<std::uint64_t>(random_.uniform() * static_cast<double>(count));
  }
  glm::dvec3 direction() {
    const double z = between(-1, 1), angle = between(0, 2 * pi), r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }
  glm::dmat3 rotation() {
    const auto x = direction(), y = glm::normalize(glm::cross(x, direction()));
    return {x, y, glm::cross(x, y)};
  }

 private:
  algebra::Random random_;
};

std::string of_case(std::uint64_t number) { return fmt::format("seed {}, case {}", seed, number); }

/// Sun, pole and Moon as they stand in some eclipse.
struct Bodies {
  glm::dvec3 sun_m, pole, moon_m;

  explicit Bodies(Drawn& drawn) : pole(drawn.direction()) {
    const auto away =
        glm::normalize(glm::cross(pole, drawn.direction()) + drawn.between(-0.43, 0.43) * pole);
    sun_m = -drawn.between(1.47e11, 1.52e11) * away;
    const auto aside = glm::normalize(glm::cross(away, drawn.direction()));
    moon_m = drawn.between(3.56e8, 4.07e8) * away + drawn.between(0, 9e6) * aside;
  }
  Bodies turned(const glm::dmat3& by) const {
    Bodies all = *this;
    all.sun_m = by * sun_m, all.pole = by * pole, all.moon_m = by * moon_m;
    return all;
  }
  eclipse::ShadowPlace place() const {
    return place_in_shadow(eclipse::shadow_axis(sun_m, pole), moon_m);
  }
};

double apart(algebra::Angle a, algebra::Angle b) {
  return std::abs(std::remainder(algebra::in_radians(a - b), 2 * pi));
}

TEST(Turning, SunMoonAndPoleLeavesThePlaceInTheShadow) {
  Worst metres, angle;
  for (std::uint64_t i = 0; i < 100; ++i) {
    Drawn drawn(i);
    const Bodies bodies(drawn);
    const auto place = bodies.place(), same = bodies.turned(drawn.rotation()).place();
    const double from_axis_m = algebra::in_metres(place.axis_distance);
    metres.see(std::abs(algebra::in_metres(place.depth - same.depth)));
    metres.see(std::abs(algebra::in_metres(place.axis_distance - same.axis_distance)));
    angle.see(apart(place.position_angle, same.position_angle) * from_axis_m);
    EXPECT_LE(metres.value, 1e-6) << of_case(i);
  }
  holds("100 skies turned by random rotations", "the Moon's place in the shadow [m]", 1e-6, metres,
        "rounding of 4e8 m, ten times");
  holds("the same", "its position angle, times the axis distance [m]", 1e-6, angle, "the same");
}

TEST(Turning, ThePoleAloneTurnsThePositionAngleByAsMuch) {
  Worst worst;
  for (std::uint64_t i = 0; i < 100; ++i) {
    Drawn drawn(i);
    const Bodies bodies(drawn);
    const auto axis = eclipse::shadow_axis(bodies.sun_m, bodies.pole);
    const auto frame = glm::transpose(axis.shadow_from_gcrs);
    const double by = drawn.between(-pi, pi);
    const auto about = [&](const glm::dvec3& v) {
      const auto p = axis.shadow_from_gcrs * v;
      return frame * glm::dvec3(std::cos(by) * p.x + std::sin(by) * p.y,
                                -std::sin(by) * p.x + std::cos(by) * p.y, p.z);
    };
    auto other = bodies;
    other.pole = about(bodies.pole);  // turned from north through east
    const auto place = bodies.place(), same = other.place();
    worst.see(apart(place.position_angle - algebra::radians(by), same.position_angle));
    worst.see(std::abs(algebra::in_metres(place.depth - same.depth)) * 1e-6);
    EXPECT_LE(worst.value, 1e-9) << of_case(i);
  }
  holds("the pole turned about the axis, 100 times", "the position angle less that turn [rad]",
        1e-9, worst, "rounding of 1e-7 m, as close as 100 m to the axis");
}

almanac::SkyState sky_of(Drawn& drawn) {
  const Bodies bodies(drawn);
  almanac::SkyState sky;
  sky.sun_m = bodies.sun_m, sky.moon_m = bodies.moon_m;
  const auto x = glm::normalize(glm::cross(bodies.pole, drawn.direction()));
  sky.equator_from_gcrs = glm::transpose(glm::dmat3(x, glm::cross(bodies.pole, x), bodies.pole));
  sky.selenographic_from_gcrs = drawn.rotation();
  return sky;
}

/// Reflected light and places of a globe's texels.
std::vector<double> texels(const almanac::SkyState& sky) {
  constexpr std::size_t rows = 8;
  const texture::Globe globe(sky, rows, surface::Photometry::lommel_seeliger_rolo);
  const std::vector<float> white(2 * rows, 1.F);
  std::vector<double> all, some(8 * rows);
  for (std::size_t r = 0; r < rows; ++r) {
    const auto part = [&](std::size_t k) {
      return std::span(some).subspan(k * 2 * rows, 2 * rows);
    };
    light_texels(globe, r, 0, white, {}, {part(0), part(1), part(2), part(3)});
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

TEST(Turning, EverythingLeavesEveryTexelAsItWas) {
  Worst worst;
  for (std::uint64_t i = 0; i < 40; ++i) {
    Drawn drawn(i);
    const auto sky = sky_of(drawn);
    const auto by = drawn.rotation();
    auto turned = sky;
    turned.sun_m = by * sky.sun_m, turned.moon_m = by * sky.moon_m;
    turned.equator_from_gcrs = sky.equator_from_gcrs * glm::transpose(by);
    turned.selenographic_from_gcrs = sky.selenographic_from_gcrs * glm::transpose(by);
    const auto a = texels(sky), b = texels(turned);
    for (std::size_t k = 0; k < a.size(); ++k)
      worst.see(std::abs(a[k] - b[k]) / std::max(1., std::abs(a[k])));
    EXPECT_LE(worst.value, 1e-9) << of_case(i);
  }
  holds("40 Moons turned with their skies", "light and place of every texel, over them", 1e-9,
        worst, "rounding of cosines just over the terminator, and of 1e-7 m in places");
}

TEST(Turning, ALiteralRayTurnsWhereItGoes) {
  const auto optics = atmosphere::sea_level_optics(algebra::nanometres(550));
  Worst worst;
  for (std::uint64_t i = 0; i < 20; ++i) {
    Drawn drawn(i);
    const double impact_m = 6.378e6 + drawn.between(5e3, 40e3);
    const photons::Ray far{{impact_m, 0, -1e8}, {0, 0, 1}};
    const auto ray = *photons::entered(far, 6.42e6);
    const auto by = drawn.rotation();
    const auto out = photons::trace(ray, {}, optics, {});
    const auto turned = photons::trace({by * ray.position_m, by * ray.direction}, {}, optics, {});
    ASSERT_TRUE(out && turned) << of_case(i);
    const double bent = glm::distance(ray.direction, out->leaving.direction);
    worst.see(glm::distance(by * out->leaving.direction, turned->leaving.direction) / bent);
    EXPECT_LE(worst.value, 4e-3) << of_case(i);
  }
  holds("20 rays stepped literally, turned at random", "where they go, over their bending", 4e-3,
        worst, "differences of 10 m to one side, axis by axis: 10 m over 2 H along each");
}

/// A region from one angle to another, dusty to some degree.
atmosphere::Region dusty(double from_rad, double to_rad, double extinction_per_m) {
  atmosphere::Column column;
  column.dust_extinction_per_m = extinction_per_m;
  return {algebra::radians(from_rad), algebra::radians(to_rad), column};
}

std::vector<atmosphere::Region> drawn_regions(Drawn& drawn) {
  const double a = drawn.between(0, 2), b = drawn.between(2.2, 3.5), c = drawn.between(3.6, 6);
  return {dusty(a, a + drawn.between(0.1, b - a), drawn.between(1e-7, 1e-5)),
          dusty(b, b + drawn.between(0.1, c - b), drawn.between(1e-7, 1e-5)),
          dusty(c, c + drawn.between(0.1, 2 * pi + a - c), drawn.between(1e-7, 1e-5))};
}

shadow::RefractedLight light_of(const atmosphere::Atmosphere& air) {
  static const std::vector<double> gammas{0, 1e6, 3e6, 4.5e6};
  return by_quadrature(air, february_2008, green, gammas, {.rays = 60});
}

double worst_of(const shadow::RefractedLight& a, const shadow::RefractedLight& b, auto sector_of) {
  Worst worst;
  for (std::size_t s = 0; s < a.sectors; ++s)
    for (std::size_t d = 0; d < a.axis_distances_m.size(); ++d)
      worst.see_relative(b.ratio[sector_of(s)](d, 0), a.ratio[s](d, 0));
  return worst.value;
}

TEST(Mirroring, NorthAndSouthMirrorsTheLight) {
  Worst worst;
  for (std::uint64_t i = 0; i < 20; ++i) {
    Drawn drawn(i);
    const double declination = drawn.between(-0.4, 0.4);
    atmosphere::Atmosphere air, mirrored;
    air.earth = atmosphere::ellipsoid(declination);
    mirrored.earth = atmosphere::ellipsoid(-declination);
    air.regions = drawn_regions(drawn);
    for (const auto& region : air.regions)
      mirrored.regions.push_back(
          {algebra::radians(pi) - region.to, algebra::radians(pi) - region.from, region.column});
    const auto light = light_of(air), other = light_of(mirrored);
    const std::size_t all = light.sectors;
    worst.see(worst_of(light, other, [&](std::size_t s) { return (all + all / 2 - s) % all; }));
    EXPECT_LE(worst.value, 1e-9) << of_case(i);
  }
  holds("20 skies of three regions, mirrored north for south", "light, over itself", 1e-9, worst,
        "rounding of the borders' angles");
}

TEST(Turning, RegionsByASectorTurnsTheLightByOne) {
  Worst worst;
  for (std::uint64_t i = 0; i < 20; ++i) {
    Drawn drawn(i);
    atmosphere::Atmosphere air;
    air.regions = drawn_regions(drawn);
    auto turned = air;
    const auto sectors = 1 + drawn.below(shadow::sectors_around - 1);
    const double by = 2 * pi * static_cast<double>(sectors) / shadow::sectors_around;
    for (auto& region : turned.regions)
      region.from = region.from + algebra::radians(by),
      region.to = region.to + algebra::radians(by);
    const auto light = light_of(air);
    worst.see(worst_of(light, light_of(turned),
                       [&](std::size_t s) { return (s + sectors) % light.sectors; }));
    EXPECT_LE(worst.value, 1e-9) << of_case(i);
  }
  holds("three regions over a sphere, turned by whole sectors, 20 times", "light, over itself",
        1e-9, worst, "rounding of the borders' angles");
}

TEST(Order, OfRegionsThatDoNotOverlapDoesNotMatter) {
  Worst worst;
  for (std::uint64_t i = 0; i < 20; ++i) {
    Drawn drawn(i);
    atmosphere::Atmosphere air;
    air.earth = atmosphere::ellipsoid(drawn.between(-0.4, 0.4));
    air.regions = drawn_regions(drawn);
    auto other = air;
    std::rotate(other.regions.begin(), other.regions.begin() + 1 + static_cast<int>(drawn.below(2)),
                other.regions.end());
    worst.see(worst_of(light_of(air), light_of(other), [](std::size_t s) { return s; }));
    EXPECT_LE(worst.value, 1e-11) << of_case(i);
  }
  holds("three regions in another order, 20 times", "light, over itself", 1e-11, worst,
        "rounding of 161 harmonics in another order, whose sum is a hundredth of them where it is "
        "dark");
}

TEST(Scaling, AllLengthsByTwoScalesWhatIsComputedOfThemExactly) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    Drawn drawn(i);
    const double r = drawn.between(1e6, 2e6), s = drawn.between(4e6, 7e6),
                 d = drawn.between(0, 9e6);
    EXPECT_EQ(shadow::lens_area(2 * d, 2 * r, 2 * s), 4 * shadow::lens_area(d, r, s)) << of_case(i);
    const double b = drawn.between(6.3e6, 6.5e6), bent = drawn.between(0, 0.02);
    EXPECT_EQ(shadow::landing_m(2 * b, bent, 3e11, 8e8),
              2 * shadow::landing_m(b, bent, 1.5e11, 4e8))
        << of_case(i);
    Bodies bodies(drawn);
    const auto place = bodies.place();
    bodies.sun_m *= 2, bodies.moon_m *= 2;
    const auto far = bodies.place();
    EXPECT_EQ(far.axis_distance, 2 * place.axis_distance) << of_case(i);
    EXPECT_EQ(far.depth, 2 * place.depth) << of_case(i);
    EXPECT_EQ(far.position_angle, place.position_angle) << of_case(i);
  }
  tried("areas, landings and places of lengths twice as large", "twice or four times, to the bit");
}

/// Straight air in a shell: light knows lengths only by their ratios to each other and to α.
TEST(Scaling, RadiusLayerAndExtinctionTogetherLeavesTheOpticalDepth) {
  const auto optics = atmosphere::sea_level_optics(algebra::nanometres(550));
  Worst worst;
  for (std::uint64_t i = 0; i < 100; ++i) {
    Drawn drawn(i);
    const double scale = drawn.between(0.25, 1.9), h = drawn.between(0, 14e3);
    const auto depth = [&](double by) {
      const atmosphere::Column dust{.refraction = false,
                                    .rayleigh = false,
                                    .dust_extinction_per_m = 1e-5 / by,
                                    .dust_bottom_m = 15e3 * by,
                                    .dust_top_m = 20e3 * by};
      return photons::limb_ray(h * by, 5e6 * by, dust, optics)->optical_depth;
    };
    worst.see_relative(depth(scale), depth(1));
    EXPECT_LE(worst.value, 1e-10) << of_case(i);
  }
  holds("radius and dust layer 0.25 to 1.9 times as large, as much more transparent, 100 times",
        "optical depth, over itself", 1e-10, worst, "Gauss over pieces cut elsewhere");
}

TEST(Units, KilometresAndDegreesAreMetresAndRadians) {
  Worst worst;
  for (std::uint64_t i = 0; i < 100; ++i) {
    Drawn drawn(i);
    const double x = drawn.between(-1e9, 1e9);
    worst.see_relative(algebra::in_metres(algebra::kilometres(x / 1e3)), x);
    worst.see_relative(algebra::in_kilometres(algebra::metres(x)) * 1e3, x);
    worst.see_relative(algebra::in_degrees(algebra::radians(x)) * pi / 180, x);
    worst.see_relative(algebra::in_radians(algebra::degrees(x)) * 180 / pi, x);
    worst.see_relative(algebra::in_arcminutes(algebra::degrees(x)) / 60, x);
  }
  holds("lengths and angles in other units, 100 of them", "themselves", 1e-15, worst, "rounding");
}

TEST(Splitting, APhotonRunInTwoAndMergingItAddsUpToTheSame) {
  Worst worst;
  const std::vector<double> waves{450, 650};
  for (std::uint64_t i = 0; i < 20; ++i) {
    Drawn drawn(i);
    shadow::PhotonSettings settings;
    settings.seed = i, settings.rays = 60;
    settings.ring_width_m = drawn.between(1e5, 2e6);
    const std::uint64_t blocks = 2 + drawn.below(20), cut = 1 + drawn.below(blocks - 1);
    const auto run = [&](shadow::BlockRange range) {
      settings.blocks = range;
      return traced({}, february_2008, waves, settings);
    };
    const auto whole = run({0, blocks}), both = merged(run({cut, blocks}), run({0, cut}));
    EXPECT_EQ(both.done, whole.done);
    for (std::size_t k = 0; k < whole.sum[0].values().size(); ++k) {
      worst.see_relative(both.sum[0].values()[k], whole.sum[0].values()[k]);
      worst.see_relative(both.sum_of_squares[0].values()[k], whole.sum_of_squares[0].values()[k]);
    }
    EXPECT_LE(worst.value, 1e-14) << of_case(i);
  }
  holds("20 photon runs cut in two and merged", "all sums, over themselves", 1e-14, worst,
        "rounding of some twenty blocks");
}

}  // namespace coppermoon::extremes::invariances_test
