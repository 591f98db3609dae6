// SPDX-License-Identifier: MIT
#include "povray_scenes/mitsuba.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "files/own_file.h"
#include "files/whole_file.h"
#include "povray_scenes/scene_text.h"
#include "texture/sphere_mesh.h"

namespace coppermoon::povray_scenes {
namespace {

std::string numbers(const glm::dvec3& v) {
  return fmt::format("{:.9g}, {:.9g}, {:.9g}", v.x, v.y, v.z);
}

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) safe += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  return safe;
}

}  // namespace

std::string to_mitsuba(const MoonScene& scene) {
  require_renderable(scene);
  const auto& camera = scene.camera;
  std::string lights;
  for (const auto& [centre, radius, luminance] : light_spheres(scene))
    lights += fmt::format(R"(  <shape type="sphere">
    <point name="center" value="{}"/>
    <float name="radius" value="{:.9g}"/>
    <emitter type="area"><rgb name="radiance" value="{:.6g}, {:.6g}, {:.6g}"/></emitter>
  </shape>
)",
                          numbers(centre), radius, luminance[0], luminance[1], luminance[2]);
  const double away = glm::length(camera.position);
  return fmt::format(
      R"(<?xml version="1.0" encoding="utf-8"?>
<!-- The eclipsed Moon. In this folder: mitsuba -m scalar_rgb -o frame.exr eclipse.xml
     Emission only: the frame has the texture's own values, scene-linear [cd/m2].
     The axes are the Moon-fixed X (longitude 0), Y (90 east), Z (north). -->
<scene version="3.0.0">
  <integrator type="path"><integer name="max_depth" value="1"/></integrator>
  <sensor type="perspective">
    <string name="fov_axis" value="x"/>
    <float name="fov" value="{field:.9g}"/>
    <float name="near_clip" value="{near:.6g}"/>
    <float name="far_clip" value="{far:.6g}"/>
    <transform name="to_world">
      <lookat origin="{origin}" target="{target}" up="{up}"/>
    </transform>
    <sampler type="stratified"><integer name="sample_count" value="64"/></sampler>
    <film type="hdrfilm">
      <integer name="width" value="{width}"/>
      <integer name="height" value="{height}"/>
      <string name="pixel_format" value="rgb"/>
      <string name="component_format" value="float32"/>
      <rfilter type="box"/>
    </film>
  </sensor>
  <shape type="obj">
    <string name="filename" value="{mesh}"/>
    <emitter type="area">
      <texture type="bitmap" name="radiance">
        <string name="filename" value="{texture}"/>
        <boolean name="raw" value="true"/>
      </texture>
    </emitter>
  </shape>
{lights}</scene>
)",
      fmt::arg("field", in_degrees(camera.horizontal_field)), fmt::arg("near", away / 1e3),
      fmt::arg("far", away * 10), fmt::arg("origin", numbers(camera.position)),
      fmt::arg("target", numbers(middle(camera))),
      fmt::arg("up", numbers(glm::normalize(camera.up))), fmt::arg("width", camera.width),
      fmt::arg("height", camera.height), fmt::arg("mesh", mesh_file),
      fmt::arg("texture", escaped(scene.texture)), fmt::arg("lights", lights));
}

std::string mitsuba_mesh(const MoonScene& scene) {
  require_renderable(scene);
  const auto flattened = flattened_by_air(scene.camera);
  const auto mesh = texture::sphere_mesh();
  std::string text = "# The Moon in the Moon-fixed axes X (longitude 0), Y (90 east), Z (north)\n";
  for (const auto& p : mesh.points) {
    const auto v = flattened * glm::dvec3(p.z, p.x, p.y);
    text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", v.x, v.y, v.z);
  }
  for (const auto& st : mesh.st) text += fmt::format("vt {:.9g} {:.9g}\n", st.x, st.y);
  for (const auto& [a, b, c] : mesh.triangles)
    text += fmt::format("f {0}/{0} {1}/{1} {2}/{2}\n", a + 1, b + 1, c + 1);
  return text;
}

void require_mitsuba_place(const std::filesystem::path& folder) {
  for (const char* file : {mitsuba_file, mesh_file}) files::require_stamped(folder / file);
}

void write_mitsuba_scene(const std::filesystem::path& folder, const MoonScene& scene) {
  const auto text = to_mitsuba(scene), mesh = mitsuba_mesh(scene);
  require_folder(folder);
  files::write_whole(folder / mesh_file, files::stamped(mesh, "#"));
  files::write_whole(folder / mitsuba_file, files::stamped(text, "<!--", " -->"));
}

}  // namespace coppermoon::povray_scenes
