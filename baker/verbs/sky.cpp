// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <memory>
#include <optional>

#include "algebra/error.h"
#include "eclipse/seen_sky.h"
#include "result/as_json.h"
#include "uses/picture/place_text.h"
#include "uses/picture/sky_lights.h"
#include "uses/picture/view.h"
#include "verbs/command_line.h"
#include "verbs/flags/moments.h"

namespace coppermoon::verbs {
namespace of_sky {
namespace {

struct Options {
  MomentOptions moment;
  std::string at;
  std::optional<double> faintest_star;
  bool json = false;
};

/// A star or planet in an observer's sky.
struct Star {
  povray_scenes::HorizonPlace place;
  std::array<double, 3> illuminance_lux{};
};

template <class Field>
void describe(Field&& is, const Star& star) {
  namespace unit = algebra::unit;
  is.a("Star", "A star or planet in an observer's sky.");
  is("altitude_deg", star.place.altitude, unit::degrees, "altitude, raised by refraction");
  is("azimuth_deg", star.place.azimuth, unit::degrees, "azimuth, from north through east");
  is("illuminance_lux", star.illuminance_lux, unit::illuminance, "illuminance, in linear Rec.709");
}

/// The sky at one moment, with stars if the user asked for them.
struct Document {
  eclipse::SeenSky sky;
  std::optional<algebra::Angle> latitude;  ///< the observer's latitude; absent without stars
  std::vector<Star> stars;
};

template <class Field>
void describe(Field&& is, const Document& all) {
  is.a("Document", "Sun, Moon and shadow, and how the Moon is turned.");
  describe(is, all.sky);
  is("observer_latitude_deg", algebra::if_any(all.latitude), algebra::unit::degrees,
     "latitude of the observer, with --stars");
  is("stars", algebra::if_any(all.latitude ? std::optional(all.stars) : std::nullopt),
     "stars and planets above the horizon, with --stars");
}

Document document_of(const Options& options) {
  std::optional<almanac::Observer> observer;
  if (!options.at.empty()) observer = uses::observer_from(options.at);
  Document all{{almanac::sky_at(instant_of(options.moment, observer)), {}}, {}, {}};
  if (!observer) return all;
  const auto& sky = all.sky.sky;
  all.sky.view = almanac::view_from(*observer, sky);
  if (!options.faintest_star) return all;
  all.latitude = observer->latitude;
  const auto view = uses::view_of(
      {.observer = *observer, .stars = {.shown = true, .faintest = *options.faintest_star}}, sky);
  for (const auto& star : uses::lights_over(view, sky))
    all.stars.push_back({star.place, star.illuminance_lux});
  return all;
}

void run(const Options& options) {
  if (options.faintest_star && (options.at.empty() || !options.json))
    throw algebra::Error("stars are listed with --at and --json");
  const auto calendar = options.moment.calendar;
  auto all = result::as_json(document_of(options), {.calendar = calendar, .decimals = 3});
  say_calendar(all, calendar);
  fmt::print("{}", options.json ? all.dump(2) + "\n" : result::as_lines(all, "{:.6f}"));
}

}  // namespace
}  // namespace of_sky

void add_sky(Program& program) {
  using namespace of_sky;
  auto& verb =
      add_verb(program, "sky", "says where Sun, Moon and shadow are, and how the Moon is turned");
  const auto options = std::make_shared<Options>();
  add_moment_options(verb, options->moment).required();
  add_flag(verb, "--at", options->at,
           "place of an observer: a city, as Chicago, or LAT,LON[,ELEV] [degrees north and east, "
           "metres]");
  add_flag(verb, "--stars", options->faintest_star,
           "V magnitude, -5 to 20: lists stars and planets to it; illuminance in linear Rec.709")
      .within(-5, 20)
      .of(request::Affects::run);
  add_json_switch(verb, options->json, {result::fields_of<Document>});
  on_run(verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
