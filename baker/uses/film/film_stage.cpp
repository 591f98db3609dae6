// SPDX-License-Identifier: MIT
#include "uses/film/film_stage.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <glm/geometric.hpp>

#include "algebra/error.h"
#include "almanac/observer.h"
#include "files/whole_file.h"
#include "povray_scenes/sequence.h"
#include "texture/resize.h"
#include "uses/dome/dome.h"
#include "uses/film/film_frames.h"
#include "uses/light/header.h"
#include "uses/picture/lit_scene.h"
#include "uses/shader/eclipse_shader.h"
#include "uses/shader/shader_languages.h"

namespace coppermoon::uses {
namespace {

namespace fs = std::filesystem;

using Lux = std::array<double, 3>;

constexpr std::size_t rows = 180;  ///< rows of the textures used to measure illuminance

Film in_sunlight(Film film) {
  film.moon.unshadowed = true;
  film.light = std::make_shared<const Moonlight>();
  return film;
}

/// The film with small textures, from which illuminance can be measured quickly.
Film in_little(Film film) {
  film.albedo = std::make_shared<const algebra::Grid<float>>(texture::resized(*film.albedo, rows));
  film.ground = ground_of(film.moon, *film.albedo);
  film.moon.texture_width = 2 * rows;
  film.content.passes = false;
  film.content.spectral_nm.reset();
  return film;
}

struct StageFrame {
  texture::UsdMoment moment;
  double seconds = 0;  ///< time since greatest eclipse
  Lux sunlit{};        ///< illuminance without the Earth's shadow
};

std::vector<StageFrame> frames_of(const Film& film, const std::vector<std::size_t>& numbers,
                                  const almanac::Instant& greatest) {
  const auto little = in_little(film), sunlit = in_sunlight(little);
  std::vector<StageFrame> frames(numbers.size());
  const auto space = space_of(film.content);
  tbb::parallel_for(std::size_t{0}, numbers.size(), [&](std::size_t i) {
    const auto sky = film.sky(numbers[i]);
    const auto view = view_of(film, sky);
    frames[i] = {usd_moment(moon_of(little, sky, view), view, space),
                 almanac::seconds_between(greatest, sky.when),
                 illuminance_seen(moon_of(sunlit, sky, view), space)};
    frames[i].moment.time_code = static_cast<double>(numbers[i]);
  });
  return frames;
}

/// Weight of the last frame's sunlit Moon in frame i. The rest of the weight belongs to the first frame's sunlit Moon.
double share_of(const std::vector<StageFrame>& frames, std::size_t i) {
  const double first = frames.front().seconds, last = frames.back().seconds;
  return (frames[i].seconds - first) / (last - first);
}

/// USD text for an attribute, whose first value is the default, with one time sample per frame.
template <class Value>
std::string samples(const char* declared, const std::vector<StageFrame>& frames,
                    const Value& value) {
  auto text = fmt::format("{0} = {1}\n                {0}.timeSamples = {{\n", declared, value(0));
  for (std::size_t i = 0; i < frames.size(); ++i)
    text += fmt::format("                    {:g}: {},\n", frames[i].moment.time_code, value(i));
  return text + "                }";
}

/// File names of the images that are made for the stage.
struct Images {
  std::string first, last, strip;

  explicit Images(const fs::path& stage, const Film& film) {
    const auto stem = stage.stem().string();
    const auto space = colour::name(space_of(film.content));
    first = fmt::format("{}_sunlit_first_{}.exr", stem, space);
    last = fmt::format("{}_sunlit_last_{}.exr", stem, space);
    strip = stem + "_shadow.exr";
  }
};

constexpr const char* nodes_of_film = R"(            def Shader "Scaled"
            {{
                uniform token info:id = "ND_multiply_color3"
                color3f inputs:in1.connect = </Moon/Looks/Moonlight/Lit.outputs:out>
                {factors}
                color3f outputs:out
            }}

            def Shader "Lit"
            {{
                uniform token info:id = "ND_multiply_color3"
                color3f inputs:in1.connect = </Moon/Looks/Moonlight/Sunlit.outputs:out>
                color3f inputs:in2.connect = </Moon/Looks/Moonlight/Shadow.outputs:light>
                color3f outputs:out
            }}

            def Shader "Sunlit"
            {{
                uniform token info:id = "ND_mix_color3"
                color3f inputs:bg.connect = </Moon/Looks/Moonlight/First.outputs:out>
                color3f inputs:fg.connect = </Moon/Looks/Moonlight/Last.outputs:out>
                {shares}
                color3f outputs:out
            }}

{images}            def NodeGraph "Shadow"
            {{
                {times}
                color3f outputs:light.connect = <{light}>

{nodes}            }}
)";

std::string looks_of(const Film& film, const std::vector<StageFrame>& frames, const Images& images,
                     const EclipseShader& shader) {
  const auto space = colour::interop_id(space_of(film.content));
  const auto nodes =
      usd_of(shader.formula, "/Moon/Looks/Moonlight/Shadow", texture::usd_asset(images.strip));
  const auto number = [&](std::size_t i) {
    return static_cast<std::size_t>(frames[i].moment.time_code);
  };
  const auto factor = [&](std::size_t i, std::size_t k) {
    const double mixed =
        std::lerp(frames.front().sunlit[k], frames.back().sunlit[k], share_of(frames, i));
    return mixed > 0 ? frames[i].sunlit[k] / mixed : 1;
  };
  const auto image = [&](const char* name, const std::string& file) {
    return texture::usd_image(name, texture::usd_asset(file), space) + "\n";
  };
  const auto textures = samples("asset inputs:file", frames, [&](std::size_t i) {
    return texture::usd_asset(film.texture(number(i)).filename().string());
  });
  const auto film_nodes = fmt::format(
      fmt::runtime(nodes_of_film),
      fmt::arg("factors", samples("color3f inputs:in2", frames,
                                  [&](std::size_t i) {
                                    return fmt::format("({:.6g}, {:.6g}, {:.6g})", factor(i, 0),
                                                       factor(i, 1), factor(i, 2));
                                  })),
      fmt::arg("shares",
               samples("float inputs:mix", frames,
                       [&](std::size_t i) { return fmt::format("{:.6g}", share_of(frames, i)); })),
      fmt::arg("times",
               samples("float inputs:time", frames,
                       [&](std::size_t i) { return fmt::format("{:.3f}", frames[i].seconds); })),
      fmt::arg("images", image("First", images.first) + image("Last", images.last)),
      fmt::arg("light", nodes.output), fmt::arg("nodes", nodes.prims));
  return texture::usd_looks(
      fmt::format("                asset inputs:file (\n                    colorSpace = \"{}\"\n"
                  "                )\n                {}\n"
                  "                token inputs:sourceColorSpace = \"raw\"\n",
                  space, textures),
      "/Moon/Looks/Moonlight/Scaled.outputs:out", film_nodes);
}

/// Header of the USD layer, with the time codes of the contacts that happen during the film.
std::string layer_of(const Film& film, const std::vector<StageFrame>& frames) {
  std::string contacts;
  const double first = frames.front().seconds, last = frames.back().seconds;
  for (const auto& [name, when] : eclipse::contacts_of(film.moments.eclipse)) {
    const double seconds = almanac::seconds_between(film.moments.eclipse.greatest, when);
    if (seconds < first - 1 || seconds > last + 1) continue;
    contacts +=
        fmt::format("                double {} = {:.4f}\n", name,
                    std::lerp(frames.front().moment.time_code, frames.back().moment.time_code,
                              (seconds - first) / (last - first)));
  }
  return fmt::format(R"(#usda 1.0
(
    defaultPrim = "Moon"
    metersPerUnit = 1
    upAxis = "Y"
    startTimeCode = {:g}
    endTimeCode = {:g}
    timeCodesPerSecond = {}
    framesPerSecond = {}
    customLayerData = {{
        dictionary coppermoon = {{
            float radius_m = {}
            string greatest = "{}"
            dictionary contacts = {{
{}            }}
        }}
    }}
)
)",
                     frames.front().moment.time_code, frames.back().moment.time_code,
                     film.fps.value(), film.fps.value(), algebra::in_metres(almanac::lunar_radius),
                     almanac::utc_text(film.moments.eclipse.greatest), contacts);
}

/// Writes an image of the sky for each frame beside the stage. Writes nothing if the film has no observer.
std::vector<texture::UsdSky> write_skies(const fs::path& stage, const Film& film,
                                         const std::vector<std::size_t>& numbers) {
  std::vector<texture::UsdSky> skies(film.view.observer ? numbers.size() : 0);
  const auto little = in_little(film);
  const auto stem =
      fmt::format("{}_sky_{}", stage.stem().string(), colour::name(space_of(film.content)));
  tbb::parallel_for(std::size_t{0}, skies.size(), [&](std::size_t i) {
    const auto sky = film.sky(numbers[i]);
    const auto view = view_of(film, sky);
    const auto path = stage.parent_path() /
                      povray_scenes::numbered_file(stem, numbers[i], film.moments.last_frame());
    write_sky(path, moon_of(little, sky, view), film.view,
              {.width = 256, .content = {.space = space_of(film.content)}});
    const auto seen = almanac::view_from(*film.view.observer, sky);
    const auto level = seen.north - glm::dot(seen.north, seen.zenith) * seen.zenith;
    skies[i] = {static_cast<double>(numbers[i]), path.filename().string(),
                sky.selenographic_from_gcrs * seen.zenith,
                sky.selenographic_from_gcrs * glm::normalize(level)};
  });
  return skies;
}

void write_sunlit(const fs::path& path, const Film& sunlit, std::size_t frame) {
  const auto sky = sunlit.sky(frame);
  const auto moon = moon_of(sunlit, sky, view_of(sunlit, sky));
  const auto texture = baked(moon, sunlit.content);
  texture::write_exr(path, texture.parts, texture.attributes, {type_of(sunlit.content)});
}

}  // namespace

void require_stage(const fs::path& path, const Film& film) {
  const auto refuse = [&](const char* why) {
    throw algebra::Error(fmt::format("{}: a stage is {}", path.string(), why));
  };
  texture::require_usd_name(path.filename().string());
  if (!film.products.textures) refuse("made of textures, allowed where those are made");
  if (fs::weakly_canonical(fs::absolute(path)).parent_path() !=
      fs::weakly_canonical(fs::absolute(film.folder) / "stage").parent_path())
    refuse("allowed in the folder of its textures alone");
  if (film.moments.frames.size() < 2) refuse("allowed with two frames or more");
  if (space_of(film.content) == colour::WorkingSpace::ciexyz_d65)
    refuse("allowed in lin_rec709 or acescg, which USD's cameras know");
}

void write_stage(const fs::path& path, const Film& asked, const std::vector<std::size_t>& numbers) {
  require_stage(path, asked);
  const auto film = with_ground(asked);
  if (numbers.size() < 2)
    throw algebra::Error(
        fmt::format("{}: a stage is allowed with two frames or more", path.string()));
  const auto space = space_of(film.content);
  const auto half_way = view_of(film, film.sky(numbers[numbers.size() / 2]));
  const ShaderRequest request{film.moon.light, space, film.moon.response, half_way.sightline};
  const auto shader = eclipse_shader(film.moments.eclipse, request);
  const auto frames = frames_of(film, numbers, shader.eclipse.greatest);
  const Images images(path, film);
  write_strip(path.parent_path() / images.strip, shader, request, "");
  auto sunlit = in_sunlight(film);
  sunlit.content.passes = false;
  sunlit.content.spectral_nm.reset();
  write_sunlit(path.parent_path() / images.first, sunlit, numbers.front());
  write_sunlit(path.parent_path() / images.last, sunlit, numbers.back());
  std::vector<texture::UsdMoment> moments;
  for (const auto& frame : frames) moments.push_back(frame.moment);
  const auto skies = write_skies(path, film, numbers);
  const auto camera = view_of(film, film.sky(numbers.front())).camera;
  const double height_over_width =
      static_cast<double>(camera.height) / static_cast<double>(camera.width);
  files::write_whole(
      path,
      fmt::format("{}\ndef Xform \"Moon\" (\n    kind = \"component\"\n    prepend apiSchemas = "
                  "[\"ColorSpaceAPI\"]\n)\n{{\n    uniform token colorSpace:name = \"{}\"\n\n"
                  "{}\n{}\n{}{}{}}}\n",
                  layer_of(film, frames), colour::interop_id(space), texture::usd_mesh(),
                  looks_of(film, frames, images, shader),
                  texture::usd_observer(moments, height_over_width, luminance_of_channels(space)),
                  skies.empty() ? "" : "\n", skies.empty() ? "" : texture::usd_sky(skies)));
}

}  // namespace coppermoon::uses
