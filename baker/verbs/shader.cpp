// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>

#include "algebra/error.h"
#include "eclipse/moment.h"
#include "uses/picture/picture_parameters.h"
#include "uses/shader/eclipse_shader.h"
#include "verbs/command_line.h"
#include "verbs/flags/film_options.h"
#include "verbs/flags/light_options.h"
#include "verbs/flags/moments.h"
#include "verbs/reports/in_words.h"
#include "verbs/reports/one_line.h"
#include "verbs/reports/progress_bar.h"
#include "verbs/reports/report.h"

namespace coppermoon::verbs {
namespace of_shader {
namespace {

namespace fs = std::filesystem;

const request::Words<colour::WorkingSpace> spaces{
    {"lin_rec709", colour::WorkingSpace::linear_rec709},
    {"acescg", colour::WorkingSpace::acescg},
    {"lin_ciexyzd65_scene", colour::WorkingSpace::ciexyz_d65}};

struct Options {
  MomentOptions moment;  ///< a day without a time means the whole eclipse
  std::string output;
  LightOptions light;
  uses::ShaderRequest request;
  bool json = false;
};

/// Result of the command: a folder of shaders.
struct Made {
  std::string folder;
  std::vector<std::string> files;
  double seconds = 0, error = 0;
};

template <class Field>
void describe(Field&& is, const Made& made) {
  is.a("Made", "A folder of shaders.");
  is("folder", made.folder, "the folder");
  is("files", made.files, "the files in it");
  is("seconds", made.seconds, algebra::unit::seconds, "time that it took");
  is("error", made.error, "relative error of the light, the largest");
}

void run(const Verb& verb, Options options) {
  const fs::path folder = options.output;
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw algebra::Error(fmt::format("{}: is no directory", one_line(options.output)));
  const auto start = std::chrono::steady_clock::now();
  options.request.light = light_request(options.light);
  const bool whole = eclipse::is_day(options.moment.text);
  std::optional<almanac::Instant> moment;
  if (!whole) moment = instant_of(options.moment);
  const auto eclipse =
      whole ? eclipse_of({.eclipse = options.moment.text, .calendar = options.moment.calendar})
            : eclipse::nearest_eclipse(*moment, eclipse::ShadowConvention::danjon);
  const auto when = moment.value_or(eclipse.greatest);
  uses::require_eclipse(when, {}, options.moment.calendar);
  say_unless_danjon_is_reached(options.request.light.air, almanac::sky_at(when));
  const auto shader = [&] {
    ProgressBar bar("light");
    return uses::eclipse_shader(eclipse, options.request, bar.progress(), moment);
  }();
  const Made made{options.output,
                  uses::write_shader(folder, shader, options.request, recipe_of(verb)),
                  seconds_since(start), shader.strip.error};
  if (options.json)
    fmt::print("{}\n", result::as_json(made).dump(2));
  else
    fmt::print("{}: {}; {}\n", one_line(options.output), fmt::join(made.files, ", "),
               within(made.error));
}

}  // namespace
}  // namespace of_shader

void add_shader(Program& program) {
  using namespace of_shader;
  auto& verb = add_verb(program, "shader",
                        "writes an eclipse as one small image and a shader that knows the time, "
                        "for OSL, GLSL, MaterialX, POV-Ray and Blender");
  const auto options = std::make_shared<Options>();
  add_flag(verb, "eclipse,--eclipse", options->moment.text,
           "day of the eclipse, as 2018-07-27; or the one moment to show, as 2018-07-27T18:50Z")
      .required();
  add_calendar_option(verb, options->moment.calendar);
  add_flag(verb, "-o,--output", options->output,
           "folder for the strip, eclipse.exr, and the shaders that read it")
      .writes_folder()
      .required();
  add_choice(verb, "--space", options->request.space, spaces,
             "colour space of the light: lin_rec709, acescg or lin_ciexyzd65_scene");
  add_json_switch(verb, options->json, {result::fields_of<Made>});
  add_light_options(verb, options->light);
  add_described(verb, options->request.response, uses::describe_response);
  on_run(verb, [&verb, options] { run(verb, *options); });
}

}  // namespace coppermoon::verbs
