// SPDX-License-Identifier: MIT
#include "eclipse/lunation.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <numbers>

namespace coppermoon::eclipse {
namespace {

using almanac::Instant;
using almanac::LunarTheory;

constexpr double sample_spacing_s = 3 * 3600;
constexpr double synodic_month_days = 29.530588861;
constexpr double first_full_moon_tt = 2451550.09766 + 0.5 * synodic_month_days;

/// Centuries from the year 2000 to the full Moon with the given number.
double centuries(double number) { return (number + 0.5) / 1236.85; }

/// Moment of the mean full Moon with the given number, from Meeus (1998), equation 49.1.
Instant mean_full_moon(int number) {
  const double t = centuries(number);
  return almanac::later({first_full_moon_tt, 0},
                        86400 * (synodic_month_days * number + 0.00015437 * t * t));
}

glm::dvec3 on_parabola(const std::array<glm::dvec3, 3>& at, double x) {
  return at[1] + 0.5 * x * ((at[2] - at[0]) + x * (at[2] - 2.0 * at[1] + at[0]));
}

glm::dvec3 moon_m(const Lunation& lunation, double seconds) {
  return almanac::apparent_moon_m(almanac::later(lunation.middle, seconds), LunarTheory::moon98) +
         on_parabola(lunation.added_to_moon98_m, seconds / sample_spacing_s);
}

/// East and north components of the Moon's direction, perpendicular to the shadow axis. The length of this vector is
/// the sine of the Moon's angle from the axis.
glm::dvec2 across_axis(const glm::dvec3& sun_m, const glm::dvec3& moon_m,
                       const glm::dvec3& celestial_pole) {
  const glm::dmat3 shadow_from_gcrs = shadow_axis(sun_m, celestial_pole).shadow_from_gcrs;
  return glm::dvec2(shadow_from_gcrs * glm::normalize(moon_m));
}

/// Time t at which place(t) is nearest to the origin. Each iteration assumes that place(t) moves along the straight
/// line through two neighbouring points.
template <class Place>
double time_of_least_distance_s(Place place, double tolerance_s) {
  constexpr double half_step_s = 300;
  double t = 0;
  for (int round = 0; round < 12; ++round) {
    const glm::dvec2 before = place(t - half_step_s), after = place(t + half_step_s);
    const glm::dvec2 velocity = (after - before) / (2 * half_step_s);
    const double step = -glm::dot(place(t), velocity) / glm::dot(velocity, velocity);
    t += step;
    if (std::abs(step) < tolerance_s) break;
  }
  return t;
}

}  // namespace

int full_moon_number(const Instant& instant) {
  const double days = (instant.tt_day - first_full_moon_tt) + instant.tt_fraction;
  const double t = days / 36525;
  return static_cast<int>(std::lround((days - 0.00015437 * t * t) / synodic_month_days));
}

bool eclipse_is_possible(int number) {
  const double t = centuries(number);
  const double latitude_argument_deg = 160.7108 + 390.67050284 * (number + 0.5) - 0.0016118 * t * t;
  return std::abs(std::sin(latitude_argument_deg * std::numbers::pi / 180)) < 0.36;
}

Instant nearest_to_axis(int number) {
  const Instant mean = mean_full_moon(number);
  const glm::dvec3 pole = glm::transpose(almanac::equator_from_gcrs(mean))[2];
  const auto place = [&](double seconds) {
    const Instant instant = almanac::later(mean, seconds);
    return across_axis(almanac::apparent_sun_m(instant),
                       almanac::apparent_moon_m(instant, LunarTheory::moon98), pole);
  };
  return almanac::later(mean, time_of_least_distance_s(place, 60));
}

Lunation lunation_around(const Instant& middle, LunarTheory theory) {
  Lunation lunation{middle, glm::transpose(almanac::equator_from_gcrs(middle))[2], {}, {}};
  for (int i = 0; i < 3; ++i) {
    const Instant instant = almanac::later(middle, (i - 1) * sample_spacing_s);
    lunation.sun_m[i] = almanac::apparent_sun_m(instant);
    if (theory != LunarTheory::moon98)
      lunation.added_to_moon98_m[i] = almanac::apparent_moon_m(instant, theory) -
                                      almanac::apparent_moon_m(instant, LunarTheory::moon98);
  }
  return lunation;
}

Sighting sighting_at(const Lunation& lunation, double seconds_after_middle) {
  const glm::dvec3 sun_m = on_parabola(lunation.sun_m, seconds_after_middle / sample_spacing_s);
  const ShadowAxis axis = shadow_axis(sun_m, lunation.celestial_pole);
  const glm::dvec3 moon = moon_m(lunation, seconds_after_middle);
  return {axis, place_in_shadow(axis, moon), moon};
}

double least_axis_angle_s(const Lunation& lunation) {
  const auto place = [&](double seconds) {
    const glm::dvec3 sun_m = on_parabola(lunation.sun_m, seconds / sample_spacing_s);
    return across_axis(sun_m, moon_m(lunation, seconds), lunation.celestial_pole);
  };
  return time_of_least_distance_s(place, 0.01);
}

}  // namespace coppermoon::eclipse
