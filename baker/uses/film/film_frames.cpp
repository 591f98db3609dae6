// SPDX-License-Identifier: MIT
#include "uses/film/film_frames.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <span>
#include <thread>

#include "files/memory.h"
#include "files/temporary_folder.h"
#include "povray_scenes/sequence.h"
#include "texture/read_image.h"
#include "texture/resize.h"
#include "texture/write_image.h"
#include "uses/film/film_folder.h"
#include "uses/film/film_scene.h"
#include "uses/light/header.h"
#include "uses/light/spectral_bands.h"
#include "uses/picture/disc_outline.h"
#include "uses/picture/lit_scene.h"
#include "uses/picture/pixels.h"
#include "uses/picture/sky_lights.h"
#include "uses/picture/still.h"

namespace coppermoon::uses {
namespace {

using Frames = std::span<const std::size_t>;

/// Attributes for the headers of all files of a frame.
texture::Attributes header_of(const Film& film, std::size_t frame) {
  auto header = film.record.frame_header();
  header["coppermoon:frame"] = fmt::format("{}", frame);
  header["coppermoon:instant"] = almanac::utc_text(film.moments.at(frame), 3);
  return header;
}

BakedMoon texture_of(const Film& film, const LitMoon& lit, std::size_t frame) {
  const auto extent =
      film.products.textures ? texture::Extent::whole : texture::Extent::seen_from_earth;
  auto content = film.content;
  if (film.products.framed()) {  // POV-Ray reads textures in this space, without passes
    content.space = picture_space;
    content.passes = false;
  }
  auto header = header_of(film, frame);
  auto moon = baked(lit, content, {.extent = extent, .recipe = [](const auto&, const auto&) {
                                     return std::string();  // `header` has the settings already
                                   }});
  for (const auto& [name, value] : header) moon.attributes[name] = value;
  moon.attributes["framesPerSecond"] =
      std::vector{static_cast<float>(film.fps.frames), static_cast<float>(film.fps.seconds)};
  return moon;
}

void write_texture(const Film& film, std::size_t frame, const BakedMoon& moon) {
  if (!film.products.mipmapped)
    return texture::write_exr(film.texture(frame), moon.parts, moon.attributes,
                              {type_of(film.content)});
  const auto& part = moon.parts.front();
  texture::write_mipmapped(film.texture(frame), part.layout, part.rows, moon.attributes,
                           type_of(film.content));
}

/// Exposure time at a moment [s]. It is interpolated logarithmically between keys and constant beyond the outer keys.
double keyed_time_s(const Film& film, const almanac::Instant& when) {
  const auto& keys = film.time_keys;
  const auto above = std::ranges::find_if(
      keys, [&](const auto& key) { return almanac::seconds_between(when, key.first) > 0; });
  if (above == keys.begin()) return keys.front().second;
  if (above == keys.end()) return keys.back().second;
  const auto& [from, before] = *(above - 1);
  const double share =
      almanac::seconds_between(from, when) / almanac::seconds_between(from, above->first);
  return before * std::pow(above->second / before, share);
}

/// A frame's scene and what is seen in it. For a user's scene, `seen` is empty, because the Moon may be anywhere in it.
struct Rendered {
  std::size_t frame;
  LitScene scene;
  SeenFrame seen;
};

Rendered rendered_of(const Film& film, std::size_t frame) {
  const auto sky = film.sky(frame);
  const auto view = view_of(film, sky);
  const auto lit = moon_of(film, sky, view);
  const FrameSky air(view, lit);
  return {frame,
          {lit, view, texture_of(film, lit, frame), air},
          film.scene.empty() ? seen_by(view, air) : SeenFrame{}};
}

Exposures exposures_of(const Film& film, const Rendered& rendered, const texture::Image& image) {
  auto development = film.development;
  if (!film.time_keys.empty())
    development.time = {ExposureTime::Rule::fixed,
                        keyed_time_s(film, film.moments.at(rendered.frame))};
  return exposures_for(development, image, space_of(film.content), rendered.seen);
}

void write_pictures(const Film& film, const Rendered& rendered, const texture::Image& image,
                    const Exposures& exposures) {
  const auto frame = rendered.frame;
  const auto attributes = header_of(film, frame);
  const Frame whole{image, space_of(film.content), rendered.seen, frame,
                    rendered.scene.texture.attributes};
  const auto write = [&](const std::filesystem::path& path, double stops) {
    auto exposed = exposures;
    exposed.shorter.time_s *= std::exp2(stops);
    if (exposed.longer_s) *exposed.longer_s *= std::exp2(stops);
    write_picture(film.development, exposed, whole, attributes, path);
  };
  write(film.picture(frame), 0);
  if (film.products.high_range)
    write_picture(of_high_range(film.development), exposures, whole, attributes,
                  film.high_range_picture(frame));
  if (!film.bracket_ev) return;
  write(film.picture(frame, "frame_under"), -*film.bracket_ev);
  write(film.picture(frame, "frame_over"), *film.bracket_ev);
}

/// Writes a rendered frame's linear file and pictures, if the film is to have them.
///
/// Given  frame  in the film's colour space
MadeFrame finished(const Film& film, const Rendered& rendered, const LinearFrame& frame) {
  const auto whole = frame.whole();
  const auto exposures = exposures_of(film, rendered, whole);
  auto attributes = rendered.scene.texture.attributes;
  add_exposure(attributes, exposures);
  add_seen(attributes, rendered.seen);
  if (const auto space = space_of(film.content); space != picture_space)
    say_space(attributes, space);
  if (film.products.frames)
    write_frame(film.linear_frame(rendered.frame), frame, rendered.scene.view.camera, attributes);
  if (film.products.pictures) write_pictures(film, rendered, whole, exposures);
  return {rendered.frame, exposures};
}

using WhenMade = std::function<void(const MadeFrame&)>;

/// Has POV-Ray render the user's scene for each frame, and develops each rendered frame.
void render_scene(const Film& film, Frames frames, int threads, const WhenMade& when_made) {
  for (const std::size_t frame : frames) {
    const auto rendered = rendered_of(film, frame);
    const LinearFrame light{rendered_scene(film, frame, rendered.scene, threads)};
    when_made(finished(film, rendered, in_space(light, picture_space, space_of(film.content))));
  }
}

/// Bakes the textures for a batch, has one POV-Ray process render its frames, and develops each frame once rendered.
void render(const Film& film, Frames frames, int threads, const WhenMade& when_made) {
  const files::TemporaryFolder folder;
  const auto texture_file = [&](std::size_t number) {
    return folder.path() / povray_scenes::numbered_file(texture_stem, number, frames.size());
  };
  povray_scenes::Sequence sequence{
      .cameras = {}, .textures = texture_stem, .alpha = film.content.passes};
  std::vector<Rendered> batch;
  std::vector<std::vector<SkyLight>> lights;
  for (const std::size_t frame : frames) {
    auto& scene = batch.emplace_back(rendered_of(film, frame)).scene;
    auto& moon = scene.texture;
    const auto path = texture_file(batch.size());
    if (film.products.textures) {
      write_texture(film, frame, moon);
      files::name_also(film.texture(frame), path);
    } else {
      texture::write_exr(path, moon.parts, moon.attributes, {.packed = false});
    }
    moon.parts.clear();  // the texture is written; this frees the look-up tables in its parts
    sequence.cameras.push_back(scene.view.camera);
    lights.push_back(sky_lights(scene.view, scene.moon.sky));
  }
  write_sequence(folder.path(), sequence);
  const auto in_film_space = [&](std::size_t number, const std::filesystem::path& rendered) {
    const auto& [moon, view, baked, air] = batch[number - 1].scene;
    const auto frame =
        completed(texture::read_image(rendered), view, moon.sky, lights[number - 1], air);
    return in_space(frame, picture_space, space_of(film.content));
  };
  povray_scenes::render_sequence(
      folder.path(), 1, frames.size(),
      [&](std::size_t number, const std::filesystem::path& rendered) {
        when_made(finished(film, batch[number - 1], in_film_space(number, rendered)));
        std::filesystem::remove(rendered);
        std::filesystem::remove(texture_file(number));
      },
      {.threads = threads, .window = disc_window(sequence.cameras)});
}

/// Rewrites the header of an existing linear frame, and its pictures, for another exposure. Its pixels stay the same.
void expose(const Film& film, std::size_t frame, const WhenMade& when_made) {
  const auto rendered = rendered_of(film, frame);
  if (film.products.textures && !is_own(film, film.texture(frame), frame))
    write_texture(film, frame, rendered.scene.texture);
  auto made = finished(film, rendered, {texture::read_image(film.linear_frame(frame))});
  made.developed_again = true;
  when_made(made);
}

void bake(const Film& film, std::size_t frame, const WhenMade& when_made) {
  const auto sky = film.sky(frame);
  const auto moon = texture_of(film, moon_of(film, sky, view_of(film, sky)), frame);
  write_texture(film, frame, moon);
  when_made({frame, std::nullopt});
}

double texels_of(const Film& film) {
  const auto width = static_cast<double>(texture_width_of(film.moon));
  return width * width / 2;
}

/// Number of batches to make at the same time: one more than there are processors, because POV-Ray is idle while it
/// starts, but no more than fit into half of the memory. POV-Ray needs 28 bytes per texel.
std::size_t lanes_of(const Film& film, std::size_t processors) {
  if (processors == 1) return 1;
  const auto [width, height] = std::pair(film.view.width, film.view.height);
  const double of_glow = film.development.camera.model.empty()
                             ? 0
                             : frame_memory(width, height, true) - frame_memory(width, height),
               a_lane = 28 * texels_of(film) + of_glow + 64e6;
  const double most = std::max(1., files::available_memory() / 2 / a_lane);
  return static_cast<std::size_t>(std::min(most, static_cast<double>(processors + 1)));
}

/// Number of frames that one POV-Ray process renders. It is small enough for their textures to take at most 256 MB. It
/// also lets every parallel lane have at least two batches, so that all lanes finish at about the same time.
std::size_t frames_a_batch(const Film& film, std::size_t frames, std::size_t lanes) {
  if (!film.products.rendered()) return 1;
  constexpr double waiting = 256e6, most = 16;
  const double fit = std::clamp(waiting / (6 * texels_of(film)), 1., most);
  return std::min(static_cast<std::size_t>(fit), std::max<std::size_t>(1, frames / (2 * lanes)));
}

/// The frames that have not been made yet. Calls events.kept for each of the others.
std::vector<std::size_t> missing_of(const Film& film, const std::vector<std::size_t>& frames,
                                    const FilmEvents& events) {
  std::vector<char> there(frames.size());
  tbb::parallel_for(std::size_t{0}, frames.size(),
                    [&](std::size_t i) { there[i] = is_made(film, frames[i]); });
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < frames.size(); ++i)
    if (!there[i])
      missing.push_back(frames[i]);
    else if (events.kept)
      events.kept(frames[i]);
  return missing;
}

}  // namespace

void make_frames(const Film& film, const std::vector<std::size_t>& frames, const WhenMade& made) {
  const auto processors =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  const auto most = lanes_of(film, processors);
  const auto length = frames_a_batch(film, frames.size(), most);
  const auto lanes = std::min(most, (frames.size() + length - 1) / length);
  const auto threads =
      static_cast<int>(lanes < processors ? processors / std::max<std::size_t>(1, lanes) : 1);
  std::atomic<std::size_t> next = 0;
  std::mutex one_at_a_time;
  std::exception_ptr failure;
  const WhenMade when_made = [&](const MadeFrame& frame) {
    const std::lock_guard lock(one_at_a_time);
    if (failure) std::rethrow_exception(failure);
    made(frame);
  };
  const auto make = [&](Frames batch) {
    std::vector<std::size_t> unseen;
    for (const std::size_t frame : batch)
      if (!film.products.rendered())
        bake(film, frame, when_made);
      else if (!film.content.passes && shows_scene(film, frame))
        expose(film, frame, when_made);
      else
        unseen.push_back(frame);
    if (!unseen.empty())
      (film.scene.empty() ? render : render_scene)(film, unseen, threads, when_made);
  };
  const auto work = [&] {
    try {
      for (std::size_t first; (first = next.fetch_add(length)) < frames.size();)
        make(Frames(frames).subspan(first, std::min(length, frames.size() - first)));
    } catch (...) {
      const std::lock_guard lock(one_at_a_time);
      if (!failure) failure = std::current_exception();
      next = frames.size();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < lanes; ++i) others.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

void write_film_scene(const Film& film) {
  povray_scenes::Sequence sequence{
      .cameras = {}, .textures = texture_stem, .first_frame = film.moments.first_frame};
  for (auto frame = film.moments.first_frame; frame <= film.moments.last_frame(); ++frame)
    sequence.cameras.push_back(view_of(film, film.sky(frame)).camera);
  write_sequence(film.folder, sequence);
}

Film with_ground(Film film) {
  const auto albedo = normal_albedo(film.moon);
  film.albedo = std::make_shared<const algebra::Grid<float>>(
      texture::resized(albedo, texture_width_of(film.moon) / 2));
  film.ground = ground_of(film.moon, albedo);
  return film;
}

void make_film(const Film& film, const std::vector<std::size_t>& frames, const FilmEvents& events) {
  if (film.products.light_alone() || frames.empty()) return;
  if (film.products.scenes) write_film_scene(film);
  const auto missing = missing_of(film, frames, events);
  if (missing.empty()) return;
  make_frames(with_ground(film), missing, [&](const MadeFrame& frame) {
    if (events.made) events.made(frame);
  });
}

}  // namespace coppermoon::uses
