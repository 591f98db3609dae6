// SPDX-License-Identifier: MIT
#include "uses/shader/eclipse_shader.h"

#include <fmt/format.h>

#include "algebra/error.h"
#include "almanac/calendar.h"
#include "eclipse/shadow_axis.h"
#include "files/own_file.h"
#include "files/whole_file.h"
#include "texture/write_image.h"
#include "uses/light/header.h"
#include "uses/shader/shader_languages.h"

namespace coppermoon::uses {
namespace {

namespace fs = std::filesystem;

constexpr const char* strip_file = "eclipse.exr";

nlohmann::ordered_json facts_of(const EclipseShader& shader, const ShaderHead& head) {
  const auto& eclipse = shader.eclipse;
  nlohmann::ordered_json contacts;
  for (const auto& [name, when] : eclipse::contacts_of(eclipse))
    contacts[name] = std::round(almanac::seconds_between(eclipse.greatest, when));
  return {{"title", head.title},
          {"greatest", head.greatest},
          {"contacts_s", contacts},
          {"half_s", shader.motion.half_s},
          {"strip", head.strip},
          {"columns", shader.strip.roots.width},
          {"rows", shader.strip.roots.height},
          {"sectors", shader.strip.sectors},
          {"stretches", shader.strip.stretches},
          {"ends_km", shader.strip.ends_km},
          {"middle_km", shader.strip.middle_km()},
          {"error", shader.strip.error},
          {"colour_space", head.colour_space},
          {"version", version()},
          {"steps", json_of(shader.formula)}};
}

ShaderHead head_of(const EclipseShader& shader, const ShaderRequest& request,
                   const std::string& strip) {
  const auto held =
      shader.moment ? fmt::format(", held at {}", almanac::utc_text(*shader.moment)) : "";
  return {title(shader.eclipse) + held, almanac::utc_text(shader.eclipse.greatest),
          std::string(colour::name(request.space)), strip,
          -algebra::in_radians(
              eclipse::shadow_axis(almanac::sky_at(shader.eclipse.greatest)).sun_declination)};
}

texture::Attributes header_of(const ShaderHead& head, const std::string& recipe) {
  texture::Attributes header{
      {"colorInteropID", "data"},
      {"comments",
       fmt::format("square roots of light on the Moon over full sunlight, no unit; red, green "
                   "and blue of {}; read by the shaders beside it",
                   head.colour_space)},
      {"coppermoon:light_space", head.colour_space},
      {"coppermoon:greatest", head.greatest},
      {"coppermoon:version", std::string(version())},
  };
  if (!recipe.empty()) header["coppermoon:recipe"] = recipe;
  return header;
}

std::string scene_of(const EclipseShader& shader, const ShaderHead& head) {
  const auto contacts = eclipse::contacts_of(shader.eclipse);
  const auto seconds = [&](const almanac::Instant& when) {
    return almanac::seconds_between(shader.eclipse.greatest, when);
  };
  const auto film = fmt::format("+KFF24 +KI{:.0f} +KF{:.0f} ", seconds(contacts.front().second),
                                seconds(contacts.back().second));
  return fmt::format(
      R"(// SPDX-License-Identifier: MIT
// {}, seen from the Earth's centre, made by coppermoon for POV-Ray 3.7.
//
//   povray eclipse.pov {}+W480 +H480 +FE +A0.0 +AM2 +R2 -J
//
// renders {} in cd/m2:
// develop {} with `coppermoon develop`.
#version 3.7;
global_settings {{ assumed_gamma 1.0 }}
#include "eclipse.inc"

Eclipse_At(clock)
camera {{
  location Eclipse_Distance*Eclipse_Earth
  direction z
  right x*image_width/image_height
  up y
  sky Eclipse_North
  angle 0.8
  look_at 0
}}

// A Moon of one grey. Yours: pigment {{ image_map {{ exr "moon.exr" map_type 1 interpolate 2 }} rotate y*180 }}
// of `coppermoon bake {} --unshadowed -o moon.exr`, in cd/m2, or a map of your own times its sunlight.
Eclipse_Moon(pigment {{ rgb 4000 }})
)",
      head.title, shader.moment ? "" : film,
      shader.moment ? "a frame"
                    : "24 frames, from the first contact to the last: clock is seconds from "
                      "greatest eclipse. The frames are",
      shader.moment ? "it" : "them", head.greatest.substr(0, head.greatest.find('T')));
}

}  // namespace

EclipseShader eclipse_shader(const eclipse::Eclipse& eclipse, const ShaderRequest& request,
                             const algebra::Progress& progress,
                             const std::optional<almanac::Instant>& moment) {
  EclipseShader shader;
  shader.moment = moment;
  shader.eclipse = eclipse;
  shader.eclipse.greatest = almanac::instant_from_utc(almanac::utc_text(eclipse.greatest));
  shader.motion = moment ? held_at(*moment) : shadow_motion(shader.eclipse);
  const double radius_km = algebra::in_kilometres(almanac::lunar_radius);
  // depths from the Moon's near side to its centre, because sunlight never reaches the far half
  const double from = shader.motion.nearest - (moment ? 0.5 : 1),
               to = shader.motion.farthest - (moment ? 0.5 : 0);
  shader.strip = light_strip(request, almanac::sky_at(moment.value_or(shader.eclipse.greatest)),
                             from * radius_km, to * radius_km, progress);
  shader.formula = shadow_formula(shader.motion, shader.strip);
  return shader;
}

void write_strip(const fs::path& file, const EclipseShader& shader, const ShaderRequest& request,
                 const std::string& recipe) {
  auto header = header_of(head_of(shader, request, ""), recipe);
  header["coppermoon:relative_error"] = static_cast<float>(shader.strip.error);
  texture::write_exr(file, shader.strip.roots, header);
}

std::vector<std::string> write_shader(const fs::path& folder, const EclipseShader& shader,
                                      const ShaderRequest& request, const std::string& recipe) {
  const auto head = head_of(shader, request, strip_file);
  const std::vector<std::pair<std::string, std::string>> texts{
      {"eclipse.osl", files::stamped(osl_of(shader.formula, head), "//")},
      {"eclipse.glsl", files::stamped(glsl_of(shader.formula, head), "//")},
      {"eclipse.mtlx", files::stamped(materialx_of(shader.formula, head), "<!--", " -->")},
      {"eclipse.inc", files::stamped(povray_of(shader.motion, shader.strip, head), "//")},
      {"eclipse.pov", files::stamped(scene_of(shader, head), "//")}};
  for (const auto& [name, text] : texts) files::require_stamped(folder / name);
  for (const auto* name : {strip_file, "eclipse.json"}) files::require_no_link(folder / name);
  fs::create_directories(folder);
  std::vector<std::string> written{strip_file};
  write_strip(folder / strip_file, shader, request, recipe);
  for (const auto& [name, text] : texts) {
    files::write_whole(folder / name, text);
    written.push_back(name);
  }
  files::write_whole(folder / "eclipse.json", facts_of(shader, head).dump(1) + "\n");
  written.push_back("eclipse.json");
  return written;
}

}  // namespace coppermoon::uses
