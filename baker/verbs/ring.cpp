// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <memory>
#include <optional>

#include "files/endings.h"
#include "files/whole_file.h"
#include "texture/write_image.h"
#include "uses/light/light_parameters.h"
#include "uses/light/ring_strip.h"
#include "uses/light/spectral_bands.h"
#include "uses/picture/place_text.h"
#include "verbs/command_line.h"
#include "verbs/flags/light_options.h"
#include "verbs/flags/moments.h"
#include "verbs/flags/named_files.h"
#include "verbs/reports/report.h"

namespace coppermoon::verbs {
namespace of_ring {
namespace {

struct Options {
  MomentOptions moment;
  std::string output;
  std::optional<almanac::SelenographicPoint> on;
  double scale = 1;
  uses::LightRequest light;  ///< only its air is used
  bool json = false;
};

constexpr std::array formats{
    files::Ending{".exr", "scene-linear; `coppermoon develop` makes a picture of it"}};

void require_sound(const Options& options) {
  files::format_of(options.output, formats, "a ring");
  files::require_place_for(options.output);
}

void run(const Verb& verb, const Options& options) {
  require_sound(options);
  say_space_of(options.output, uses::picture_space);
  const auto sky = almanac::sky_at(instant_of(options.moment));
  uses::require_eclipse(sky.when, {}, options.moment.calendar);
  auto strip = uses::ring_strip(options.light, sky, options.on, options.scale);
  say_unless_danjon_is_reached(options.light.air, sky);
  strip.attributes["coppermoon:recipe"] = recipe_of(verb);
  texture::write_exr(options.output, strip.light, strip.attributes, {texture::ExrType::floating});
  if (!options.json)
    return fmt::print("{}", result::as_lines(result::as_json(strip.figures), "{:.6f}"));
  const auto calendar = options.moment.calendar;
  auto document = result::as_json(
      MadeOf<uses::RingFigures>{options.output, sky.when, strip.figures}, {calendar});
  say_calendar(document, calendar);
  fmt::print("{}\n", document.dump(2));
}

}  // namespace
}  // namespace of_ring

void add_ring(Program& program) {
  using namespace of_ring;
  auto& verb =
      add_verb(program, "ring",
               "makes the Earth's ring of sunsets as the eclipsed Moon sees it: a strip, cd/m²");
  const auto options = std::make_shared<Options>();
  add_moment_options(verb, options->moment).required();
  add_parsed(
      verb, "--on", [options](const std::string& text) { options->on = uses::feature_from(text); },
      "place on the Moon: a feature's name, as Tycho, or LAT,LON [degrees north and east]; "
      "default: where the Earth is in the zenith");
  add_flag(verb, "-o,--output", options->output,
           "strip: " + files::in_words(formats) +
               ". Columns: position angle about the Earth's centre, from north through east. Rows: "
               "even in the angle from the centre, the outer edge on top; the header holds the "
               "angles of both edges")
      .writes_file(formats)
      .required();
  add_flag(verb, "--scale", options->scale,
           "factor on luminance in cd/m², 1e-9 to 1e9; POV-Ray reads no more than 65504")
      .within(1e-9, 1e9);
  add_json_switch(verb, options->json, {result::fields_of<MadeOf<uses::RingFigures>>});
  add_described(verb, options->light.air);
  on_run(verb, [&verb, options] { run(verb, *options); });
}

}  // namespace coppermoon::verbs
