// SPDX-License-Identifier: MIT
#include "uses/picture/still.h"

#include <fmt/format.h>

#include <chrono>
#include <memory>

#include "eclipse/contacts.h"
#include "files/memory.h"
#include "files/temporary_folder.h"
#include "files/whole_file.h"
#include "uses/light/header.h"
#include "uses/light/spectral_bands.h"
#include "uses/night/eclipse_light.h"
#include "uses/picture/picture_files.h"
#include "uses/picture/picture_parameters.h"
#include "verbs/command_line.h"
#include "verbs/flags/camera_options.h"
#include "verbs/flags/named_files.h"
#include "verbs/recipes/recorded_scene.h"
#include "verbs/reports/in_words.h"
#include "verbs/reports/progress_bar.h"

namespace coppermoon::verbs {
namespace of_still {
namespace {

struct Options {
  MoonOptions moon;
  uses::ViewRequest view;
  uses::Development develop;
  std::string output, frame;
  colour::WorkingSpace space = uses::picture_space;
  bool passes = false, json = false;
};

void require_sound(const Options& options) {
  require_sound(options.develop, options.output);
  files::require_temporary_folder();
  const auto& camera = options.develop.camera;
  files::require_memory(options.output, uses::frame_memory(options.view.width, options.view.height,
                                                           !camera.model.empty()));
  for (const std::filesystem::path& file :
       {std::filesystem::path(options.output), std::filesystem::path(options.frame), camera.raw,
        camera.photograph})
    if (!file.empty()) files::require_place_for(file);
}

/// Colour space of the frame: the one in its file's name, else the one set by --space.
colour::WorkingSpace frame_space(const Verb& verb, const Options& options) {
  if (is_given(verb, "space")) return *space_for(options.frame, options.space);
  const auto space = space_for(options.frame, {}).value_or(options.space);
  say_space_of(options.frame, space, other_spaces);
  return space;
}

/// Warns on stderr if the sky is too bright for the Moon to be seen, and says when it can be seen.
void say_unless_seen(const uses::LitScene& scene, const Options& options) {
  const auto& when = scene.moon.sky.when;
  const auto eclipse = eclipse::nearest_eclipse(when, eclipse::ShadowConvention::danjon);
  if (!scene.view.observer || options.view.sky_cd_m2) return;
  auto moon = options.moon.request;
  moon.light.wish.tolerance = 0.05;  // sufficient, because the eye's threshold is less certain
  const uses::EclipseLight light(eclipse, moon);
  const auto night = uses::as_seen(
      uses::circumstances(eclipse, *scene.view.observer),
      [&](const auto& sky) { return light.brightness(sky); }, options.view);
  if (const auto line = unseen_in_words(night, when)) fmt::print(stderr, "coppermoon: {}\n", *line);
}

void run(const Verb& verb, Options options) {
  options.view = seen_through(options.develop.camera, options.view);
  options.develop.focal_length_mm = options.view.focal_length_mm;
  options.moon.request.response = spectral_response(options.develop.camera);
  require_sound(options);
  if (!options.frame.empty()) options.space = frame_space(verb, options);
  const auto start = std::chrono::steady_clock::now();
  ProgressBar bake_bar("bake");
  const auto scene = lit_scene(verb, options.moon, options.view,
                               {texture::Extent::seen_from_earth, bake_bar.progress()});
  const auto made = report_of(options.output, scene, seconds_since(start));
  const auto frame = [&] {
    ProgressBar bar("render");
    return uses::rendered(scene, options.passes && !options.frame.empty(), bar.progress());
  }();
  const auto whole = frame.whole();
  const auto seen = uses::seen_by(scene.view, scene.sky);
  const auto exposures = exposures_for(options.develop, whole, uses::picture_space, seen);
  if (sky_over_moon(whole, uses::picture_space, seen) > 1) say_unless_seen(scene, options);
  if (!options.frame.empty()) {
    auto header = uses::frame_header(scene, exposures);
    uses::say_space(header, options.space);
    uses::write_frame(options.frame, in_space(frame, uses::picture_space, options.space),
                      scene.view.camera, header);
  }
  write_picture(
      options.develop, exposures, {whole, uses::picture_space, seen, 0, scene.texture.attributes},
      {{"coppermoon:recipe", made.recipe}, {"coppermoon:version", std::string(uses::version())}},
      options.output);
  report(made, options.json);
}

}  // namespace
}  // namespace of_still

void add_still(Program& program) {
  using namespace of_still;
  auto& verb =
      add_verb(program, "still",
               "makes a picture: bakes, builds the scene, renders it with POV-Ray, develops it");
  const auto options = std::make_shared<Options>();
  add_moon_options(verb, options->moon);
  add_described(verb, options->view);
  add_described(verb, options->develop);
  add_described(verb, options->develop.caption, uses::describe_caption);
  add_described(verb, options->develop.camera);
  add_camera_file_options(verb, options->develop.camera);
  add_flag(verb, "-o,--output", options->output,
           "picture: " + files::in_words(uses::picture_files()))
      .writes_file(uses::picture_files())
      .required();
  add_flag(verb, "--frame", options->frame, "writes the scene-linear frame too: .exr [cd/m²]")
      .writes_file();
  add_frame_space_option(verb, options->space);
  add_described(verb, options->passes, uses::describe_passes);
  for (const char* of_frame : {"space", "passes"})
    verb.parameters.find(of_frame)->only_with({{"frame"}});
  add_json_switch(verb, options->json, {result::fields_of<Report>});
  on_run(verb, [&verb, options] { run(verb, *options); });
}

}  // namespace coppermoon::verbs
