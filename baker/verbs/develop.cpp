// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "algebra/error.h"
#include "files/whole_file.h"
#include "texture/own_image.h"
#include "texture/read_image.h"
#include "uses/picture/photo_file.h"
#include "uses/picture/picture_files.h"
#include "uses/picture/picture_parameters.h"
#include "verbs/command_line.h"
#include "verbs/flags/camera_options.h"
#include "verbs/flags/named_files.h"
#include "verbs/recipes/recipe_file.h"
#include "verbs/reports/in_words.h"
#include "verbs/reports/one_line.h"
#include "verbs/reports/report.h"

namespace coppermoon::verbs {
namespace of_develop {
namespace {

namespace fs = std::filesystem;

struct Options {
  uses::Development develop;
  std::vector<std::string> frames;
  std::string output, space;
  std::optional<double> sky_cd_m2{};
  bool json = false;
};

/// Colour space of a frame, from --space, the frame's header or its file name, in this order; else linear Rec.709.
colour::WorkingSpace space_of(const Options& options, const std::string& frame) {
  if (!options.space.empty()) return colour::working_space(options.space);
  if (const auto name = texture::read_attribute(frame, "coppermoon:colour_space"))
    return colour::working_space(*name);
  const auto stem = fs::path(frame).stem().string();
  return colour::space_in_name(stem).value_or(colour::WorkingSpace::linear_rec709);
}

texture::Image light_of(const Options& options, const std::string& frame,
                        colour::WorkingSpace space) {
  if (texture::is_raw_file(frame))
    return uses::raw_light(frame, space, options.develop.camera.response);
  if (space == colour::WorkingSpace::ciexyz_d65)
    return texture::read_channels(frame, {"X", "Y", "Z"});
  return texture::read_channels(frame, {"R", "G", "B"});
}

/// A frame to develop, the file for its picture, and what the frame's header says.
struct Job {
  std::string frame;
  fs::path picture;
  colour::WorkingSpace space;
  uses::SeenFrame seen;
};

/// The light of a frame, including the sky's light, and what the frame's header says.
struct Read {
  texture::Image light;
  uses::SeenFrame seen;
};

Read read_frame(const Options& options, const Job& job) {
  Read read{light_of(options, job.frame, job.space), job.seen};
  auto& [light, seen] = read;
  if (seen.sky_cd_m2 > 0 && options.sky_cd_m2)
    throw algebra::Error(fmt::format("{}: holds a sky of {:.3g} cd/m², allowed sky = auto",
                                     job.frame, seen.sky_cd_m2));
  if (seen.sky_cd_m2 > 0) return read;
  seen.sky_cd_m2 = options.sky_cd_m2.value_or(seen.sky_left_out_cd_m2);
  const auto white = colour::white(job.space);
  for (std::size_t i = 0; seen.sky_cd_m2 > 0 && i < light.values.size(); ++i)
    light.values[i] += static_cast<float>(seen.sky_cd_m2 * white[int(i % 3)]);
  return read;
}

/// Makes a job for each frame. For a single frame, --output may name the picture's file. Otherwise it names a folder,
/// in which the pictures are named after their frames.
std::vector<Job> jobs_of(const Options& options) {
  std::vector<Job> jobs;
  const bool folder = options.frames.size() > 1 || !fs::path(options.output).has_filename() ||
                      fs::is_directory(options.output);
  for (const auto& frame : options.frames) {
    fs::path picture = options.output;
    if (folder) picture = picture / (fs::path(frame).stem().string() + ".png");
    for (const auto& other : jobs)
      if (other.picture == picture)
        throw algebra::Error(
            fmt::format("{}: {} and {} would become one picture, allowed frames "
                        "of different names",
                        picture.string(), other.frame, frame));
    jobs.push_back({frame, picture, space_of(options, frame), uses::seen_by(fs::path(frame))});
  }
  if (folder && ends_as_a_file(options.output) && !fs::exists(options.output))
    throw algebra::Error(fmt::format("{}: {} frames are developed into a folder, allowed its name",
                                     options.output, jobs.size()));
  return jobs;
}

/// Throws if a picture cannot be written, and creates the folder for the pictures if it is missing.
void require_place(const Options& options, const std::vector<Job>& jobs) {
  const fs::path output = options.output;
  const auto& camera = options.develop.camera;
  if (jobs.size() > 1 && !(camera.raw.empty() && camera.photograph.empty()))
    throw algebra::Error(fmt::format(
        "{} frames: a raw file or a photograph can be written for one frame alone", jobs.size()));
  if (jobs.front().picture == output) {
    files::require_place_for(output);
  } else if (fs::is_directory(output)) {
    for (const auto& job : jobs) texture::require_own_image(job.picture);
  } else {
    if (fs::exists(output)) throw algebra::Error(output.string() + ": is no directory");
    const auto plain = output.has_filename() ? output : output.parent_path();
    files::require_place_for(plain);
    fs::create_directory(plain);
  }
  for (const auto& file : {camera.raw, camera.photograph})
    if (!file.empty()) files::require_place_for(file);
  for (const auto& job : jobs) {
    std::error_code none;
    if (fs::equivalent(job.picture, job.frame, none))
      throw algebra::Error(fmt::format("{}: the picture would overwrite the frame, allowed another",
                                       job.picture.string()));
  }
}

/// Computes a single exposure from all frames, with which all frames are developed.
uses::Exposures shared_exposures(const Options& options, const std::vector<Job>& jobs) {
  if (jobs.size() == 1) {
    const auto [light, seen] = read_frame(options, jobs.front());
    return exposures_for(options.develop, light, jobs.front().space, seen);
  }
  uses::SharedExposure shared(options.develop);
  if (options.develop.time.rule != uses::ExposureTime::Rule::fixed)
    for (const auto& job : jobs) {
      const auto [light, seen] = read_frame(options, job);
      shared.add(light, job.space, seen);
    }
  return shared.exposures();
}

/// Exposure for developing all frames. Its flag `a_cameras` is true if every frame is exposed like a photograph.
uses::Exposures exposures_of(const Options& options, const std::vector<Job>& jobs) {
  auto exposures = shared_exposures(options, jobs);
  exposures.a_cameras = std::ranges::all_of(
      jobs, [&](const Job& job) { return is_a_cameras(options.develop, job.seen); });
  return exposures;
}

/// Luminances that are rendered as white [cd/m²], for the shorter exposure and, if there is one, the longer exposure.
std::vector<double> whites_of(const Options& options, uses::Exposures exposures) {
  std::vector<double> whites{1 / scale_of(options.develop, exposures.shorter)};
  if (!exposures.longer_s) return whites;
  exposures.shorter.time_s = *exposures.longer_s;
  whites.push_back(1 / scale_of(options.develop, exposures.shorter));
  return whites;
}

std::string in_words(const Options& options, const uses::Exposures& exposures) {
  if (exposures.a_cameras)
    return fmt::format("exposed for {}, f/{:.3g}, ISO {:g}", exposure_in_words(exposures),
                       exposures.shorter.f_number, exposures.shorter.iso);
  return fmt::format("white is {:.3g} cd/m²", fmt::join(whites_of(options, exposures), " and "));
}

void develop(const Options& options, const Job& job, const uses::Exposures& exposures,
             std::size_t number) {
  const auto [frame, seen] = read_frame(options, job);
  warn_of_another_camera(job.frame, options.develop.camera.response);
  if (const double sky = sky_over_moon(frame, job.space, seen); sky > 1)
    fmt::print(stderr, "coppermoon: {}: {}\n", one_line(job.frame), bright_sky_in_words(sky));
  write_picture(options.develop, exposures,
                {frame, job.space, seen, number, uses::scene_attributes(job.frame)}, {},
                job.picture);
}

/// The pictures that the command made, and how they were exposed.
struct Developed {
  std::vector<std::string> files;
  std::string_view space;
  std::vector<double> whites;
  uses::Exposures exposures;
};

template <class Field>
void describe(Field&& is, const Developed& made) {
  namespace unit = algebra::unit;
  const auto& [exposure, longer_s, a_cameras] = made.exposures;
  const auto of_camera = [&](double value) {
    return algebra::if_any(made.exposures.a_cameras ? std::optional(value) : std::nullopt);
  };
  is.a("Developed", "Pictures that were made, and how they were exposed.");
  describe_files(is, made.files);
  is("colour_space", made.space, "colour space of the frames");
  is("white_cd_m2", algebra::if_any(a_cameras ? std::nullopt : std::optional(made.whites)),
     unit::luminance, "luminances that become white, where no camera takes the picture");
  is("time_s", of_camera(exposure.time_s), unit::seconds, "exposure time of a camera's picture");
  is("longer_time_s", algebra::if_any(a_cameras ? longer_s : std::nullopt), unit::seconds,
     "longer exposure time, of a composite");
  is("f_number", of_camera(exposure.f_number), "f-number");
  is("iso", of_camera(exposure.iso), "ISO speed");
}

void run(const Options& options) {
  const auto jobs = jobs_of(options);
  for (const auto& job : jobs) require_sound(options.develop, job.picture);
  require_place(options, jobs);
  const auto exposures = exposures_of(options, jobs);
  for (std::size_t j = 0; j < jobs.size(); ++j) {
    develop(options, jobs[j], exposures, j);
    if (!options.json)
      fmt::print("{}: {}\n", one_line(jobs[j].picture.string()), in_words(options, exposures));
  }
  if (!options.json) return;
  Developed made{{}, colour::name(jobs.front().space), whites_of(options, exposures), exposures};
  for (const auto& job : jobs) made.files.push_back(job.picture.string());
  fmt::print("{}\n", result::as_json(made).dump(2));
}

}  // namespace
}  // namespace of_develop

void add_develop(Program& program) {
  using namespace of_develop;
  auto& verb =
      add_verb(program, "develop",
               "develops a scene-linear frame: exposure, camera and view make a picture of it");
  const auto options = std::make_shared<Options>();
  add_flag(verb, "frame,--frame", options->frames,
           "frame, scene-linear, .exr [cd/m²], or a camera's raw file; several share one exposure")
      .reads_file()
      .of(request::Affects::share)
      .required();
  add_flag(verb, "-o,--output", options->output,
           "picture: " + files::in_words(uses::picture_files()) + "; for several frames a folder")
      .writes_file(uses::picture_files())
      .required();
  add_flag(
      verb, "--space", options->space,
      "colour space of the frame: lin_rec709, acescg or lin_ciexyzd65_scene; default: what the "
      "header or the name says");
  add_described(verb, options->sky_cd_m2, uses::describe_sky_of_frame);
  add_described(verb, options->develop);
  add_described(verb, options->develop.caption, uses::describe_caption);
  add_described(verb, options->develop.camera);
  add_camera_file_options(verb, options->develop.camera);
  add_json_switch(verb, options->json, {result::fields_of<Developed>});
  on_run(verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
