// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <sstream>

#include "algebra/error.h"
#include "algebra/number.h"
#include "texture/resize.h"
#include "verbs/film.h"
#include "verbs/film_account.h"
#include "verbs/film_files.h"
#include "verbs/film_folder.h"
#include "verbs/film_light.h"
#include "verbs/film_progress.h"
#include "verbs/frame_range.h"
#include "verbs/lit_scene.h"
#include "verbs/pixels.h"
#include "verbs/recipe.h"
#include "verbs/temporary_folder.h"
#include "verbs/verbs.h"

namespace coppermoon::verbs {
namespace {

struct Options {
  Film film;
  FilmFiles files;
  std::string make = "pictures", mount = "tracking", aim, range, shard = "1/1", output;
  bool json = false, replace = false;
};

/// Exposures at moments, as "P1:0.001,U2:4": nothing when the time is no such list.
std::vector<std::pair<almanac::Instant, double>> time_keys(const std::string& text,
                                                           const eclipse::Eclipse& eclipse) {
  std::vector<std::pair<almanac::Instant, double>> keys;
  if (text.find(':') == std::string::npos) return keys;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto colon = part.rfind(':');
    const auto seconds =
        colon == std::string::npos ? std::nullopt : algebra::number_in(part.substr(colon + 1));
    if (!seconds)
      throw algebra::Error(fmt::format(
          "exposure time = {}, allowed keys as P1:0.001,U2:4: a moment and seconds", text));
    algebra::require_within("exposure time [s]", *seconds, 1e-6, 1e6);
    keys.emplace_back(moment_from(part.substr(0, colon), eclipse), *seconds);
  }
  for (std::size_t i = 1; i < keys.size(); ++i)
    if (almanac::seconds_between(keys[i - 1].first, keys[i].first) <= 0)
      throw algebra::Error(fmt::format("exposure time = {}, allowed keys in order of time", text));
  return keys;
}

/// As wide as the frame needs where the Moon is nearest: one width for all.
std::size_t texture_width(const Film& film) {
  if (film.moon.texture_width || !film.products.framed()) return texture_width_of(film.moon);
  std::size_t widest = 0;
  const std::size_t count = film.moments.frames.size();
  for (const std::size_t frame : {std::size_t{1}, (count + 1) / 2, count})
    widest =
        std::max(widest, *fitted(film.moon, view_of(film, film.sky(frame)).camera).texture_width);
  return widest;
}

/// The Moon is up in all frames that show it, as far as a few hundred of them tell.
void require_up(const Film& film, const std::vector<std::size_t>& frames) {
  if (film.view.at.empty() || film.products.light_alone()) return;
  const std::size_t step = std::max<std::size_t>(1, frames.size() / 240);
  std::vector<std::size_t> up, down;
  const auto look = [&](std::size_t frame) {
    (moon_is_up(film.view, film.sky(frame)) ? up : down).push_back(frame);
  };
  for (std::size_t i = 0; i + 1 < frames.size(); i += step) look(frames[i]);
  look(frames.back());
  if (down.empty()) return;
  if (up.empty())
    throw algebra::Error(
        fmt::format("the Moon is below the horizon of {} in all frames", film.view.at));
  const auto [first, last] = std::ranges::minmax(up);
  throw algebra::Error(fmt::format(
      "the Moon is below the horizon of {} in frame {}; it is up from frame {} ({}) to {}",
      film.view.at, std::ranges::min(down), first,
      almanac::utc_text(film.moments.frames[first - 1]), last));
}

void set_up(Options& options) {
  options.film.view = seen_through(options.film.develop.camera, options.film.view);
  options.film.develop.focal_length_mm = options.film.view.focal_length_mm;
  auto& film = options.film;
  if (options.mount == "horizon") film.view.up = "zenith";
  if (options.mount != "fixed") {
    if (!options.aim.empty())
      throw algebra::Error(fmt::format("mount = {}, allowed fixed with --aim", options.mount));
    return;
  }
  if (film.view.at.empty()) throw algebra::Error("mount = fixed, allowed with --at alone");
  film.view.aim = options.aim.empty()
                      ? apparent_place(film.view, film.sky((film.moments.frames.size() + 1) / 2))
                      : aim_from(options.aim);
}

/// POV-Ray reads textures of its own colours, and of nothing else.
void require_content(const Film& film) {
  require_sound(film.content);
  if (!film.products.framed()) return;
  if (space_of(film.content) != colour::WorkingSpace::linear_rec709)
    throw algebra::Error(fmt::format(
        "space = {}, allowed lin_rec709 with scenes, frames or pictures", *film.content.space));
  if (film.content.passes || film.content.spectral_nm)
    throw algebra::Error("passes and spectra: allowed with --make textures alone");
}

/// All but the light and the map: what may be refused before any work.
///
/// Returned  the frames to be made
std::vector<std::size_t> prepare(const CLI::App& verb, Options& options) {
  auto& film = options.film;
  film.folder = options.output;
  film.products = products_from(options.make);
  require_content(film);
  film.moments = moments_of(film.times);
  film.time_keys = time_keys(film.develop.time, film.moments.eclipse);
  auto develop = film.develop;
  if (!film.time_keys.empty()) develop.time = "auto";
  require_sound(develop, film.picture(1));
  if (film.products.rendered()) require_temporary_folder();
  if (film.bracket_ev) algebra::require_within("bracket [EV]", *film.bracket_ev, 0.01, 10);
  set_up(options);
  if (std::filesystem::exists(film.folder) && !std::filesystem::is_directory(film.folder))
    throw algebra::Error(fmt::format("{}: is no directory", film.folder.string()));
  if (!std::filesystem::is_directory(film.folder)) require_place_for(film.folder);
  auto frames =
      part_of(frames_in(options.range, film.moments.frames.size()), shard_from(options.shard));
  if (!frames.empty()) require_up(film, frames);
  film.moon.texture_width = texture_width(film);
  film.recipe = with_width(recipe_of(verb), *film.moon.texture_width);
  require_map(film.moon);
  film.map_contents = map_contents(film.moon);
  film.view_contents = fingerprint(film.develop, picture_space);
  if (std::filesystem::exists(film.folder)) require_own(film, options.replace);
  return frames;
}

/// One part of the photons, for a run that makes more than the light.
void trace(const Options& options, const FilmProgress& progress) {
  const auto& film = options.film;
  const auto shard = shard_from(options.shard);
  trace_shard(film.moon.light, film.moments.frames.front(), film.moments.frames.back(), shard.part,
              shard.parts, film.folder);
  progress.done();
}

void light_up(Film& film, bool replace, const FilmProgress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const auto width = static_cast<double>(*film.moon.texture_width);
  auto found = film_light(film.moon.light, film.moments.frames.front(), film.moments.frames.back(),
                          {width * width / 2, reads_map(film.moon)}, of_light(account_of(film)),
                          film.folder, replace);
  film.light = std::make_shared<const Moonlight>(std::move(found.light));
  film.recipe = with_work(film.recipe, film.light->plan.work);
  progress.light(found.kept,
                 std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

/// At the textures' own size, so that no frame has to make it so again.
void lay_ground(Film& film) {
  auto albedo = normal_albedo(film.moon);
  film.albedo = std::make_shared<const algebra::Grid<float>>(
      texture::resized(albedo, *film.moon.texture_width / 2));
}

void run(const CLI::App& verb, Options& options) {
  auto& film = options.film;
  const auto frames = prepare(verb, options);
  require_makeable(options.files, film, shard_from(options.shard));
  std::filesystem::create_directory(film.folder);
  const bool light_alone = film.products.light_alone();
  FilmProgress progress(film, light_alone ? 0 : frames.size(), options.json);
  if (light_alone && shard_from(options.shard).parts > 1) return trace(options, progress);
  if (light_alone || !frames.empty()) light_up(film, options.replace, progress);
  if (light_alone || frames.empty()) {
    if (!frames.empty()) write_film_files(options.files, film, frames, progress);
    return progress.done();
  }
  if (film.products.scenes) write_film_scene(film);
  std::vector<char> there(frames.size());
  tbb::parallel_for(std::size_t{0}, frames.size(),
                    [&](std::size_t i) { there[i] = is_made(film, frames[i]); });
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < frames.size(); ++i)
    if (there[i])
      progress.kept(frames[i]);
    else
      missing.push_back(frames[i]);
  if (!missing.empty()) lay_ground(film);
  make_frames(film, missing, [&](const MadeFrame& frame) { progress.made(frame); });
  write_film_files(options.files, film, frames, progress);
  progress.done();
}

void add_film_options(CLI::App& verb, Options& options) {
  const std::string group = "The film";
  add_film_times(verb, options.film.times);
  add_flag(verb, "--make", options.make,
           "textures, scenes (with their textures), frames (scene-linear) and pictures, "
           "with commas between; or light: what they all need, alone")
      .in(group);
  add_flag(verb, "--range", options.range, "of all frames, as 1-240, 1-240x2 or 7,9,20-30")
      .in(group);
  add_flag(verb, "--shard", options.shard,
           "K/N: every N-th frame of these from the K-th on; of light: of its photons")
      .in(group);
  add_flag(verb, "--mount", options.mount,
           "tracking: the Moon in the middle; horizon: and the zenith up; fixed: on a "
           "tripod, the zenith up")
      .one_of({"tracking", "horizon", "fixed"})
      .in(group);
  add_flag(verb, "--aim", options.aim,
           "ALTITUDE,AZIMUTH of a fixed mount [degrees, as seen; from north through east]; "
           "without: where the Moon is half way")
      .in(group);
  add_flag(verb, "--bracket", options.film.bracket_ev,
           "pictures so many stops under and over as well, 0.01 to 10")
      .in(group);
}

}  // namespace

void add_animate(CLI::App& program) {
  auto* verb =
      add_verb(program, "animate",
               "An eclipse frame by frame: textures, scenes, frames, pictures; goes on where it "
               "was stopped");
  const auto options = std::make_shared<Options>();
  options->film.develop.time = "follow";
  add_film_moon_options(*verb, options->film.moon);
  for (const char* of_photons : {"--shard", "--keep", "--add"}) remove_flag(*verb, of_photons);
  remove_flag(*verb, "--unshadowed");
  add_film_options(*verb, *options);
  add_film_files(*verb, options->files);
  add_texture_options(*verb, options->film.content);
  add_view_options(*verb, options->film.view);
  add_develop_options(*verb, options->film.develop);
  add_camera_options(*verb, options->film.develop.camera);
  for (const char* of_one : {"--raw", "--photograph"}) remove_flag(*verb, of_one);
  add_flag(*verb, "-o,--output", options->output, "the folder").writes_folder().required();
  add_switch(
      *verb, "--replace", options->replace,
      "files of another film in the folder are made anew; linear frames that differ by their "
      "exposure alone are kept, and developed again");
  add_switch(*verb, "--json", options->json, "an event a line on stdout, as JSON");
  add_recipe_option(*verb);
  on_run(*verb, [verb, options] { run(*verb, *options); });
}

}  // namespace coppermoon::verbs
