// SPDX-License-Identifier: MIT
// Photographs of eclipses under air that the fit is not told: a hundred under dust and decks of cloud, two hundred in
// any air, these by the program alone.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "algebra/error.h"
#include "algebra/random.h"
#include "colour/glow.h"
#include "end_to_end/program.h"
#include "texture/read_image.h"
#include "texture/write_image.h"
#include "uses/fit/compared_night.h"
#include "uses/picture/pixels.h"

namespace coppermoon::end_to_end {
namespace {

using algebra::Random;

constexpr auto rec709 = colour::WorkingSpace::linear_rec709;
constexpr std::size_t photographs_an_instant = 20, stills_an_instant = 40;
constexpr std::uint64_t seed = 2018;

double between(Random& random, double from, double to) {
  return from + (to - from) * random.uniform();
}

double in_decades(Random& random, double from, double to) {
  return from * std::pow(to / from, random.uniform());
}

double normal(Random& random) {
  return std::sqrt(-2 * std::log(1 - random.uniform())) *
         std::cos(2 * std::numbers::pi * random.uniform());
}

/// An eclipse, and where it is seen from.
struct Occasion {
  const char* instant;
  double latitude, longitude;  // [degrees]

  std::string at() const { return fmt::format("{},{}", latitude, longitude); }
};

constexpr std::array occasions{
    Occasion{"2018-07-27T20:40:00Z", 36, 38}, Occasion{"2008-02-21T03:12:00Z", 42.86, -73.77},
    Occasion{"2015-09-28T02:30:00Z", 30, -40}, Occasion{"2010-12-21T08:00:00Z", 40, -100},
    Occasion{"2000-07-16T13:20:00Z", -20, 150}};

struct Truth {
  double dust_per_m, cloud_cover, ozone_du;
};

struct Taken {
  Truth truth;
  bool jpeg;
  double time_s, iso, seeing_arcsec;
};

/// Ozone is drawn from all that a fit allows: a noisy photograph tells so little of it that an interval holds
/// the truth as often as it says over that range alone.
Taken random_photograph(Random& random) {
  Taken taken{};
  const auto& ozone = uses::unknowns_of(uses::Unknowns::amounts)[2];
  taken.truth = {in_decades(random, 1.5e-6, 1e-5), between(random, 0, 0.9),
                 between(random, ozone.least, ozone.most)};
  taken.jpeg = random.uniform() < 0.5;
  taken.time_s = between(random, 1, 4);
  taken.iso = in_decades(random, 100, 3200);
  taken.seeing_arcsec = between(random, 1, 4);
  return taken;
}

Words words_of(const Truth& truth) {
  return {"--dust-extinction", fmt::format("{}", truth.dust_per_m),
          "--cloud-cover",     fmt::format("{}", truth.cloud_cover),
          "--ozone-du",        fmt::format("{}", truth.ozone_du)};
}

/// Any air: of a month, changed by factors, or of one column, by amounts.
struct AnyAir {
  std::string atmosphere;
  std::array<double, 3> truth;  ///< aerosol, cloud, ozone

  const std::array<uses::Unknown, 3>& unknowns() const {
    return uses::unknowns_of(uses::usual_unknowns({.atmosphere = atmosphere}));
  }
  Words words() const {
    Words all{"--atmosphere", atmosphere};
    for (std::size_t a = 0; a < truth.size(); ++a)
      all = all + Words{fmt::format("--{}", unknowns()[a].parameter), fmt::format("{}", truth[a])};
    return all;
  }
};

AnyAir random_air(Random& random) {
  constexpr std::array names{"standard", "calibrated", "undated", "clear", "molecular"};
  const std::string name = names[static_cast<std::size_t>(random.uniform() * names.size())];
  if (uses::usual_unknowns({.atmosphere = name}) == uses::Unknowns::factors)
    return {name,
            {in_decades(random, 0.2, 10), in_decades(random, 0.2, 3), between(random, 0.6, 1.5)}};
  return {name,
          {in_decades(random, 1.5e-6, 1e-5), between(random, 0, 0.9), between(random, 200, 450)}};
}

/// Turned about its middle, as a camera that is not level holds it.
texture::Image turned(const texture::Image& image, double angle_rad) {
  texture::Image result(image.width, image.height, image.channels);
  const double x0 = static_cast<double>(image.width) / 2,
               y0 = static_cast<double>(image.height) / 2, c = std::cos(angle_rad),
               s = std::sin(angle_rad);
  for (std::size_t k = 0; k < 3; ++k) {
    algebra::Grid<float> channel(image.height, image.width);
    for (std::size_t i = 0; i < channel.values().size(); ++i)
      channel.values()[i] = image.values[image.channels.size() * i + k];
    for (std::size_t r = 0; r < image.height; ++r)
      for (std::size_t col = 0; col < image.width; ++col) {
        const double x = static_cast<double>(col) + 0.5 - x0, y = static_cast<double>(r) + 0.5 - y0;
        result(r, col, k) = static_cast<float>(
            colour::between_pixels(channel, {x0 + c * x - s * y, y0 + s * x + c * y}));
      }
  }
  return result;
}

/// A frame of a Moon whose map is 1.2 % off in cells of 200 km, each channel by itself: over a step of
/// distance from the axis that comes to the 0.3 % to which a fit believes its map.
void mar_map(texture::Image& frame, Random& random) {
  constexpr std::size_t cell_px = 18;
  constexpr double error = 0.012;
  const auto across = frame.width / cell_px + 1;
  std::vector<float> factors;
  for (std::size_t i = 0; i < across * (frame.height / cell_px + 1) * 3; ++i)
    factors.push_back(static_cast<float>(std::exp(error * normal(random))));
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c)
      for (std::size_t k = 0; k < 3; ++k)
        frame(r, c, k) *= factors[(r / cell_px * across + c / cell_px) * 3 + k];
}

/// A frame on whose Moon the glow is off by a quarter, as much as a fit believes: what is measured beside the
/// disc tells of its strength, but not of its shape.
void mar_glow(texture::Image& frame, double share, double pixel_rad, Random& random) {
  constexpr double believed = 0.25;
  const auto seen = uses::pixels_of(frame), glowing = colour::with_glow(seen, share, pixel_rad);
  const double error = believed * normal(random);
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto channel = static_cast<int>(k);
        const double kept = seen(r, c)[channel];
        if (kept > 0)
          frame(r, c, k) +=
              static_cast<float>(error * (glowing(r, c)[channel] - (1 - share) * kept));
      }
}

class Recovery : public ProgramTest {
 protected:
  /// A scene-linear frame by POV-Ray, of the true air.
  texture::Image frame_of(const Occasion& occasion, const Words& air) const {
    const Words still{"still", occasion.instant, "--at", occasion.at(), "-o", "a.png"},
        view{"--width", "440", "--height", "440", "--field", "0.75", "--time", "1"},
        moon{"--albedo-map", "built-in", "--texture-width", "1024", "--stars", "off"};
    const auto outcome = coppermoon(still + view + moon + Words{"--frame", "frame.exr"} + air);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return texture::read_image(here("frame.exr"));
  }

  /// File of it as a camera that is sold as f/6 and saturates within a tenth of what its speed says has it.
  std::string photograph_of(texture::Image frame, const Taken& taken, Random& random,
                            double& value_per_cd_m2) const {
    auto camera = colour::camera_named("refractor");
    const double pixel_rad = 2 * std::tan(0.75 / 2 * std::numbers::pi / 180) / 440;
    mar_map(frame, random);
    mar_glow(frame, camera.glow, pixel_rad, random);
    const double exposed = std::exp(0.1 * normal(random));
    const std::array<double, 3> gain{exposed * std::exp(0.03 * normal(random)), exposed,
                                     exposed * std::exp(0.03 * normal(random))};
    for (std::size_t i = 0; i < frame.values.size(); ++i)
      frame.values[i] *= static_cast<float>(gain[i % 3]);
    camera.seeing_arcsec = taken.seeing_arcsec;
    const double f_number = camera.optics.focal_length_mm / camera.optics.aperture_mm;
    const colour::Exposure exposure{taken.time_s, f_number, taken.iso};
    const auto photograph =
        colour::photographed(uses::pixels_of(frame), rec709, camera,
                             {exposure, pixel_rad, 2e-4, seed + 1, random_number_++});
    value_per_cd_m2 = 1 / photograph.saturation_cd_m2;
    auto image = uses::image_of(photograph.scene_linear);
    for (float& value : image.values) value *= static_cast<float>(value_per_cd_m2);
    return written(turned(image, between(random, 0, 6.28)), taken.jpeg);
  }

  /// File of an image, coded as sRGB.
  std::string written(texture::Image image, bool jpeg) const {
    for (float& value : image.values) {
      const float v = std::clamp(value, 0.F, 1.F);
      value = v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1 / 2.4F) - 0.055F;
    }
    texture::write_png(here("photo.png"), image, 16);
    if (!jpeg) return "photo.png";
    const auto outcome = run({"oiiotool", here("photo.png").string(), "-d", "uint8",
                              "--compression", "jpeg:90", "-o", here("photo.jpg").string()});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return "photo.jpg";
  }

 private:
  mutable std::uint64_t random_number_ = 0;
};

/// What photographs of an occasion are held against.
struct Held {
  almanac::SkyState sky;
  uses::MoonRequest moon{};
  uses::ViewRequest view{};

  uses::FitScene scene() const {
    return fit_scene(moon, groundwork_of(moon, std::span(&sky, 1)), view, sky);
  }

  /// The scene in the air that was found.
  uses::FitScene scene_in(const uses::AirFit& fit) const {
    auto found = *this;
    found.moon.light.air = with_unknowns(moon.light.air, fit.unknowns, fit.best);
    return found.scene();
  }

  uses::FittedLight light(const uses::FitScene& of_scene,
                          const std::optional<uses::AirRange>& range = {}) const {
    const auto bins = lit_bins(of_scene, sky);
    return {moon.light,
            uses::Unknowns::amounts,
            std::span(&sky, 1),
            std::span(&bins, 1),
            uses::FittedAirs::fine,
            {},
            range};
  }
};

Held held_at(const Occasion& occasion) {
  Held held{.sky = almanac::sky_at(almanac::instant_from_utc(occasion.instant))};
  held.view.observer = almanac::Observer{algebra::degrees(occasion.latitude),
                                         algebra::degrees(occasion.longitude), algebra::metres(0)};
  held.moon.albedo_map = "built-in";
  return held;
}

uses::AirFit fitted_to(const uses::NightPhotograph& night, const uses::FittedLight& light) {
  const uses::ComparedNight compared(std::span(&night, 1), {});
  const uses::DataSet data{&light, [&](const auto& of_air) { return compared.goodness(of_air); },
                           compared.count()};
  return uses::fitted_air({&data, 1});
}

/// Air fitted to a photograph, and once more with it registered, and light computed, in the air found.
uses::AirFit fitted_twice(const uses::MoonPart& photo, double value_per_cd_m2, const Held& held,
                          const uses::FitScene& scene, const uses::FittedLight& light) {
  const auto night_of = [&](const uses::FitScene& of_air, const colour::Registration& found,
                            bool in_its_air) -> uses::NightPhotograph {
    return {of_air,
            binned(of_air, photo, found.render_to_photo),
            {.value_per_cd_m2 = value_per_cd_m2,
             .place_error_km = place_error_km(of_air, found, in_its_air)}};
  };
  const auto found = registration_of(scene, photo);
  const auto fit = fitted_to(night_of(scene, found, false), light);
  const auto in_air = held.scene_in(fit);
  const auto again = registration_of(in_air, photo, found.render_to_photo.scale);
  return fitted_to(night_of(in_air, again, true), held.light(in_air, range_about(fit)));
}

/// How often something was so, of all.
struct Tally {
  int photographs = 0, found = 0, refused = 0;
  std::array<int, 3> inside{};

  void count(const Truth& truth, const uses::Posterior& posterior) {
    const std::array<double, 3> true_values{std::log(truth.dust_per_m), truth.cloud_cover,
                                            truth.ozone_du};
    const auto& [dust, cover, ozone] = posterior.estimates;
    found += std::abs(std::exp(dust.median) / truth.dust_per_m - 1) < 0.25 &&
             std::abs(cover.median - truth.cloud_cover) < 0.15;
    for (std::size_t a = 0; a < 3; ++a)
      inside[a] += true_values[a] >= posterior.estimates[a].low &&
                   true_values[a] <= posterior.estimates[a].high;
  }
};

TEST_F(Recovery, OfAHundredPhotographsFindsDustAndCloudAndKnowsHowWell) {
  Tally tally;
  for (const auto& occasion : occasions) {
    const auto held = held_at(occasion);
    const auto scene = held.scene();
    const auto light = held.light(scene);
    for (std::size_t i = 0; i < photographs_an_instant; ++i) {
      Random random(seed, static_cast<std::uint64_t>(tally.photographs++));
      const auto taken = random_photograph(random);
      double value_per_cd_m2 = 0;
      const auto photo = uses::moon_part(texture::read_light(here(photograph_of(
          frame_of(occasion, words_of(taken.truth)), taken, random, value_per_cd_m2))));
      try {
        tally.count(taken.truth,
                    fitted_twice(photo, value_per_cd_m2, held, scene, light).posterior);
      } catch (const algebra::Error&) {
        ++tally.refused;  // one whose Moon is lost in noise or light: not found
      }
    }
  }
  RecordProperty("found", tally.found);
  RecordProperty("refused", tally.refused);
  RecordProperty("dust_inside", tally.inside[0]);
  RecordProperty("cover_inside", tally.inside[1]);
  RecordProperty("ozone_inside", tally.inside[2]);
  // what was asked for: dust within 25 % and cover within 0.15
  EXPECT_GE(tally.found, 90) << tally.refused << " refused";
  // of 100 fair intervals of 68 %, 60 to 76 hold the truth in 92 of 100 such tests
  for (std::size_t a = 0; a < tally.inside.size(); ++a) {
    EXPECT_GE(tally.inside[a], 60) << a;
    EXPECT_LE(tally.inside[a], 76) << a;
  }
}

/// Light at which 2 % of the lit pixels are brighter.
double light_of_highlights(const texture::Image& frame) {
  std::vector<float> lit;
  for (std::size_t i = 0; i < frame.values.size(); i += 3)
    if (const auto* pixel = &frame.values[i]; pixel[1] > 0)
      lit.push_back(std::max({pixel[0], pixel[1], pixel[2]}));
  std::ranges::sort(lit);
  return lit[lit.size() * 98 / 100];
}

/// Speed at which a photographer exposes the frame to some share of saturation; longer, where no speed does.
void expose(Taken& taken, const texture::Image& frame, double share) {
  constexpr double slowest = 100, fastest = 12800, longest_s = 30;
  const auto camera = colour::camera_named("refractor");
  const double f_number = camera.optics.focal_length_mm / camera.optics.aperture_mm;
  taken.iso = share * slowest * saturation_cd_m2(camera, {taken.time_s, f_number, slowest}) /
              light_of_highlights(frame);
  if (taken.iso < slowest) taken.time_s *= taken.iso / slowest;
  if (taken.iso > fastest) taken.time_s = std::min(longest_s, taken.time_s * taken.iso / fastest);
  taken.iso = std::clamp(taken.iso, slowest, fastest);
}

using Stills = Recovery;

TEST_F(Stills, OfTwoHundredInAnyAirFindsItsAerosolCloudAndOzone) {
  std::array<int, 3> inside{};
  int stills = 0, refused = 0;
  for (const auto& occasion : occasions)
    for (std::size_t i = 0; i < stills_an_instant; ++i) {
      Random random(seed + 1, static_cast<std::uint64_t>(stills++));
      const auto air = random_air(random);
      auto taken = random_photograph(random);
      const auto frame = frame_of(occasion, air.words());
      expose(taken, frame, between(random, 0.2, 0.7));
      double value_per_cd_m2 = 0;
      const auto photo = photograph_of(frame, taken, random, value_per_cd_m2);
      const auto outcome = coppermoon({"fit",          photo,
                                       "--instants",   occasion.instant,
                                       "--at",         occasion.at(),
                                       "--atmosphere", air.atmosphere,
                                       "--coding",     "srgb",
                                       "--camera",     "refractor",
                                       "--times",      fmt::format("{}", taken.time_s),
                                       "--isos",       fmt::format("{}", taken.iso),
                                       "--f-number",   "6",
                                       "--albedo-map", "built-in",
                                       "--json"});
      fmt::print("{} {}: ", stills, air.atmosphere);
      if (outcome.status != 0) {
        ++refused;
        fmt::print("refused: {}", outcome.err);
        continue;
      }
      const auto found = nlohmann::json::parse(outcome.out);
      for (std::size_t a = 0; a < inside.size(); ++a) {
        const auto& estimate = found[std::string(air.unknowns()[a].key)];
        const double low = estimate["low_68"], high = estimate["high_68"];
        inside[a] += air.truth[a] >= low && air.truth[a] <= high;
        fmt::print("{} {:.3g} to {:.3g} ({:.3g}), ", air.unknowns()[a].title, low, high,
                   air.truth[a]);
      }
      fmt::print("chi squared {:.0f} of {}\n", found["chi_squared"].get<double>(),
                 found["numbers"].get<int>());
      std::fflush(stdout);
    }
  RecordProperty("refused", refused);
  RecordProperty("aerosol_inside", inside[0]);
  RecordProperty("cloud_inside", inside[1]);
  RecordProperty("ozone_inside", inside[2]);
  EXPECT_EQ(refused, 0);
  // 60 to 76 of a hundred were asked for: of 200 fair intervals so many hold the truth in 99 of 100 such tests. Of one
  // hundred alone a fifth of all tests would find one of the three numbers outside
  for (std::size_t a = 0; a < inside.size(); ++a) {
    EXPECT_GE(inside[a], 120) << a;
    EXPECT_LE(inside[a], 152) << a;
  }
}

}  // namespace
}  // namespace coppermoon::end_to_end
