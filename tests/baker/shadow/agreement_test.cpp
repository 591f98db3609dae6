// SPDX-License-Identifier: MIT
// Every way to the same light agrees with a fine quadrature within its stated error; and this would
// be seen to fail had a wavelength, a region or the dust been lost on the way.
#include <ostream>

#include "atmosphere/presets.h"
#include "shadow/by_photons.h"
#include "shadow/by_quadrature.h"
#include "shadow/lookup.h"
#include "support/testing.h"

namespace coppermoon::shadow::agreement_test {

const Arrangement arrangement{1.479e11, {3.83e8}, true};

/// Light of one run, cell by cell: of a wavelength, a place (or ring) and a sector.
struct Cells {
  std::vector<double> value, error;  ///< error: 0 where a bound is stated instead
};

/// Makes the air that is meant.
using Air = atmosphere::Atmosphere (*)();

/// Whether they are the same but for what is stated.
using Agreement = std::function<bool(const Cells& found, const Cells& exact)>;

/// A way to the light, its reference, and the error it states.
struct Way {
  const char* name;
  std::function<Cells(const atmosphere::Atmosphere&, std::span<const double> waves)> light, exact;
  Agreement agrees;
  const char* reference;  ///< names that which is exact
};

void PrintTo(const Way& way, std::ostream* out) { *out << way.name; }

Agreement within(double relative) {
  return [=](const Cells& found, const Cells& exact) {
    for (std::size_t i = 0; i < exact.value.size(); ++i)
      if (!(std::abs(found.value[i] - exact.value[i]) <= relative * exact.value[i])) return false;
    return true;
  };
}

/// Agreement of each wavelength within a part of the light of all together, which stand one beside
/// the other.
Agreement within_all_light(double relative, std::size_t waves) {
  return [=](const Cells& found, const Cells& exact) {
    for (std::size_t i = 0; i < exact.value.size(); i += waves) {
      const auto from = exact.value.begin() + static_cast<std::ptrdiff_t>(i);
      const double all = std::accumulate(from, from + static_cast<std::ptrdiff_t>(waves), 0.);
      for (std::size_t w = i; w < i + waves; ++w)
        if (!(std::abs(found.value[w] - exact.value[w]) <= relative * all)) return false;
    }
    return true;
  };
}

/// chi² below its 0.9995 quantile (Wilson & Hilferty): one true run in two thousand fails.
///
/// Given  blocks  that errors are known from: t² of ν freedoms has the mean ν/(ν − 2)
Agreement within_noise(double blocks) {
  return [=](const Cells& found, const Cells& exact) {
    double chi_squared = 0;
    for (std::size_t i = 0; i < exact.value.size(); ++i)
      chi_squared += std::pow((found.value[i] - exact.value[i]) / found.error[i], 2);
    const auto freedom = static_cast<double>(exact.value.size());
    const double third = 2 / (9 * freedom);
    return chi_squared * (blocks - 3) / (blocks - 1) <
           freedom * std::pow(1 - third + 3.29 * std::sqrt(third), 3);
  };
}

/// 300 to 4300 km from the axis: where light comes through the air alone.
const std::vector<double> places{3e5, 9.1e5, 1.5e6, 2.13e6, 2.77e6, 3.3e6, 3.95e6, 4.3e6};

void append(const RefractedLight& light, std::size_t sector, std::size_t first, std::size_t count,
            Cells& cells) {
  for (std::size_t d = first; d < first + count; ++d)
    for (std::size_t w = 0; w < light.wavelengths_nm.size(); ++w) {
      cells.value.push_back(light.ratio[sector](d, w));
      cells.error.push_back(light.standard_error.empty() ? 0 : light.standard_error[sector](d, w));
    }
}

Cells by_rays(const atmosphere::Atmosphere& air, std::span<const double> waves, int rays) {
  const auto light = by_quadrature(air, arrangement, waves, places, {.rays = rays});
  Cells cells;
  for (std::size_t s = 0; s < light.sectors; ++s) append(light, s, 0, places.size(), cells);
  return cells;
}

Cells finely(const atmosphere::Atmosphere& air, std::span<const double> waves) {
  return by_rays(air, waves, 8000);
}

Way quadrature(const char* name, int rays, double stated) {
  const auto light = [=](const auto& air, std::span<const double> waves) {
    return by_rays(air, waves, rays);
  };
  return {name, light, finely, within(stated), "finely"};
}

/// From places 1000 km apart, and those that the solver puts between, read from a look-up.
Cells between_places(const atmosphere::Atmosphere& air, std::span<const double> waves) {
  const std::vector<double> few{0, 1e6, 2e6, 3e6, 4e6, 5e6};
  const auto light =
      by_quadrature(air, arrangement, waves, few, {.rays = 1000, .place_error = 1e-3});
  ChannelWeights each(waves.size(), waves.size());
  for (std::size_t w = 0; w < waves.size(); ++w) each(w, w) = 1;
  const Lookup lookup(light, DirectLight(air, arrangement, waves), each, {.to_m = 5e6});
  Cells cells;
  std::vector<double> values(waves.size());
  for (std::size_t s = 0; s < light.sectors; ++s)
    for (const double place : places) {
      const auto turn = static_cast<double>(s) / static_cast<double>(light.sectors);
      lookup.read({.axis_distance = algebra::metres(place),
                   .position_angle = algebra::degrees(360 * turn),
                   .depth = algebra::metres(arrangement.depths_m[0])},
                  values);
      cells.value.insert(cells.value.end(), values.begin(), values.end());
    }
  return cells;
}

/// The rings and sectors that photons gather in.
struct Gathering {
  double ring_m;
  std::size_t rings, sectors;
};

/// The first ring is left out: too few photons land there for a normal law.
Cells gathered(const RefractedLight& light, const Gathering& in) {
  Cells cells;
  for (std::size_t s = 0; s < in.sectors; ++s) append(light, s, 1, in.rings - 1, cells);
  return cells;
}

Cells by_photons_of(const atmosphere::Atmosphere& air, std::span<const double> waves,
                    const Gathering& in, std::uint64_t photons, bool literal) {
  PhotonSettings settings;
  settings.photons = photons;
  settings.literal = literal;
  settings.ring_width_m = in.ring_m;
  settings.sectors = in.sectors;
  return gathered(means_over_rings(traced(air, arrangement, waves, settings)), in);
}

/// Position angles that the mean over a sector is taken from.
constexpr std::size_t angles_around = 96;

/// What a position angle counts in the mean over a sector about 0, of those every 3.75 degrees:
/// trapezoids, for sectors as wide as several of them.
double share(int steps_away, std::size_t sectors) {
  const int half = static_cast<int>(angles_around / sectors / 2);
  if (std::abs(steps_away) > half) return 0;
  return (std::abs(steps_away) == half ? 0.5 : 1.0) / (2 * half);
}

/// The quadrature's mean over each of them, by area.
Cells means(const atmosphere::Atmosphere& air, std::span<const double> waves, const Gathering& in) {
  constexpr std::size_t inside = 8;
  std::vector<double> distances;
  for (std::size_t i = 0; i < in.rings * inside; ++i)
    distances.push_back((static_cast<double>(i) + 0.5) / inside * in.ring_m);
  const auto fine =
      by_quadrature(air, arrangement, waves, distances, {.rays = 1000, .sectors = {angles_around}});
  Cells cells;
  const int wide = static_cast<int>(fine.sectors / in.sectors);
  for (std::size_t s = 0; s < in.sectors; ++s)
    for (std::size_t r = 1; r < in.rings; ++r)
      for (std::size_t w = 0; w < waves.size(); ++w) {
        double sum = 0, area = 0;
        for (std::size_t d = r * inside; d < (r + 1) * inside; area += distances[d++])
          for (int k = -wide / 2; k <= wide / 2; ++k) {
            const auto at = static_cast<std::size_t>(static_cast<int>(s) * wide + k +
                                                     static_cast<int>(fine.sectors)) %
                            fine.sectors;
            sum += distances[d] * share(k, in.sectors) * fine.ratio[at](d, w);
          }
        cells.value.push_back(sum / area);
      }
  return cells;
}

Way photons(const char* name, Gathering in, std::uint64_t count, bool literal) {
  return {name,
          [=](const auto& air, std::span<const double> waves) {
            return by_photons_of(air, waves, in, count, literal);
          },
          [=](const auto& air, std::span<const double> waves) { return means(air, waves, in); },
          within_noise(static_cast<double>(count) / photons_a_block), name};
}

// by_quadrature.h: 1.3e-3 at 300 rays and 1.5e-4 at 1000, at any wavelength. Between places 1e-3 of
// all light is the solver's, 1e-4 the look-up's and 1.5e-4 the rays'.
const std::vector<Way> ways{
    quadrature("quadrature of 300 rays", 300, 1.3e-3),
    quadrature("quadrature of 1000 rays", 1000, 1.5e-4),
    {"quadrature between places", between_places, finely, within_all_light(1.25e-3, 3), "finely"},
    photons("photons by the table", {500e3, 9, 4}, 1'000'000, false),
};

/// Minutes of them: tests/thorough.sh has the time.
const Way to_the_letter = photons("photons literal", {1000e3, 5, 4}, 20'480, true);

class EveryWay : public testing::TestWithParam<Way> {
 protected:
  const std::vector<double> waves{450, 550, 650};

  /// Whether the light of some air agrees with that of the air that is meant.
  bool agrees(const atmosphere::Atmosphere& given, Air meant,
              const std::vector<double>& given_waves) const {
    return GetParam().agrees(GetParam().light(given, given_waves), exact(meant));
  }

 private:
  /// Once for all tests and ways that ask for it.
  const Cells& exact(Air meant) const {
    static std::map<std::pair<std::string, Air>, Cells> all;
    auto& cells = all[{GetParam().reference, meant}];
    if (cells.value.empty()) cells = GetParam().exact(meant(), waves);
    return cells;
  }
};

const auto december = algebra::degrees(-20);

/// Standard air with a layer of dust all around.
atmosphere::Atmosphere dusty() {
  auto air = atmosphere::preset("undated", december);
  air.column.dust_extinction_per_m = 2e-6;
  return air;
}

/// Standard air with much of it over the south.
atmosphere::Atmosphere dusty_south() {
  auto air = atmosphere::preset("undated", december);
  auto column = air.column;
  column.dust_extinction_per_m = 4e-6;
  air.regions = {
      *atmosphere::between_latitudes(algebra::degrees(-90), algebra::degrees(0), december, column)};
  return air;
}

atmosphere::Atmosphere of_a_month() { return atmosphere::preset("standard", december, 2010.97); }

TEST_P(EveryWay, AgreesInStandardAirWithDust) { EXPECT_TRUE(agrees(dusty(), dusty, waves)); }

TEST_P(EveryWay, AgreesWhereTheSouthIsDusty) {
  EXPECT_TRUE(agrees(dusty_south(), dusty_south, waves));
}

TEST_P(EveryWay, AgreesInTheAirOfAMonth) { EXPECT_TRUE(agrees(of_a_month(), of_a_month, waves)); }

TEST_P(EveryWay, IsSeenToDifferWithoutTheDust) {
  auto clean = dusty();
  clean.column.dust_extinction_per_m = 0;
  EXPECT_FALSE(agrees(clean, dusty, waves));
}

TEST_P(EveryWay, IsSeenToDifferWithoutTheRegion) {
  auto alike = dusty_south();
  alike.regions.clear();
  EXPECT_FALSE(agrees(alike, dusty_south, waves));
}

TEST_P(EveryWay, IsSeenToDifferWithAWavelengthMovedBy20Nanometres) {
  EXPECT_FALSE(agrees(dusty(), dusty, {450, 550, 630}));
}

std::string name_of(const testing::TestParamInfo<Way>& one) {
  std::string name = one.param.name;
  for (char& c : name)
    if (c == ' ') c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(ToTheLight, EveryWay, testing::ValuesIn(ways), name_of);
INSTANTIATE_TEST_SUITE_P(ToTheLightThoroughly, EveryWay, testing::Values(to_the_letter), name_of);

/// Rays so close that light of six planes does not fit into 1.25 GB, while that of one does.
TEST(ByQuadrature, OfPlanesTogetherIsThatOfEachByItself) {
  const atmosphere::Atmosphere air{.earth = atmosphere::ellipsoid(0.2)};
  std::vector<double> waves;
  for (int i = 0; i < 40; ++i) waves.push_back(400 + 8 * i);
  const std::vector<double> gammas{3e6, 3.5e6, 4e6, 4.5e6, 5e6};
  const std::vector<double> depths{3.79e8, 3.80e8, 3.81e8, 3.82e8, 3.83e8, 3.84e8};
  const QuadratureSettings settings{.rays = 12000, .sectors = {4}, .place_error = 1e-4};
  const auto all = by_quadrature(air, {1.5e11, depths}, waves, gammas, settings);
  EXPECT_GT(all.axis_distances_m.size(), gammas.size()) << "more places are put between";
  for (std::size_t plane = 0; plane < depths.size(); ++plane) {
    const auto one = by_quadrature(air, {1.5e11, {depths[plane]}}, waves, gammas,
                                   {.rays = settings.rays, .sectors = {4}});
    for (std::size_t d = 0; d < gammas.size(); ++d) {
      const auto there = std::ranges::find(all.axis_distances_m, gammas[d]);
      ASSERT_NE(there, all.axis_distances_m.end());
      const auto at = static_cast<std::size_t>(there - all.axis_distances_m.begin());
      for (std::size_t s = 0; s < 4; ++s)
        for (std::size_t w = 0; w < waves.size(); ++w)
          EXPECT_EQ(all.ratio[plane * 4 + s](at, w), one.ratio[s](d, w));
    }
  }
}

}  // namespace coppermoon::shadow::agreement_test
