// SPDX-License-Identifier: MIT
#include "uses/dome/dome.h"

#include <fmt/format.h>

#include <array>
#include <memory>
#include <nlohmann/json.hpp>

#include "almanac/calendar.h"
#include "eclipse/contacts.h"
#include "files/endings.h"
#include "files/memory.h"
#include "files/whole_file.h"
#include "texture/write_image.h"
#include "uses/picture/picture_parameters.h"
#include "verbs/command_line.h"
#include "verbs/flags/moon_options.h"
#include "verbs/flags/named_files.h"
#include "verbs/reports/progress_bar.h"

namespace coppermoon::verbs {
namespace of_dome {
namespace {

struct Options {
  MoonOptions moon;
  uses::ViewRequest view;  ///< observer, air and stars alone
  uses::DomeRequest dome;
  std::string output;
  bool json = false;
};

constexpr std::array formats{
    files::Ending{".exr", "scene-linear; `coppermoon develop` makes a picture of it"}};

/// Dome as asked for; a colour space in its file's name counts.
uses::DomeRequest dome_request(const Options& options) {
  auto dome = options.dome;
  dome.content.space = space_for(options.output, options.dome.content.space);
  if (!options.dome.content.space)
    say_space_of(options.output, space_of(dome.content), other_spaces);
  return dome;
}

void require_sound(const Options& options) {
  files::format_of(options.output, formats, "a dome");
  if (!options.view.observer) throw WrongUsage("--at: missing; a sky is seen from a place");
  uses::require_sound(options.dome);
  constexpr double a_texel = 40;  // bytes; 14 of them in linear Rec.709, measured at 8192 columns
  const auto width = static_cast<double>(options.dome.width);
  files::require_memory(options.output, a_texel * width * width / 2);
  files::require_place_for(options.output);
}

void print_json(const Options& options, const almanac::SkyState& sky, const uses::Dome& dome) {
  const auto calendar = options.moon.moment.calendar;
  nlohmann::ordered_json all{{"file", options.output},
                             {"instant", almanac::utc_text(sky.when, calendar)}};
  say_calendar(all, calendar);
  for (const auto& [name, value] : dome.figures) all[name] = value;
  fmt::print("{}\n", all.dump(2));
}

void run(const Options& options) {
  require_sound(options);
  const auto request = dome_request(options);
  auto moon = moon_request(options.moon);
  moon.texture_width = 720;  // of the Moon's whole light
  const auto sky = almanac::sky_at(instant_of(options.moon.moment, options.view.observer));
  const bool eclipsed =
      eclipse::eclipse_at(sky.when, eclipse::ShadowConvention::danjon).has_value();
  if (!eclipsed) moon.unshadowed = true;  // on any other night
  if (!moon.unshadowed) say_unless_danjon_is_reached(moon.light.air, sky);
  const auto lit = [&] {
    ProgressBar bar("light");
    return uses::lit_moon(moon, sky, bar.progress());
  }();
  const auto dome = uses::dome_over(request, lit, options.view);
  texture::write_exr(options.output, dome.light, dome.attributes, {type_of(request.content)});
  if (options.json) return print_json(options, sky, dome);
  for (const auto& [name, value] : dome.figures) fmt::print("{:<30}{:.6g}\n", name, value);
}

}  // namespace
}  // namespace of_dome

void add_dome(Program& program) {
  using namespace of_dome;
  auto& verb = add_verb(program, "dome",
                        "makes the night sky around the Moon: latitude-longitude, cd/m², the "
                        "zenith on top, north in the middle");
  const auto options = std::make_shared<Options>();
  add_moment_options(verb, options->moon.moment,
                     "; or a file that coppermoon made, to make it again")
      .required();
  add_map_options(verb, options->moon.request);
  add_described(verb, options->moon.request, uses::describe_unshadowed);
  add_light_options(verb, options->moon.light);
  add_flag(verb, "-o,--output", options->output,
           "sky, 2:1, east to the right of north, three quarters across: " +
               files::in_words(formats) + ". sky_acescg.exr is in that space")
      .writes_file(formats)
      .required();
  add_described(verb, options->view, uses::describe_observer);
  add_described(verb, options->view, uses::describe_stars);
  add_described(verb, options->dome);
  add_run_switch(verb, "--json", options->json, "prints one JSON document");
  on_run(verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
