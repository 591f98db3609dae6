// SPDX-License-Identifier: MIT
#include "uses/dome/dome.h"

#include <fmt/format.h>

#include <array>
#include <memory>

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
#include "verbs/reports/report.h"

namespace coppermoon::verbs {
namespace of_dome {
namespace {

struct Options {
  MoonOptions moon;
  uses::ViewRequest view;  ///< only its observer, air and stars are used
  uses::DomeRequest dome;
  std::string output;
  bool json = false;
};

constexpr std::array formats{
    files::Ending{".exr", "scene-linear; `coppermoon develop` makes a picture of it"}};

/// Request for the dome. If the file's name contains a colour space, the dome has that colour space.
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
  constexpr double a_texel = 40;  // bytes per texel; linear Rec.709 was measured to need only 14
  const auto width = static_cast<double>(options.dome.width);
  files::require_memory(options.output, a_texel * width * width / 2);
  files::require_place_for(options.output);
}

void run(const Options& options) {
  require_sound(options);
  const auto request = dome_request(options);
  auto moon = moon_request(options.moon);
  moon.texture_width = 720;  // columns, enough to compute the Moon's total light
  const auto sky = almanac::sky_at(instant_of(options.moon.moment, options.view.observer));
  const bool eclipsed =
      eclipse::eclipse_at(sky.when, eclipse::ShadowConvention::danjon).has_value();
  if (!eclipsed) moon.unshadowed = true;  // there is no eclipse that night
  if (!moon.unshadowed) say_unless_danjon_is_reached(moon.light.air, sky);
  const auto lit = [&] {
    ProgressBar bar("light");
    return uses::lit_moon(moon, sky, bar.progress());
  }();
  const auto dome = uses::dome_over(request, lit, options.view);
  texture::write_exr(options.output, dome.light, dome.attributes, {type_of(request.content)});
  if (!options.json)
    return fmt::print("{}", result::as_lines(result::as_json(dome.figures), "{:.6g}"));
  const auto calendar = options.moon.moment.calendar;
  auto document = result::as_json(MadeOf<uses::DomeFigures>{options.output, sky.when, dome.figures},
                                  {calendar});
  say_calendar(document, calendar);
  fmt::print("{}\n", document.dump(2));
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
  add_json_switch(verb, options->json, {result::fields_of<MadeOf<uses::DomeFigures>>});
  on_run(verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
