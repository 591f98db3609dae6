// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <chrono>
#include <memory>

#include "algebra/error.h"
#include "algebra/number.h"
#include "almanac/calendar.h"
#include "eclipse/shadow_axis.h"
#include "files/whole_file.h"
#include "result/as_json.h"
#include "uses/light/shadow_profile.h"
#include "uses/picture/plots.h"
#include "uses/plot/plot.h"
#include "verbs/command_line.h"
#include "verbs/flags/light_options.h"
#include "verbs/flags/moments.h"
#include "verbs/reports/one_line.h"
#include "verbs/reports/progress_bar.h"
#include "verbs/reports/report.h"
#include "verbs/reports/writers.h"

namespace coppermoon::verbs {
namespace of_shadow {
namespace {

struct Options {
  MomentOptions moment;
  std::string wavelengths = "450,550,650", axis_distances;
  std::vector<std::string> outputs;
  LightOptions light;
  std::optional<double> moon_distance_km, sun_distance_km, position_angle_deg;
  bool json = false;
};

std::vector<double> required_list(const std::string& text, const char* what) {
  const auto list = algebra::numbers_in(text);
  if (!list)
    throw algebra::Error(fmt::format("{} = {}, allowed numbers with commas between", what, text));
  return *list;
}

/// Decimal year whose air is used if no moment is given: an equinox in a year without volcanic eruptions.
constexpr double an_equinox = 2003.22;

/// A plane that cuts the Earth's shadow. It is given by its distance behind the Earth and by the Sun's position.
struct Cut {
  double sun_distance_m, depth_m;
  algebra::Angle sun_declination{};  ///< 0, as at an equinox, if no moment is given
  std::optional<almanac::SkyState> sky{};
};

Cut cut_of(const Options& options) {
  if (options.moon_distance_km && options.sun_distance_km)
    if (options.moment.text.empty())
      return {*options.sun_distance_km * 1e3, *options.moon_distance_km * 1e3};
  if (options.moment.text.empty())
    throw WrongUsage("a moment is missing, or both --moon-distance-km and --sun-distance-km");
  const auto sky = almanac::sky_at(instant_of(options.moment));
  const auto axis = eclipse::shadow_axis(sky);
  const double depth_km = algebra::in_kilometres(eclipse::place_in_shadow(axis, sky.moon_m).depth);
  if (!options.moon_distance_km && depth_km <= 0)
    throw algebra::Error(
        fmt::format("at {} the Moon is on the Sun's side of the Earth; --moon-distance-km says how "
                    "far the shadow is cut",
                    options.moment.text));
  return {options.sun_distance_km.value_or(algebra::in_kilometres(axis.sun_distance)) * 1e3,
          options.moon_distance_km.value_or(depth_km) * 1e3, axis.sun_declination, sky};
}

uses::ProfilePlaces places_of(const Options& options) {
  uses::ProfilePlaces places{.position_angle_deg = options.position_angle_deg};
  if (const auto angle = options.position_angle_deg)
    algebra::require_within("position angle [degrees]", *angle, 0, 360);
  places.wavelengths_nm = required_list(options.wavelengths, "wavelengths [nm]");
  for (const double km : required_list(options.axis_distances, "axis distances [km]"))
    places.axis_distances_m.push_back(km * 1e3);
  return places;
}

/// Profile of light across the shadow, with everything else that is written to files.
struct Profile {
  double moon_distance_km = 0, sun_distance_km = 0;
  std::string_view solver = "quadrature";
  uses::ShadowProfile light;
  uses::ShadowMarks marks;
};

template <class Field>
void describe(Field&& is, const Profile& profile) {
  namespace unit = algebra::unit;
  is.a("Profile", "Light across the Earth's shadow.");
  is("moon_distance_km", profile.moon_distance_km, unit::kilometres,
     "distance of the cut from the Earth's centre, along the shadow's axis");
  is("sun_distance_km", profile.sun_distance_km, unit::kilometres, "distance of the Sun");
  is("solver", algebra::Word{profile.solver, {"quadrature", "photons"}}, "how light was computed");
  describe(is, profile.light);
}

std::string as_csv(const Profile& all) {
  const auto& profile = all.light;
  std::string text = "axis_distance_km";
  for (const double nm : profile.wavelengths_nm)
    text += fmt::format(",irradiance_ratio_{:g}nm,standard_error_{:g}nm", nm, nm);
  text += '\n';
  for (std::size_t d = 0; d < profile.axis_distances_m.size(); ++d) {
    text += fmt::format("{:g}", profile.axis_distances_m[d] / 1e3);
    for (std::size_t w = 0; w < profile.wavelengths_nm.size(); ++w)
      text += fmt::format(",{:.6g},{:.3g}", profile.ratio(d, w), profile.standard_error(d, w));
    text += '\n';
  }
  return text;
}

result::Json as_json(const Profile& profile) { return result::as_json(profile); }

/// Writers for all file formats: first tables, then plots.
const Writers<Profile>& writers() {
  static const Writers<Profile> all = [] {
    Writers<Profile> formats{writer_of({".csv", "numbers"}, as_csv),
                             writer_of({".json", "numbers"}, as_json)};
    for (const auto& plot : uses::plot_files())
      formats.push_back({plot, [](const Profile& profile, const std::filesystem::path& file) {
                           uses::write_shadow_plot(file, profile.light, profile.marks);
                         }});
    return formats;
  }();
  return all;
}

/// Title of a plot. The first line states the moment and the distance from the Earth, the second the air.
std::string title_of(const Cut& cut, const std::string& air, almanac::Calendar calendar) {
  const auto distance = fmt::format("{:.0f} km from the Earth", cut.depth_m / 1e3);
  if (!cut.sky) return fmt::format("The Earth's shadow {}\n{}", distance, air);
  const auto when =
      almanac::date_text(cut.sky->when, calendar) + " " + almanac::time_of_day_text(cut.sky->when);
  return fmt::format("The Earth's shadow on {} UTC, {}\n{}", when, distance, air);
}

void make_profile(const Options& options, const Cut& cut, const uses::ShadowCut& shadow,
                  const uses::LightRequest& light, const std::string& air_in_words) {
  const auto start = std::chrono::steady_clock::now();
  auto found = [&] {
    ProgressBar bar("light");
    return uses::shadow_profile(light, shadow, places_of(options), bar.progress());
  }();
  const auto& arrangement = shadow.arrangement;
  const Profile profile{
      arrangement.depths_m[0] / 1e3, arrangement.sun_distance_m / 1e3,
      plan::traces_photons(light.solver) ? "photons" : "quadrature", std::move(found),
      uses::marks_of(arrangement, cut.sky, title_of(cut, air_in_words, options.moment.calendar))};
  write_files(profile, options.outputs, writers());
  if (options.json) {
    auto document = as_json(profile);
    document["seconds"] = seconds_since(start);
    return print_json(document, options.outputs);
  }
  if (options.outputs.empty()) return fmt::print("{}", as_csv(profile));
  for (const auto& file : options.outputs)
    fmt::print("{}: {} distances to {:g} km, {} wavelengths\n", one_line(file),
               profile.light.axis_distances_m.size(), profile.light.axis_distances_m.back() / 1e3,
               profile.light.wavelengths_nm.size());
}

void run(const Verb& verb, const Options& options) {
  require_writers(options.outputs, writers(), "a profile of the shadow");
  const auto cut = cut_of(options);
  const auto light = light_request(options.light);
  auto air = cut.sky ? uses::shadow_at_the_moon(light, *cut.sky).air
                     : uses::atmosphere_of(light.air, cut.sun_declination, an_equinox);
  if (light.by_hand.terms && !cut.sky) air = uses::air_for(*light.by_hand.terms, {.air = air});
  if (cut.sky) say_unless_danjon_is_reached(light.air, *cut.sky);
  const uses::ShadowCut shadow{air,
                               {cut.sun_distance_m, {cut.depth_m}, uses::limb_darkening_of(light)}};
  make_profile(options, cut, shadow, light, uses::air_in_words(verb.parameters));
}

}  // namespace
}  // namespace of_shadow

void add_shadow(Program& program) {
  using namespace of_shadow;
  auto& verb = add_verb(program, "shadow",
                        "computes irradiance across the shadow, over unobstructed sunlight");
  const auto options = std::make_shared<Options>();
  add_moment_options(verb, options->moment, "; for the distances and the air of that moment");
  add_flag(verb, "--wavelengths", options->wavelengths,
           "wavelengths [nm], 380 to 780, with commas between");
  add_flag(verb, "--axis-distances", options->axis_distances,
           "distances from the shadow's axis [km], increasing, with commas between");
  add_flag(verb, "--moon-distance-km", options->moon_distance_km,
           "distance of the Moon from the Earth's centre along the shadow's axis [km], 1e5 to 1e6")
      .within(1e5, 1e6);
  add_flag(verb, "--sun-distance-km", options->sun_distance_km,
           "distance of the Sun from the Earth's centre [km], 4.5e7 to 4.5e8")
      .within(4.5e7, 4.5e8);
  add_flag(verb, "--position-angle", options->position_angle_deg,
           "position angle about the axis, from celestial north through east [degrees], 0 to 360; "
           "default: the mean over all angles")
      .within(0, 360);
  add_flag(verb, "-o,--output", options->outputs,
           "file in place of stdout: " + files::in_words(writers()) + ". May be given again")
      .writes_file(writers());
  add_json_switch(verb, options->json, {result::fields_of<Profile>});
  add_light_options(verb, options->light);
  add_photon_file_options(verb, options->light);
  auto& all = verb.parameters;
  for (const char* of_a_moon : {"bands", "planes", "place-error", "budget"})
    all.find(of_a_moon)->only_with({});
  for (const char* of_photons : {"photons", "seed", "ring-km", "smoothing-km"})
    all.find(of_photons)->only_with({{"solver", {"photons", "literal"}}, {"quality", {"paper"}}});
  on_run(verb, [&verb, options] { run(verb, *options); });
}

}  // namespace coppermoon::verbs
