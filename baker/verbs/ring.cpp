// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "almanac/calendar.h"
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

namespace coppermoon::verbs {
namespace of_ring {
namespace {

struct Options {
  MomentOptions moment;
  std::string output;
  std::optional<almanac::SelenographicPoint> on;
  double scale = 1;
  uses::LightRequest light;  ///< air alone
  bool json = false;
};

constexpr std::array formats{
    files::Ending{".exr", "scene-linear; `coppermoon develop` makes a picture of it"}};

void require_sound(const Options& options) {
  files::format_of(options.output, formats, "a ring");
  files::require_place_for(options.output);
}

void print_json(const Options& options, const almanac::SkyState& sky,
                const uses::RingStrip& strip) {
  const auto calendar = options.moment.calendar;
  nlohmann::ordered_json all{{"file", options.output},
                             {"instant", almanac::utc_text(sky.when, calendar)}};
  say_calendar(all, calendar);
  for (const auto& [name, value] : strip.figures) all[name] = value;
  fmt::print("{}\n", all.dump(2));
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
  if (options.json) return print_json(options, sky, strip);
  for (const auto& [name, value] : strip.figures) fmt::print("{:<30}{:.6f}\n", name, value);
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
  add_run_switch(verb, "--json", options->json, "prints one JSON document");
  add_described(verb, options->light.air);
  on_run(verb, [&verb, options] { run(verb, *options); });
}

}  // namespace coppermoon::verbs
