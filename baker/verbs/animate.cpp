// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "algebra/error.h"
#include "files/whole_file.h"
#include "povray_scenes/moon_scene.h"
#include "result/fields.h"
#include "uses/film/film.h"
#include "uses/film/film_files.h"
#include "uses/film/film_folder.h"
#include "uses/film/film_frames.h"
#include "uses/film/film_light.h"
#include "uses/film/film_scene.h"
#include "uses/film/film_setup.h"
#include "uses/film/film_times.h"
#include "uses/light/spectral_bands.h"
#include "uses/night/eclipse_light.h"
#include "uses/picture/picture_parameters.h"
#include "uses/picture/texture_recipe.h"
#include "verbs/command_line.h"
#include "verbs/flags/camera_options.h"
#include "verbs/flags/film_options.h"
#include "verbs/flags/moon_options.h"
#include "verbs/reports/film_job.h"
#include "verbs/reports/film_progress.h"
#include "verbs/reports/in_words.h"
#include "verbs/reports/progress_bar.h"

namespace coppermoon::verbs {
namespace of_animate {
namespace {

struct Options {
  FilmOptions film;
  MoonOptions moon;
  uses::ViewRequest view;
  uses::Development development;
  uses::TextureContent content;
  std::string time = "composite", output, job;
  bool json = false, replace = false, dry_run = false;
};

uses::Film film_of(Verb& verb, const Options& options) {
  uses::Film film;
  film.folder = options.output;
  film.products = products_of(options.film);
  film.content = options.content;
  film.fps = options.film.fps;
  film.scene = options.film.scene;
  auto times = times_of(options.film, options.view);
  if (!film.products.light_alone()) keep_to_the_moon(times, verb.parameters, options.view);
  film.moments = moments_of(times);
  film.moon = moon_request(options.moon);
  film.view = options.view;
  film.development = options.development;
  film.moon.response = spectral_response(film.development.camera);
  film.time_keys = time_keys_from(options.time, film.moments.eclipse,
                                  {options.view.observer, options.film.zone});
  if (film.time_keys.empty()) film.development.time = uses::exposure_time_from(options.time);
  film.bracket_ev = options.film.bracket_ev;
  return film;
}

void require_photons(const uses::Film& film, const uses::Shard& shard) {
  const auto& light = film.moon.light;
  if (!wants_photons(light) || !light.photons)
    throw algebra::Error(
        fmt::format("shard = {}/{} of the light, allowed where --photons says how many", shard.part,
                    shard.parts));
}

void light_up(uses::Film& film, bool replace, const FilmProgress& progress) {
  const auto start = std::chrono::steady_clock::now();
  auto found = [&] {
    ProgressBar bar("light");
    return film_light(film, replace, bar.progress());
  }();
  film.light = std::make_shared<const uses::Moonlight>(std::move(found.light));
  progress.light(found.kept,
                 std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

/// Traces the photons of one shard, which is one run's share of the photons that light the film.
void trace(const uses::Film& film, const uses::Shard& shard) {
  ProgressBar bar("light");
  trace_shard(film, shard, bar.progress());
}

void write_job(const Verb& verb, const uses::Film& film, const uses::Shard& shard,
               const std::filesystem::path& file) {
  if (file.extension() != ".yaml")
    throw algebra::Error(fmt::format("{}: a job ends in .yaml", file.string()));
  if (shard.parts > 1)
    throw algebra::Error(fmt::format(
        "shard = {}/{}, allowed 1/1 with --job, whose tasks are shards", shard.part, shard.parts));
  if (film.products.light_alone()) require_photons(film, {1, 2});
  files::write_whole(file, film_job(verb, film, file));
}

/// Warns on stderr if a fixed camera cuts off or misses the Moon in some frames. Suggests an aim and a field of view.
void say_which_are_outside(const uses::Film& film) {
  if (!film.view.aim || !film.products.framed()) return;
  const auto view = fixed_view(film);
  if (view.outside == 0) return;
  fmt::print(stderr, "coppermoon: {} of {} Moons{} are cut off by the picture or outside it; {}\n",
             view.outside, view.looked_at,
             view.looked_at < film.moments.frames.size() ? " looked at" : "",
             view.aim ? fmt::format("--aim {:.1f},{:.1f} --field {:.3g} holds all",
                                    algebra::in_degrees(view.aim->altitude),
                                    algebra::in_degrees(view.aim->azimuth), view.field_deg)
                      : "no picture holds all");
}

/// Warns on stderr if twilight makes the Moon invisible in the first or last frame, and says when it is visible.
void say_when_seen(const uses::Film& film) {
  const auto& place = film.view.observer;
  if (!place || film.view.sky_cd_m2 || !film.products.framed()) return;
  constexpr auto dark = algebra::degrees(-12);
  for (const auto& when : {film.moments.frames.front(), film.moments.frames.back()}) {
    if (uses::moment_at(*place, {}, almanac::sky_at(when)).sun_altitude < dark) continue;
    const auto night = uses::seen_circumstances(film.moments.eclipse, *place);
    if (const auto line = unseen_in_words(night, when))
      return fmt::print(stderr, "coppermoon: {}: {}\n", almanac::utc_text(when), *line);
  }
}

/// Lists the files that this run would write. If the film's light has not been computed yet, these include all frames.
void list(uses::Film film, const std::vector<std::size_t>& frames, const uses::FilmFiles& files,
          bool replace, FilmProgress& progress) {
  if (!replace && std::filesystem::is_directory(film.folder)) require_own(film, false);
  const auto light = kept_light(film, replace);
  if (light) film.record.work = light->plan.work;
  const bool light_alone = film.products.light_alone();
  if (!light && (light_alone || !frames.empty())) progress.file(film.folder / uses::light_file);
  if (light_alone || frames.empty()) return;
  if (film.products.scenes)
    for (const char* name : {povray_scenes::scene_file, povray_scenes::settings_file})
      progress.file(film.folder / name);
  for (const auto frame : frames)
    if (!light || !is_made(film, frame))
      for (const auto& file : film.files(frame)) progress.file(file);
  for (const auto& file : files.all()) progress.file(file);
}

void run(Verb& verb, const Options& options) {
  auto film = film_of(verb, options);
  const bool light_alone = film.products.light_alone();
  const auto shard = uses::shard_from(options.film.shard);
  const auto frames = part_of(
      uses::frames_in(options.film.range, film.moments.frames.size(), film.moments.first_frame),
      shard);
  set_up(film, mounting_of(options.film, film.view.observer.has_value()), frames);
  film.record.recipe =
      uses::with_width(request::recipe_of(verb.parameters), *film.moon.texture_width);
  film.record.map_contents = map_contents(film.moon);
  film.record.view_contents = fingerprint(film.development, space_of(film.content));
  film.record.map_contents += uses::scene_contents(film.scene);
  film.record.way_out = ", or --replace";
  require_whole_film(options.film);
  const auto& files = options.film.files;
  require_makeable(files, film);
  say_which_are_outside(film);
  const bool part_of_light = light_alone && shard.parts > 1;
  if (part_of_light) require_photons(film, shard);
  if (!options.job.empty()) return write_job(verb, film, shard, options.job);
  FilmProgress progress(film, light_alone ? 0 : frames.size(), options.json);
  if (options.dry_run && part_of_light) return progress.file(sums_file(film, shard));
  if (options.dry_run) return list(std::move(film), frames, files, options.replace, progress);
  if (!frames.empty()) say_when_seen(film);
  std::filesystem::create_directory(film.folder);
  const uses::FilmClaim claim(film);
  require_own(film, options.replace);
  if (part_of_light) {
    trace(film, shard);
  } else if (light_alone || !frames.empty()) {
    light_up(film, options.replace, progress);
    say_unless_danjon_is_reached(film.moon.light.air,
                                 almanac::sky_at(film.moments.eclipse.greatest));
    film.record.work = film.light->plan.work;
    make_film(film, frames,
              {.kept = [&](std::size_t frame) { progress.kept(frame); },
               .made = [&](const uses::MadeFrame& frame) { progress.made(frame); }});
    if (!frames.empty())
      write_film_files(files, film, frames,
                       [&](const std::filesystem::path& file) { progress.file(file); });
  }
  progress.done();
}

}  // namespace
}  // namespace of_animate

void add_animate(Program& program) {
  using namespace of_animate;
  auto& verb = add_verb(program, "animate",
                        "makes a film of an eclipse: textures, scenes, frames, pictures; goes on "
                        "where it was stopped");
  const auto options = std::make_shared<Options>();
  add_film_moon_options(verb, options->moon);
  add_film_options(verb, options->film);
  add_described(verb, options->content);
  add_described(verb, options->view);
  add_described(verb, options->time, uses::describe_time);
  add_described(verb, options->development, uses::describe_but_time);
  add_described(verb, options->development.caption, uses::describe_caption);
  add_described(verb, options->development.camera);
  for (const char* of_our_camera :
       {"field", "focal-length", "sensor-width", "up", "mount", "aim", "passes"})
    verb.parameters.find(of_our_camera)->not_beside({{"scene"}});
  add_flag(verb, "-o,--output", options->output, "folder for what is made")
      .writes_folder()
      .required();
  add_run_switch(
      verb, "--replace", options->replace,
      "overwrites another film in the folder; linear frames that differ only in exposure are "
      "kept and developed again");
  add_flag(verb, "--job", options->job,
           "writes a job for a render farm, .yaml, and makes no film: a template of Open Job "
           "Description, with a task for each shard, then one for what needs every frame")
      .writes_file();
  add_run_switch(verb, "--dry-run", options->dry_run,
                 "lists the files that would be written, and writes none; without the film's light "
                 "those of every frame")
      .excludes("job");
  add_json_switch(verb, options->json,
                  {result::fields_of<LightEvent>, result::fields_of<FrameEvent>,
                   result::fields_of<FileEvent>, result::fields_of<DoneEvent>},
                  "prints one JSON event per line");
  on_run(verb, [&verb, options] { run(verb, *options); });
}

}  // namespace coppermoon::verbs
