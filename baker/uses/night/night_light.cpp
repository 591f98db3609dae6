// SPDX-License-Identifier: MIT
#include "uses/night/night_light.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "algebra/error.h"
#include "atmosphere/sky_luminance.h"
#include "eclipse/shadow_axis.h"
#include "uses/picture/brightness.h"
#include "uses/picture/clear_sky.h"

namespace coppermoon::uses {
namespace {

using almanac::Instant;

/// Level to which the umbra's median light is exposed, and highest level for the sky, both relative to saturation.
constexpr double umbra_level = 0.18, most_sky_level = 0.5;
/// A place counts as being in the umbra if it is fainter than the disc's brightest places by more than this factor.
constexpr double umbra_contrast = 200;
/// The umbra gets an exposure time of its own if it covers more than this share of the disc.
constexpr double least_umbra_share = 0.02;
/// Time between a contact and the exposure just before or after it.
constexpr double beside_contact_s = 60;

/// Colours of a texture at places that are evenly spread over the disc seen from the Earth.
std::vector<Rgb> disc_of(const texture::Image& texture, const almanac::SkyState& sky) {
  constexpr int side = 120;
  constexpr double edge = 0.995;  // texels nearer to the limb are seen edge-on
  const auto towards = almanac::selenographic_direction(sky.sub_earth),
             east = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), towards)),
             north = glm::cross(towards, east);
  const auto rows = static_cast<double>(texture.height);
  std::vector<Rgb> disc;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const double x = (2 * i + 1.) / side - 1, y = (2 * j + 1.) / side - 1, r2 = x * x + y * y;
      if (r2 > edge * edge) continue;
      const auto ground = std::sqrt(1 - r2) * towards + x * east + y * north;
      const double latitude = std::asin(ground.z), longitude = std::atan2(ground.y, ground.x);
      const auto r = static_cast<std::size_t>((0.5 - latitude / std::numbers::pi) * rows),
                 c = static_cast<std::size_t>((longitude / std::numbers::pi + 1) * rows);
      const auto column = std::min(c, texture.width - 1);
      disc.push_back({texture(r, column, 0), texture(r, column, 1), texture(r, column, 2)});
    }
  return disc;
}

/// The light that reaches the camera: the disc, as seen through the air, and the sky in front of it.
struct Exposed {
  std::vector<Rgb> disc;
  Rgb sky;
  double spread;  ///< standard error of the light in the umbra, as a factor
  bool total;     ///< whether all of the disc is in the umbra
};

/// Finds exposure times for a camera's f-number and speed.
class Exposer {
 public:
  Exposer(const Development& development, std::optional<double> trailing_s, double longest_s)
      : development_(development), trailing_s_(trailing_s), longest_s_(longest_s) {
    development_.time = {ExposureTime::Rule::fixed, 1};
    const auto second = exposures_for(development_, texture::Image(1, 1, {"R", "G", "B"}),
                                      colour::WorkingSpace::linear_rec709)
                            .shorter;
    per_second_ = scale_of(development_, second);
    f_number_ = second.f_number;
    development_.time.rule = ExposureTime::Rule::automatic;
  }

  double f_number() const { return f_number_; }

  /// Sets the exposure times in `phase`.
  void expose(PhaseExposure& phase, const Exposed& seen) const {
    std::vector<Rgb> dark;
    const double brightest = brightest_of(seen.disc, 0.99);
    for (const auto& colour : seen.disc)
      if (std::ranges::max(colour) < brightest / umbra_contrast) dark.push_back(colour);
    const bool partial = static_cast<double>(dark.size()) >
                         least_umbra_share * static_cast<double>(seen.disc.size());
    phase.lit = limited(phase, seen.sky, seen.total ? seen.spread : 1,
                        [&](double factor, Rgb sky) { return lit_s(seen.disc, factor, sky); });
    if (!partial) return;
    const double median = brightest_of(dark, 0.5);
    phase.shadow = limited(phase, seen.sky, seen.spread, [&](double factor, const Rgb& sky) {
      return umbra_level / ((factor * median + std::ranges::max(sky)) * per_second_);
    });
  }

 private:
  /// Quantile of the brightest channels of all colours. For example, a share of 0.5 returns the median.
  static double brightest_of(const std::vector<Rgb>& colours, double share) {
    std::vector<double> levels;
    for (const auto& colour : colours) levels.push_back(std::ranges::max(colour));
    const auto place =
        levels.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(levels.size()));
    std::ranges::nth_element(levels, place);
    return *place;
  }

  double lit_s(const std::vector<Rgb>& disc, double factor, const Rgb& sky) const {
    texture::Image frame(disc.size(), 1, {"R", "G", "B"});
    for (std::size_t i = 0; i < disc.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        frame(0, i, k) = static_cast<float>(factor * disc[i][k] + sky[k]);
    return exposures_for(development_, frame, colour::WorkingSpace::linear_rec709).shorter.time_s;
  }

  /// Exposure times for a part of the Moon, limited by trailing and by the sky's light. Returns nothing if the part
  /// needs more than the longest time allowed.
  template <class Time>
  std::optional<PartExposure> limited(PhaseExposure& phase, const Rgb& sky, double spread,
                                      const Time& time_of) const {
    constexpr double third_of_a_stop = 1.26;
    const double most_s = most_sky_level / (std::ranges::max(sky) * per_second_),
                 wanted = std::min(time_of(1, sky), most_s);
    if (wanted > longest_s_) {
      phase.too_dark = true;
      return {};
    }
    phase.by_sky |= wanted * third_of_a_stop < time_of(1, {0, 0, 0});
    const double longest = std::min(most_s, trailing_s_.value_or(longest_s_));
    const auto at = [&](double factor) { return std::min(time_of(factor, sky), longest); };
    const double time = at(1);
    return PartExposure{time, at(spread), at(1 / spread), std::log2(wanted / time)};
  }

  Development development_;
  std::optional<double> trailing_s_;
  double longest_s_, per_second_ = 1, f_number_ = 1;
};

/// Exposure times for a phase, from the Moon as it is seen at the given moment.
PhaseExposure exposure_of(const std::string& name, const Instant& when, const EclipseLight& light,
                          const ViewRequest& view, const Exposer& exposer, double spread,
                          bool total) {
  const auto sky = almanac::sky_at(when);
  const auto seen = moon_and_sky(light.brightness(sky), sky, view);
  PhaseExposure phase{name, when, seen.stands_out(), seen.sky_cd_m2 / seen.seen_cd_m2};
  if (!phase.seen) return phase;
  const auto colours = light.colours(sky, view_of(view, sky).sightline);
  exposer.expose(phase, {disc_of(colours, sky), seen.sky_light, spread, total});
  return phase;
}

NightLight light_at(const EclipseLight& light, const NightMoment& moment, const ViewRequest& view) {
  const auto sky = almanac::sky_at(moment.when);
  const auto seen = moon_and_sky(light.brightness(sky), sky, view);
  const double star = faintest_star(seen.zenith_cd_m2);
  return {moment.name,
          moment.when,
          seen.V_magnitude,
          seen.mean_luminance_cd_m2,
          star > 0 ? std::optional(star) : std::nullopt,
          moment.up ? std::optional(seen.sky_cd_m2) : std::nullopt};
}

/// Whether the Moon's lower limb is above the horizon.
bool wholly_up(const almanac::Observer& place, const Instant& when) {
  const auto sky = almanac::sky_at(when);
  const double radius =
      std::asin(almanac::lunar_radius / almanac::view_from(place, sky).moon_distance);
  return algebra::in_radians(above_horizon(place, sky)) > 2 * radius;
}

/// Share of the Moon's diameter in the umbra, from how much nearer the Moon is to the shadow's axis than it was at U1.
double immersed(const Instant& u1, const Instant& when) {
  const auto distance_m = [](const Instant& then) {
    return algebra::in_metres(eclipse::moon_in_shadow(almanac::sky_at(then)).axis_distance);
  };
  return (distance_m(u1) - distance_m(when)) / (2 * algebra::in_metres(almanac::lunar_radius));
}

/// Moment between a contact (U1 or U4) and greatest eclipse at which `share` of the Moon's diameter is in the umbra.
Instant moment_of_share(const Instant& contact, const Instant& greatest, double share) {
  const double seconds = almanac::seconds_between(contact, greatest);
  double from = 0, to = 1;
  while ((to - from) * std::abs(seconds) > 1) {
    const double middle = (from + to) / 2;
    (immersed(contact, almanac::later(contact, middle * seconds)) < share ? from : to) = middle;
  }
  return almanac::later(contact, to * seconds);
}

/// Phases for which exposure times are given, with their moments, in order of time.
std::vector<std::pair<std::string, Instant>> phases_of(const Circumstances& night) {
  const auto& eclipse = night.eclipse;
  const auto& c = eclipse.contacts;
  const auto beside = [](const Instant& contact, double side) {
    return almanac::later(contact, side * beside_contact_s);
  };
  std::vector<std::pair<std::string, Instant>> phases{{"full Moon, before P1", beside(*c.P1, -1)},
                                                      {"full Moon, after P4", beside(*c.P4, 1)}};
  phases.emplace_back(c.U2   ? "middle of totality"
                      : c.U1 ? "greatest, in the umbra"
                             : "greatest, in the penumbra",
                      eclipse.greatest);
  if (c.U1) {
    phases.emplace_back("penumbral, just before U1", beside(*c.U1, -1));
    phases.emplace_back("penumbral, just after U4", beside(*c.U4, 1));
    for (const auto& [name, share] : {std::pair{"partial, a quarter", 0.25},
                                      {"partial, half", 0.5},
                                      {"partial, three quarters", 0.75},
                                      {"partial, 95 %", 0.95}})
      if (share < eclipse.umbral_magnitude)
        for (const auto& [contact, way] : {std::pair{*c.U1, ""}, {*c.U4, ", leaving"}})
          phases.emplace_back(std::string(name) + way,
                              moment_of_share(contact, eclipse.greatest, share));
  }
  if (c.U2) phases.emplace_back("totality, just after U2", beside(*c.U2, 1));
  if (c.U3) phases.emplace_back("totality, just before U3", beside(*c.U3, -1));
  for (const auto& moment : night.moments)
    if (moment.name.ends_with(" seen")) phases.emplace_back(moment.name, moment.when);
  std::ranges::stable_sort(phases, [](const auto& a, const auto& b) {
    return almanac::seconds_between(a.second, b.second) > 0;
  });
  std::erase_if(phases, [&](const auto& phase) { return !wholly_up(night.place, phase.second); });
  return phases;
}

/// Progress function for a part of the work. The part's fractions 0 to 1 are reported to `whole` as `from` to `to`.
algebra::Progress part_of(const algebra::Progress& whole, double from, double to) {
  if (!whole) return {};
  return [whole, from, to](double fraction) { whole(std::lerp(from, to, fraction)); };
}

/// Exposure times for mid-totality at L = 4 to 0 on Danjon's scale, except those L at which the Moon would not be seen.
std::vector<PhaseExposure> danjon_exposures(const Instant& greatest, const MoonRequest& moon,
                                            const EclipseLight& light, const ViewRequest& view,
                                            const Exposer& exposer,
                                            const algebra::Progress& progress) {
  constexpr std::size_t steps = 5;
  const auto sky = almanac::sky_at(greatest);
  std::vector<MoonRequest> requests(steps, moon);
  std::vector<ShadowedMoon> moons;
  for (std::size_t i = 0; i < steps; ++i) {
    requests[i].light.air.column.danjon = static_cast<int>(steps - 1 - i);
    moons.push_back(shadowed_moon(requests[i].light, sky));
  }
  std::vector<PhaseExposure> exposures(steps);
  std::atomic<int> done = 0;
  tbb::parallel_for(
      std::size_t{0}, steps,
      [&](std::size_t i) {
        const EclipseLight lit(
            requests[i], light.albedo(),
            light_on_the_way(requests[i].light, moons[i], {.error_told = false}));
        exposures[i] = exposure_of(fmt::format("middle of totality, L = {}", steps - 1 - i),
                                   greatest, lit, view, exposer, 1, true);
        if (progress) progress(static_cast<double>(++done) / steps);
      },
      tbb::simple_partitioner());
  std::erase_if(exposures, [](const PhaseExposure& phase) { return !phase.seen; });
  return exposures;
}

/// Time in which the Moon's image trails by two pixels; nothing without a focal length. Unknown pixels count as 4 µm.
std::optional<double> trailing_of(const Circumstances& night, const ViewRequest& view,
                                  const Development& development) {
  constexpr double usual_pixel_um = 4;
  if (!view.focal_length_mm) return {};
  const auto camera = camera_of(development.camera);
  return trailing_time_s(night, *view.focal_length_mm,
                         2 * (camera ? camera->sensor.pixel_um : usual_pixel_um));
}

}  // namespace

NightLights night_lights(const Circumstances& night, const MoonRequest& moon,
                         const ViewRequest& view, const Development& development, bool danjon,
                         const algebra::Progress& progress) {
  const auto& eclipse = night.eclipse;
  const bool steps = danjon && eclipse.contacts.U2 && wholly_up(night.place, eclipse.greatest);
  const double done = steps ? 0.25 : 1;
  const EclipseLight light(eclipse, moon, part_of(progress, 0, done));
  NightLights lights{as_seen(
      night, [&](const auto& sky) { return light.brightness(sky); }, view)};
  lights.trailing_s = trailing_of(night, view, development);
  const Exposer exposer(development, lights.trailing_s,
                        almanac::seconds_between(*eclipse.contacts.P1, *eclipse.contacts.P4));
  lights.f_number = exposer.f_number();
  lights.iso = development.iso;
  if (eclipse.contacts.U2)
    lights.V_error = totality_error_mag(moon.light.air, almanac::year_of(eclipse.greatest));
  for (const auto& moment : lights.night.moments)
    if (!moment.name.starts_with("moon")) lights.moments.push_back(light_at(light, moment, view));
  if (lights.night.seen.empty()) return lights;
  const double spread = std::pow(10, 0.4 * lights.V_error.value_or(0));
  for (const auto& [phase, when] : phases_of(lights.night)) {
    const bool total =
        eclipse.contacts.U2 && holds({*eclipse.contacts.U2, *eclipse.contacts.U3}, when);
    lights.exposures.push_back(exposure_of(phase, when, light, view, exposer, spread, total));
    if (!steps || phase != "middle of totality") continue;
    for (auto& each :
         danjon_exposures(when, moon, light, view, exposer, part_of(progress, done, 1)))
      lights.exposures.push_back(std::move(each));
  }
  return lights;
}

double camera_time_s(double seconds) {
  static constexpr double parts[] = {8000, 6400, 5000, 4000, 3200, 2500, 2000, 1600, 1250,
                                     1000, 800,  640,  500,  400,  320,  250,  200,  160,
                                     125,  100,  80,   60,   50,   40,   30,   25,   20,
                                     15,   13,   10,   8,    6,    5,    4},
                          whole[] = {0.3, 0.4, 0.5, 0.6, 0.8, 1,  1.3, 1.6, 2,  2.5, 3.2,
                                     4,   5,   6,   8,   10,  13, 15,  20,  25, 30};
  if (seconds > 34) return seconds;
  double best = whole[0];
  const auto try_time = [&](double time) {
    if (std::abs(std::log(time / seconds)) < std::abs(std::log(best / seconds))) best = time;
  };
  for (const double part : parts) try_time(1 / part);
  for (const double time : whole) try_time(time);
  return best;
}

double trailing_time_s(const Circumstances& night, double focal_length_mm, double trail_um) {
  algebra::require_within("focal length [mm]", focal_length_mm, 1, 1e6);
  constexpr double seconds = 60;
  const auto toward_moon = [&](const Instant& when) {
    const auto moon = apparent_place(night.place, almanac::sky_at(when));
    return in_sky(moon.altitude, moon.azimuth);
  };
  const auto& greatest = night.eclipse.greatest;
  const double turned =
      glm::distance(toward_moon(greatest), toward_moon(almanac::later(greatest, seconds)));
  return trail_um * 1e-3 / (focal_length_mm * turned / seconds);
}

double faintest_star(double sky_cd_m2) {
  const double zero_point = atmosphere::luminance_of_magnitude_cd_m2(0),
               magnitude = -2.5 * std::log10(sky_cd_m2 / zero_point);
  return 7.93 - 5 * std::log10(1 + std::pow(10, 4.316 - magnitude / 5));
}

}  // namespace coppermoon::uses
