// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <memory>

#include "algebra/error.h"
#include "almanac/instant.h"
#include "files/cache_folder.h"
#include "files/endings.h"
#include "files/fingerprint.h"
#include "files/lock.h"
#include "files/memory.h"
#include "files/whole_file.h"
#include "texture/images_ahead.h"
#include "texture/own_image.h"
#include "texture/seal.h"
#include "texture/usd_text.h"
#include "texture/write_glb.h"
#include "texture/write_image.h"
#include "texture/write_stellarium.h"
#include "texture/write_usda.h"
#include "texture/write_usdz.h"
#include "uses/light/header.h"
#include "uses/picture/baked_moon.h"
#include "uses/picture/lit_scene.h"
#include "uses/picture/picture_parameters.h"
#include "uses/picture/pixels.h"
#include "uses/picture/texture_recipe.h"
#include "uses/picture/view.h"
#include "verbs/cache.h"
#include "verbs/command_line.h"
#include "verbs/flags/moon_options.h"
#include "verbs/flags/named_files.h"
#include "verbs/reports/progress_bar.h"
#include "verbs/reports/report.h"

namespace coppermoon::verbs {
namespace of_bake {
namespace {

struct Options {
  MoonOptions moon;
  uses::TextureContent texture;
  uses::ViewRequest view;  ///< only its observer and the air above the observer are used
  uses::Development develop;
  std::vector<std::string> outputs;
  std::string cache;  ///< folder for cached textures; if empty, no cache is used
  bool json = false;
};

struct Job;

struct Format : files::Ending {
  void (*write)(const Job& job);
  bool developed = false;  ///< the file holds a developed picture of the texture
  bool on_globe = false;   ///< the file shows the picture on a sphere
};

/// A file to write, with its content and format.
struct Output {
  std::filesystem::path path;
  uses::TextureContent content;
  const Format& format;

  bool ends_in(const char* ending) const { return format.ending == ending; }
  bool for_stellarium() const { return ends_in(".stellarium"); }
  /// Whether the file is a glTF sphere with light in cd/m². A name such as moon_lin_rec709.glb selects this.
  bool in_cd_m2() const {
    return ends_in(".glb") &&
           colour::space_in_name(path.stem().string()) == colour::WorkingSpace::linear_rec709;
  }
  bool developed() const { return format.developed && !in_cd_m2(); }
};

/// One of the outputs, and everything that is needed to write it.
struct Job {
  const Options& options;
  const std::vector<Output>& outputs;
  const Output& output;
  const uses::LitMoon& moon;
  const uses::BakedMoon& made;

  const texture::Part& texture() const { return made.parts.front(); }
};

/// Texture to be developed. Its rows are kept in memory if they need at most 256 MB, because they are read twice.
uses::LitTexture lit_texture(const Job& job) {
  constexpr std::size_t most_kept = 256U << 20U;
  const auto& layout = job.texture().layout;
  uses::LitTexture texture{layout, job.texture().rows, space_of(job.output.content)};
  if (layout.width * layout.height * layout.channels.size() * sizeof(float) > most_kept)
    return texture;
  const auto kept = std::make_shared<const texture::Image>(uses::image_of(layout, texture.rows));
  texture.rows = [kept, rows = texture::rows_of(*kept)](std::size_t row, std::span<float> values) {
    rows(row, values);
  };
  return texture;
}

/// Developed picture of a texture. Its rows are computed when they are needed.
struct Shown {
  texture::Layout layout;
  texture::Rows rows;
  uses::Exposures exposures;
};

Shown shown(const Job& job) {
  const auto texture = lit_texture(job);
  const auto exposures = exposures_for(job.options.develop, texture);
  return {{texture.layout.width, texture.layout.height, {"R", "G", "B"}},
          developed_rows(job.options.develop, exposures, texture),
          exposures};
}

void write_exr(const Job& job) {
  texture::write_exr(job.output.path, job.made.parts, job.made.attributes,
                     {type_of(job.output.content)});
}

void write_tx(const Job& job) {
  texture::write_mipmapped(job.output.path, job.texture().layout, job.texture().rows,
                           job.made.attributes, type_of(job.output.content));
}

void write_picture(const Job& job) {
  const auto& develop = job.options.develop;
  const auto texture = lit_texture(job);
  write_picture(develop, exposures_for(develop, texture), texture, job.made.attributes,
                job.output.path);
}

void write_glb(const Job& job) {
  const auto generator = fmt::format("coppermoon {}", uses::version());
  if (job.output.in_cd_m2())
    return texture::write_glb(job.output.path,
                              uses::image_of(job.texture().layout, job.texture().rows), generator,
                              texture::GlbTexels::luminance);
  const auto picture = shown(job);
  texture::write_glb(job.output.path, uses::image_of(picture.layout, picture.rows), generator);
}

void write_usdz(const Job& job) {
  const auto picture = shown(job);
  texture::write_usdz(job.output.path, uses::image_of(picture.layout, picture.rows));
}

void write_stellarium(const Job& job) {
  const auto picture = shown(job);
  auto attributes = job.made.attributes;
  uses::add_exposure(attributes, picture.exposures);
  texture::write_stellarium(job.output.path, picture.layout, picture.rows,
                            {job.moon.sky.when, *job.moon.observer}, attributes);
}

void write_usda(const Job& job);

constexpr std::array formats{
    Format{{".exr", "scene-linear"}, write_exr},
    Format{{".tx", "scene-linear, tiled and mip-mapped"}, write_tx},
    Format{{".png", "developed"}, write_picture, true},
    Format{{".jpg", "developed, 8 bits, without its recipe"}, write_picture, true},
    Format{{".glb", "developed, on a sphere; moon_lin_rec709.glb in cd/m²"}, write_glb, true, true},
    Format{{".usda", "a sphere, with its moon_lin_rec709.exr beside it"}, write_usda},
    Format{{".usdz", "developed, on a sphere, for telephones"}, write_usdz, true, true},
    Format{{".stellarium", "a folder for Stellarium, needs --at"}, write_stellarium, true}};

/// Output for a file name. If the name contains a colour space, the output has that colour space.
Output output_at(const std::string& file, const uses::TextureContent& asked) {
  Output output{file, asked, files::format_of(file, formats, "a texture")};
  output.content.space = space_for(file, asked.space);
  if (output.ends_in(".exr")) return output;
  output.content.passes = false;
  output.content.spectral_nm.reset();
  return output;
}

/// The .exr output with the given colour space in the same folder as a .usda; if there is none, the end of `outputs`.
std::vector<Output>::const_iterator texture_for(const Output& scene, colour::WorkingSpace space,
                                                const std::vector<Output>& outputs) {
  return std::ranges::find_if(outputs, [&](const Output& output) {
    return output.ends_in(".exr") && output.path.parent_path() == scene.path.parent_path() &&
           space_of(output.content) == space;
  });
}

/// Adds the .exr outputs that a .usda needs but the user did not name. A .usda needs one in linear Rec.709, because its
/// preview surface knows no other colour space, and one in ACEScg if that is the requested space.
///
/// Throws  Error  if an added output would overwrite a file that coppermoon did not make
void add_textures_of_usd(const Options& options, std::vector<Output>& outputs) {
  const auto named = outputs;
  for (const auto& scene : named) {
    if (!scene.ends_in(".usda")) continue;
    for (const auto space : {colour::WorkingSpace::linear_rec709, space_of(scene.content)}) {
      const bool shown = space != colour::WorkingSpace::ciexyz_d65;
      if (!shown || texture_for(scene, space, outputs) != outputs.end()) continue;
      Output texture{scene.path, options.texture, formats.front()};
      texture.path.replace_filename(
          fmt::format("{}_{}.exr", scene.path.stem().string(), colour::name(space)));
      texture.content.space = space;
      texture::require_own_image(texture.path);
      outputs.push_back(texture);
    }
  }
}

/// Memory needed to write a file [bytes]. Measured at 8192 columns, the smaller levels of a mip-map need 0.7 times the
/// size of all texels as floats, and a sphere needs 2.1 times that size for its picture and PNG. The estimate is a
/// little higher. Other formats are written row by row and need none.
double memory_for(const Output& output, double texture_width) {
  constexpr double a_texel = 3 * sizeof(float);
  const double all = a_texel * texture_width * texture_width / 2;
  return output.format.on_globe ? 2.5 * all : output.ends_in(".tx") ? 0.75 * all : 0;
}

/// Throws if an output cannot be written at its path. A file that exists there is allowed, because it will be replaced.
void require_place_for(const Output& output) {
  const bool folder = std::filesystem::is_directory(output.path);
  if (output.for_stellarium() && folder) return texture::require_stellarium_place(output.path);
  if (output.for_stellarium() && std::filesystem::exists(output.path))
    throw algebra::Error(
        fmt::format("{}: is a file, allowed a folder or a new name", output.path.string()));
  files::require_place_for(output.path);
}

void require_sound(const Options& options, const std::vector<Output>& outputs) {
  bool exr = false;
  for (const auto& output : outputs) {
    exr |= output.ends_in(".exr");
    if (output.developed()) require_sound(options.develop, output.path.stem() += ".png");
    const auto width = texture_width_of(options.moon.request);
    if (output.format.on_globe && width > texture::most_glb_columns)
      throw algebra::Error(fmt::format("{}: texture width [texels] = {}, allowed to {}",
                                       output.path.string(), width, texture::most_glb_columns));
    if (output.for_stellarium() && !options.view.observer)
      throw WrongUsage(
          fmt::format("{}: Stellarium looks from a place, given with --at", output.path.string()));
    if (output.ends_in(".usda")) texture::require_usd_name(output.path.filename().string());
    require_place_for(output);
    files::require_memory(output.path.string(), memory_for(output, static_cast<double>(width)));
  }
  require_sound(options.texture);
  if (!exr && (options.texture.passes || options.texture.spectral_nm))
    throw algebra::Error("passes and spectra need an output that ends in .exr");
}

/// Recipe to record in one output: with that output's colour space, without passes and spectra that the output lacks.
request::Recipe recipe_for(const uses::TextureContent& content, const request::Recipe& recipe) {
  auto own = with({{.name = "space",
                    .texts = {fmt::format("\"{}\"", colour::name(space_of(content)))},
                    .bare = true}},
                  recipe);
  std::erase_if(own, [&](const request::Setting& setting) {
    return (setting.name == "passes" && !content.passes) ||
           (setting.name == "spectral" && !content.spectral_nm);
  });
  return own;
}

void write_usda(const Job& job) {
  const auto& output = job.output;
  const auto preview = texture_for(output, colour::WorkingSpace::linear_rec709, job.outputs);
  const auto wide = texture_for(output, colour::WorkingSpace::acescg, job.outputs);
  const auto& texture = wide != job.outputs.end() ? *wide : *preview;
  const auto space = space_of(texture.content);
  const auto view = view_of(job.options.view, job.moon.sky);
  const auto sight = usd_moment(job.moon, view, space);
  const double height_over_width =
      static_cast<double>(view.camera.height) / static_cast<double>(view.camera.width);
  texture::write_usda(
      output.path, texture.path.filename().string(), colour::interop_id(space),
      preview->path.filename().string(),
      texture::usd_observer({&sight, 1}, height_over_width, uses::luminance_of_channels(space)));
}

/// Computes the lit Moon that the options describe, as their observer sees it.
uses::LitMoon lit_moon(const Options& options, const uses::MoonRequest& request) {
  const texture::ImagesAhead images;
  const auto sky = eclipsed_sky(options.moon, options.view.observer);
  const auto seen = view_of(options.view, sky);
  auto moon = [&] {
    ProgressBar bar("light");
    return uses::lit_moon(request, sky, bar.progress());
  }();
  moon.observer = seen.observer;
  moon.sightline = seen.sightline;
  return moon;
}

/// Bakes and writes all outputs, and records in each the recipe that makes it.
Report make(const Verb& verb, const Options& options, const std::vector<Output>& outputs) {
  const auto start = std::chrono::steady_clock::now();
  const auto request = moon_request(options.moon);
  const auto moon = lit_moon(options, request);
  const auto& light = *moon.light;
  const auto recipe = recipe_made(request::recipe_of(verb.parameters), moon);
  Report made{{}, {}, 0, light.error_found, light.plan};
  for (const auto& output : outputs) {
    made.files.push_back(output.path.string());
    ProgressBar bar("bake");
    made.recipe = text_of(recipe_for(output.content, recipe));
    const auto baked = uses::baked(
        moon, output.content, {.progress = bar.progress(), .recipe = [&](const auto&, const auto&) {
                                 return made.recipe;
                               }});
    output.format.write({options, outputs, output, moon, baked});
  }
  made.seconds = seconds_since(start);
  return made;
}

/// Output that stores the texture for these options in the cache. Its file name is a fingerprint of all inputs.
Output place_in_cache(const Verb& verb, const Options& options) {
  const auto depends_on = fmt::format("{}\n{}\n{}", uses::version(), recipe_of(verb),
                                      map_contents(moon_request(options.moon)));
  auto content = options.texture;
  content.passes = false;
  content.spectral_nm.reset();
  return {std::filesystem::path(options.cache) /
              fmt::format("{:016x}.tx", files::fingerprint(depends_on)),
          content, formats[1]};
}

/// Whether a texture exists in the cache, is complete, and does not belong to another user.
bool is_kept(const std::filesystem::path& texture) {
  return files::is_users_own(texture) && texture::is_sealed(texture);
}

/// Prints the path of the cached texture for these options, after baking it if it is missing. If several processes need
/// the same texture, the first one bakes it and the others wait. The Moon's map is read before the texture's file is
/// locked, because reading the map may bake another texture in the same folder.
void run_with_cache(const Verb& verb, const Options& options) {
  require_sound(options.texture);
  files::make_private_folder(options.cache);
  std::optional<double>
      limit_gb;  // set for the usual cache only, as scenes may rely on textures in other folders
  if (files::is_usual_cache(options.cache)) limit_gb = cache_limit_gb();
  const auto output = place_in_cache(verb, options);
  if (!is_kept(output.path)) {
    const auto lock = files::lock_file(output.path, [&] {
      fmt::print(stderr, "coppermoon: waiting for another process, which bakes {}\n",
                 output.path.string());
    });
    if (!is_kept(output.path)) {
      std::filesystem::remove(output.path);  // so that writing does not follow a link
      make(verb, options, {output});
    }
  }
  files::mark_as_used(output.path);
  if (limit_gb) files::remove_oldest(options.cache, *limit_gb * 1e9, a_day_ago());
  fmt::print("{}\n", output.path.string());
}

void run(const Verb& verb, const Options& options) {
  if (options.outputs.empty() == options.cache.empty())
    throw WrongUsage(options.cache.empty() ? "--output: missing"
                                           : "--output and --cache: allowed one of the two");
  if (!options.cache.empty()) return run_with_cache(verb, options);
  std::vector<Output> outputs;
  for (const auto& file : options.outputs) outputs.push_back(output_at(file, options.texture));
  add_textures_of_usd(options, outputs);
  require_sound(options, outputs);
  for (const auto& output : outputs)
    if (!output.developed() && !output.ends_in(".usda") && !options.texture.space)
      say_space_of(output.path, space_of(output.content), other_spaces);
  report(make(verb, options, outputs), options.json);
}

}  // namespace
}  // namespace of_bake

void add_bake(Program& program) {
  using namespace of_bake;
  auto& verb = add_verb(program, "bake",
                        "bakes the lit texture of the Moon: plate carrée, scene-linear, cd/m²");
  const auto options = std::make_shared<Options>();
  options->develop.bits = 16;
  add_moon_options(verb, options->moon);
  add_flag(
      verb, "-o,--output", options->outputs,
      "texture: " + files::in_words(formats) + ". May be given again: one simulation serves all")
      .writes_file(formats);
  add_flag(
      verb, "--cache", options->cache,
      "folder of textures: the texture is baked into it as .tx, unless it is there already, and "
      "its path is printed")
      .writes_folder()
      .excludes("shard")  // --shard, --keep and --add change what is traced and written
      .excludes("keep")
      .excludes("add");
  add_described(verb, options->view, uses::describe_observer);
  add_described(verb, options->texture);
  add_described(verb, options->moon.request.response, uses::describe_response);
  add_described(verb, options->develop);
  for (auto& parameter : verb.parameters)
    if (parameter.affects == request::Affects::picture)
      parameter.only_with({{"output", {".png", ".glb", ".usdz", ".stellarium"}}});
  verb.parameters.find("type")->only_with({{"output", {".exr", ".tx", ".usda"}}, {"cache"}});
  add_json_switch(verb, options->json, {result::fields_of<Report>}).not_beside({{"cache"}});
  on_run(verb, [&verb, options] { run(verb, *options); });
}

}  // namespace coppermoon::verbs
