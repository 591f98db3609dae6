// SPDX-License-Identifier: MIT
#include "uses/fit/air_fit.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include "almanac/instant.h"
#include "colour/working_space.h"
#include "eclipse/shadow_axis.h"
#include "support/testing.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses::air_fit_test {

constexpr std::size_t bins = 4;

/// Light of places of the shadow, from near the axis to the umbra's edge.
FittedLight light_of_the_shadow(const std::optional<AirRange>& range = {},
                                Unknowns unknowns = Unknowns::amounts,
                                FittedAirs airs = FittedAirs::fine) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:40:00Z"));
  LitBins all{
      moonlight_weights(colour::channel_weights(colour::WorkingSpace::ciexyz_d65, band_edges_nm())),
      {},
      bins};
  auto place = eclipse::place_in_shadow(eclipse::shadow_axis(sky), sky.moon_m);
  for (std::size_t b = 0; b < bins; ++b) {
    place.axis_distance = algebra::kilometres(500 + 1200 * static_cast<double>(b));
    all.places.push_back({place, 1, b});
  }
  LightRequest request;
  if (unknowns == Unknowns::amounts) request.air.atmosphere = "undated";
  return {request, unknowns, std::span(&sky, 1), std::span(&all, 1), airs, {}, range};
}

/// Air found where X, Y and Z of all places are those of some light, with a relative error.
AirFit fitted_to(const FittedLight& light, const algebra::Grid<double>& truth, double error,
                 double least_scale = 1) {
  const DataSet data{light,
                     [&](const algebra::Grid<double>& found) {
                       double sum = 0;
                       for (std::size_t i = 0; i < truth.values().size(); ++i)
                         sum +=
                             std::pow(std::log(found.values()[i] / truth.values()[i]) / error, 2);
                       return GoodnessOfFit{sum};
                     },
                     3 * bins, least_scale};
  return fitted_air(std::span(&data, 1));
}

/// Widths of the intervals found where X, Y and Z of all places have a relative error.
std::array<double, 3> widths(const FittedLight& light, double error) {
  const auto fit = fitted_to(light, light.at({4e-6, 0.4, 300}), error);
  std::array<double, 3> all{};
  for (std::size_t a = 0; a < 3; ++a)
    all[a] = fit.posterior.estimates[a].high - fit.posterior.estimates[a].low;
  return all;
}

TEST(AirFit, IntervalsAreNoWiderThanTheErrors) {
  const auto light = light_of_the_shadow();
  const auto wide = widths(light, 0.02), narrow = widths(light, 0.002);
  for (std::size_t a = 0; a < 3; ++a)
    EXPECT_WITHIN_RELATIVE(
        narrow[a], wide[a] / 10, 0.2,
        "steps of one deviation, between which the density is linear, widen by a "
        "tenth; light is not linear over the wide interval")
        << a;
}

TEST(AirFit, OfEditedPhotographsIsThatOfLargerErrors) {
  const auto light = light_of_the_shadow();
  const auto truth = light.at({4e-6, 0.4, 300});
  const auto edited = fitted_to(light, truth, 0.002, 9), larger = fitted_to(light, truth, 0.006);
  for (std::size_t a = 0; a < 3; ++a) {
    const auto &one = edited.posterior.estimates[a], &other = larger.posterior.estimates[a];
    EXPECT_WITHIN(one.low, other.low, 1e-6 * std::abs(other.low), "rounding") << a;
    EXPECT_WITHIN(one.high, other.high, 1e-6 * std::abs(other.high), "rounding") << a;
  }
}

/// A fit whose intervals are as wide as said, of logarithms of aerosol and cloud.
AirFit fit_of(double aerosol, double cloud, double ozone, double width) {
  AirFit fit;
  fit.unknowns = Unknowns::factors;
  const std::array<double, 3> places{std::log(aerosol), std::log(cloud), ozone};
  for (std::size_t a = 0; a < places.size(); ++a)
    fit.posterior.estimates[a] = {places[a], places[a] - width / 2, places[a] + width / 2};
  return fit;
}

TEST(AirFit, IsLookedAtAgainAboutWhatIsProbable) {
  const auto whole = whole_range(Unknowns::factors);
  const auto narrow = range_about(fit_of(2, 1, 1, 0.01));  // by the least lengths
  EXPECT_WITHIN_RELATIVE(narrow[0][1], 2 * std::exp(0.005 + 0.25), 1e-9, "rounding");
  EXPECT_WITHIN_RELATIVE(narrow[1][0], std::exp(-0.005 - 0.25), 1e-9, "rounding");
  EXPECT_WITHIN_RELATIVE(narrow[2][0], 1 - 0.005 - 0.1, 1e-9, "rounding");
  const auto wide = range_about(fit_of(2, 4, 1, 0.4));
  EXPECT_WITHIN_RELATIVE(wide[0][0], 2 * std::exp(-0.2 - 1.2), 1e-9, "rounding");
  EXPECT_EQ(wide[1][1], whole[1][1]);  // the prior's end

  EXPECT_TRUE(is_well_within(fit_of(2, 1, 1, 0.01), narrow));
  EXPECT_TRUE(is_well_within(fit_of(19, 4.9, 1, 0.2), whole));
  EXPECT_FALSE(is_well_within(fit_of(2.5, 1, 1, 0.1), narrow));
  EXPECT_FALSE(is_well_within(fit_of(2, 1, 0.9, 0.01), narrow));
}

TEST(AirFit, OfLightInARangeStaysInIt) {
  const auto light = light_of_the_shadow(AirRange{{{3e-6, 5e-6}, {0, 1}, {250, 350}}});
  const auto truth = light.at({4e-6, 0.4, 300});
  const auto fit = fitted_to(light, truth, 0.002);
  const auto& [aerosol, cloud, ozone] = fit.posterior.estimates;
  EXPECT_WITHIN_RELATIVE(std::exp(aerosol.median), 4e-6, 0.01, "a tenth of an interval");
  EXPECT_WITHIN(cloud.median, 0.4, 0.01, "a tenth of an interval");
  EXPECT_WITHIN_RELATIVE(ozone.median, 300, 0.01, "a tenth of an interval");
  EXPECT_GT(aerosol.information, 0.99);  // beside the whole prior, not the range
  const auto none = fitted_to(light, truth, 1e3);
  EXPECT_GE(none.posterior.estimates[0].low, std::log(3e-6));
  EXPECT_LE(none.posterior.estimates[0].high, std::log(5e-6));
}

/// Light in air of a month, whose values do not matter.
const FittedLight& light_of_a_month() {
  static const auto light = light_of_the_shadow({}, Unknowns::factors, FittedAirs::coarse);
  return light;
}

TEST(AirFit, OfDataThatSayNothingIsThePriorAroundTheMonth) {
  const DataSet data{light_of_a_month(), [](const auto&) { return GoodnessOfFit{0}; }, 10};
  const auto fit = fitted_air(std::span(&data, 1));
  const auto& [aerosol, cloud, ozone] = fit.posterior.estimates;
  for (const auto* estimate : {&aerosol, &cloud}) {
    EXPECT_WITHIN(estimate->median, 0, 0.07, "the limits of the range; a tenth of a deviation");
    EXPECT_WITHIN(estimate->low, -0.7, 0.07, "a tenth of a deviation");
    EXPECT_WITHIN(estimate->high, 0.7, 0.07, "a tenth of a deviation");
    EXPECT_LT(estimate->information, 0.1);
  }
  EXPECT_WITHIN(ozone.median, 1, 0.015, "a tenth of a deviation");
  EXPECT_WITHIN(ozone.high - ozone.low, 0.3, 0.03, "a tenth of a deviation");
  EXPECT_WITHIN(fit.best[0], 1, 0.15, "half a step of the grid");
}

TEST(AirFit, OfDataIsTheirProductWithThePrior) {
  const auto& light = light_of_a_month();
  const AirNumbers truth{1.3, 0.9, 1.05};
  const glm::dvec3 place(std::log(truth[0]), std::log(truth[1]), truth[2]), prior(0, 0, 1);
  const auto logarithm = [&](const glm::dvec3& at, std::size_t i) {
    return std::log(light.at({std::exp(at.x), std::exp(at.y), at.z}).values()[i]);
  };
  for (const double error : {0.003, 0.03}) {
    // product of two normal distributions, where light is linear in the unknowns
    glm::dmat3 data(0), of_prior(0);
    for (int a = 0; a < 3; ++a) of_prior[a][a] = a < 2 ? 1 / (0.7 * 0.7) : 1 / (0.15 * 0.15);
    for (std::size_t i = 0; i < 3 * bins; ++i) {
      glm::dvec3 slope(0);
      for (int a = 0; a < 3; ++a) {
        glm::dvec3 step(0);
        step[a] = 0.02;
        slope[a] = (logarithm(place + step, i) - logarithm(place - step, i)) / 0.04;
      }
      data += glm::outerProduct(slope, slope) / (error * error);
    }
    const auto covariance = glm::inverse(data + of_prior);
    const auto mean = covariance * (data * place + of_prior * prior);
    const auto fit = fitted_to(light, light.at(truth), error);
    for (int a = 0; a < 3; ++a) {
      const auto& [median, low, high, information] =
          fit.posterior.estimates[static_cast<std::size_t>(a)];
      const double deviation = std::sqrt(covariance[a][a]);
      EXPECT_WITHIN(median, mean[a], 0.25 * deviation, "light is not linear over the interval")
          << error << ' ' << a;
      EXPECT_WITHIN_RELATIVE((high - low) / 2, deviation, 0.15,
                             "light is not linear over the interval")
          << error << ' ' << a;
    }
  }
}

}  // namespace coppermoon::uses::air_fit_test
