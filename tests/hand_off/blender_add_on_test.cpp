// SPDX-License-Identifier: MIT
// The add-on in Blender itself: what it adds is what the program makes, as bright as the disc is.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "colour/exposure.h"
#include "hand_off/agreement.h"
#include "hand_off/blender.h"
#include "hand_off/reference_projection.h"
#include "support/testing.h"
#include "uses/picture/view.h"

namespace coppermoon::hand_off::blender_add_on_test {

constexpr auto up = povray_scenes::Up::zenith;

/// What the tests say of an eclipse, behind its date: quick to bake.
const std::string quick = "texture_width=256, quality='draft'";

class BlenderAddOn : public BlenderTest {
 protected:
  /// A call of the operator that adds the eclipse of a look.
  std::string add_eclipse() const {
    return fmt::format(
        "bpy.ops.coppermoon.add_eclipse(date='{}', place='{}', up='{}', field={:.9f}, "
        "texture_width=1024)\n",
        look.instant, at(look.observer), word(look.up), in_radians(algebra::degrees(field_deg)));
  }

  /// What a program in Blender prints in a line that begins with a word.
  static std::string line(const Outcome& outcome, const std::string& word) {
    std::istringstream lines(outcome.out);
    for (std::string one; std::getline(lines, one);)
      if (one.starts_with(word + " ")) return one.substr(word.size() + 1);
    ADD_FAILURE() << word << ": not in " << outcome.out << outcome.err;
    return "nothing";
  }

  static double number(const Outcome& outcome, const std::string& word) {
    const auto text = line(outcome, word);
    return text == "nothing" ? std::nan("") : std::stod(text);
  }

  std::vector<std::string> textures_kept() const {
    std::vector<std::string> names;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(here("cache/coppermoon"), none))
      if (entry.path().extension() == ".tx") names.push_back(entry.path().string());
    return names;
  }

  Look look = from_the_south(up);
};

/// Solid angle of the picture's pixels, near its middle [sr].
double pixel_sr() {
  const double across = 2 * std::tan(in_radians(algebra::degrees(field_deg)) / 2) / side;
  return across * across;
}

/// The light of a frame on what faces the Moon [lux], by channel.
Rgb lux(const texture::Image& frame) {
  Rgb sum{0, 0, 0};
  for (std::size_t i = 0; i < frame.values.size(); ++i)
    sum[static_cast<int>(i % 3)] += frame.values[i];
  return pixel_sr() * sum;
}

const std::string print_state =
    "moon = bpy.data.objects['Moon']\n"
    "node = next(n for n in moon.active_material.node_tree.nodes if n.type == 'TEX_IMAGE')\n"
    "print('image', node.image.filepath if node.image else 'none')\n"
    "print('lux', bpy.data.lights['Moonlight'].energy)\n"
    "print('danjon', moon.coppermoon.danjon)\n";

TEST_F(BlenderAddOn, IsInstalledFromItsZip) {
  std::filesystem::remove_all(here("scripts/addons/coppermoon"));
  const auto outcome = blender(
      {"blender", "-b", "--python-exit-code", "3", "--python-expr",
       "import bpy\nbpy.ops.preferences.addon_install(filepath=r'" COPPERMOON_ADD_ON "')\n"
       "bpy.ops.preferences.addon_enable(module='coppermoon')\n"
       "print('program', bpy.context.preferences.addons['coppermoon'].preferences.program == '')\n"
       "bpy.ops.preferences.addon_disable(module='coppermoon')\n"
       "print('gone', not hasattr(bpy.types.Object, 'coppermoon'))"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(line(outcome, "program"), "True");
  EXPECT_EQ(line(outcome, "gone"), "True");
}

TEST_F(BlenderAddOn, AddsTheMoonThatItsObserverSees) {
  const auto frame = luminances(rendered(add_eclipse() + square()));
  ASSERT_EQ(textures_kept().size(), 1U);
  const auto reference =
      luminances(reference_projection(texture::read_image(textures_kept().front()), look.camera()));
  EXPECT_LT(part_that_differs(frame, reference, radius_px(look.camera()), 0.01), 0.01);
  EXPECT_WITHIN_RELATIVE(total(frame), total(reference), 5e-4,
                         "rays in the pixels of the limb: 1.5e-4");
  EXPECT_LT(glm::length(shift(frame, reference)), 0.1);
}

TEST_F(BlenderAddOn, HasATextureThatItsRecipeBakesAgain) {
  expect_done(python(
      fmt::format("bpy.ops.coppermoon.add_eclipse(date='{}', {})\n", look.instant, quick), {}));
  ASSERT_EQ(textures_kept().size(), 1U);
  const auto texture = textures_kept().front();
  expect_done(coppermoon(words_of("bake {} -o again.tx", texture)));
  EXPECT_TRUE(texture::read_image(here("again.tx")).values == texture::read_image(texture).values);
}

TEST_F(BlenderAddOn, LightsAWhiteWallAsTheDiscDoes) {
  const auto white_wall =
      add_eclipse() +
      "import mathutils\n"
      "scene = bpy.context.scene\n"
      "observer = scene.camera\n"
      "bpy.ops.mesh.primitive_plane_add(size=2)\n"
      "wall = bpy.context.object\n"
      "wall.rotation_mode = 'QUATERNION'\n"
      "turned = observer.rotation_quaternion @ mathutils.Quaternion((0, 1, 0), 3.141592653589793)\n"
      "wall.rotation_quaternion = turned\n"  // its +Z towards the Moon
      "wall.location = observer.location\n"
      "white = bpy.data.materials.new('White')\n"
      "white.use_nodes = True\n"
      "nodes = white.node_tree.nodes\n"
      "nodes.clear()\n"
      "diffuse = nodes.new('ShaderNodeBsdfDiffuse')\n"
      "diffuse.inputs['Color'].default_value = (1, 1, 1, 1)\n"
      "ends = nodes.new('ShaderNodeOutputMaterial')\n"
      "white.node_tree.links.new(diffuse.outputs[0], ends.inputs[0])\n"
      "wall.data.materials.append(white)\n"
      "data = bpy.data.cameras.new('Near')\n"
      "data.type, data.ortho_scale = 'ORTHO', 1\n"
      "near = scene.camera = bpy.data.objects.new('Near', data)\n"
      "scene.collection.objects.link(near)\n"
      "near.rotation_mode = 'QUATERNION'\n"
      "near.rotation_quaternion = turned\n"
      "near.location = observer.location + turned @ mathutils.Vector((0, 0, 3))\n"
      "scene.render.resolution_x = scene.render.resolution_y = 16\n";
  const auto wall = rendered(white_wall);
  ASSERT_EQ(textures_kept().size(), 1U);
  const auto disc =
      lux(reference_projection(texture::read_image(textures_kept().front()), look.camera()));
  Rgb mean{0, 0, 0};
  for (std::size_t i = 0; i < wall.values.size(); ++i)
    mean[static_cast<int>(i % 3)] += wall.values[i] / (16. * 16.);
  for (int k = 0; k < 3; ++k)
    EXPECT_WITHIN_RELATIVE(std::numbers::pi * mean[k], disc[k], 0.003,
                           "the lamp's sum over a texture of 128 rows: 0.2 %");
  const auto dim =
      luminances(rendered(white_wall + "bpy.data.lights['Moonlight'].energy *= 1e-4\n"));
  const auto [least, most] = std::ranges::minmax(dim.values());
  EXPECT_WITHIN_RELATIVE(most, least, 1e-4,
                         "single precision; Cycles' default drops so dim a light at random");
}

/// Blender 5 works in a space that the file chooses; older ones in linear Rec.709 alone.
TEST_F(BlenderAddOn, HasALampOfTheSameLuminanceInEachWorkingSpace) {
  const auto outcome = python(
      "spaces = ['Linear Rec.709']\n"
      "if hasattr(bpy.data, 'colorspace'):\n"
      "    kept = bpy.data.colorspace.bl_rna.properties['working_space'].enum_items\n"
      "    spaces = [item.identifier for item in kept]\n"
      "for i, space in enumerate(spaces):\n"
      "    if i > 0:\n"
      "        bpy.ops.wm.set_working_color_space(working_space=space, convert_colors=False)\n"
      "        assert bpy.data.colorspace.working_space == space\n"
      "    " +
      add_eclipse() +
      "    lamp = bpy.context.scene.objects['Moonlight' + ('' if i == 0 else f'.{i:03}')].data\n"
      "    print(f'lux{i}', lamp.energy)\n"
      "    print(f'red{i}', lamp.color[0] / lamp.color[1])\n"
      "print('spaces', len(spaces))\n");
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  for (int i = 1; i < number(outcome, "spaces"); ++i) {
    EXPECT_WITHIN_RELATIVE(number(outcome, fmt::format("lux{}", i)), number(outcome, "lux0"), 1e-3,
                           "luminance is the same in all; four digits of its weights");
    EXPECT_GT(std::abs(number(outcome, fmt::format("red{}", i)) - number(outcome, "red0")), 1e-3)
        << "its channels are not";
  }
}

TEST_F(BlenderAddOn, KeysAWholeEclipseFromP1ToP4) {
  constexpr int frames = 12;
  const auto outcome = python(
      fmt::format("bpy.ops.coppermoon.add_eclipse(date='2018-07-27', film=True, frames={}, {}, "
                  "field={:.9f})\n",
                  frames, quick, in_radians(algebra::degrees(field_deg))) +
          square() +
          "print('range', scene.frame_start, scene.frame_end)\n"
          "print('marks', *[f'{m.name}={m.frame}' for m in scene.timeline_markers])\n"
          "for frame in range(1, 13):\n"
          "    scene.frame_set(frame)\n"
          "    print(f'lux{frame}', bpy.data.lights['Moonlight'].energy)\n"
          "scene.frame_set(1)\n"
          "scene.frame_step = 3\n",
      {"-o", here("frame.####").string(), "-a"});
  ASSERT_EQ(outcome.status, 0) << outcome.out;
  EXPECT_EQ(line(outcome, "range"), "1 12");
  // By the published contacts, 17:14:49, 18:24:27, 19:30:15, 21:13:12, 22:19:00 and 23:28:37, in
  // eleven steps of 34 minutes.
  EXPECT_EQ(line(outcome, "marks"), "P1=1 U1=3 U2=5 U3=8 U4=10 P4=12");
  for (const int frame : {1, 4, 7, 10}) {
    const double light =
        pixel_sr() *
        total(luminances(texture::read_image(here(fmt::format("frame.{:04}.exr", frame)))));
    EXPECT_WITHIN_RELATIVE(number(outcome, fmt::format("lux{}", frame)), light, 0.005,
                           "the lamp's sum of 128 rows 0.2 %, colours, 64 rays a pixel");
  }
  EXPECT_LT(number(outcome, "lux7"), 1e-3 * number(outcome, "lux1")) << "or all were alike";
}

TEST_F(BlenderAddOn, DrawsAFilmByAShaderAsByTextures) {
  const auto frames = [&](const char* by, const char* name) {
    const auto outcome = python(
        fmt::format(
            "bpy.ops.coppermoon.add_eclipse(date='2018-07-27', film=True, frames=5, begin='U1', "
            "end='U3', texture_width=2048, shader={}, field={:.9f})\n",
            by, in_radians(algebra::degrees(field_deg))) +
            square() +
            "scene.cycles.samples = 16\nscene.frame_step = 2\n"
            "print('images', len(bpy.data.images), len(bpy.data.node_groups))\n",
        {"-o", here(std::string(name) + ".####").string(), "-a"});
    EXPECT_EQ(outcome.status, 0) << outcome.out;
    std::vector<texture::Image> images;
    for (const int frame : {1, 3, 5})
      images.push_back(texture::read_image(here(fmt::format("{}.{:04}.exr", name, frame))));
    return images;
  };
  const auto shaded = frames("True", "shaded"), textured = frames("False", "textured");
  for (std::size_t f = 0; f < 3; ++f) {
    const auto ours = luminances(shaded[f]), theirs = luminances(textured[f]);
    double sum = 0, worst = 0;
    std::size_t seen = 0;
    for (std::size_t y = 1; y + 1 < side; ++y)
      for (std::size_t x = 1; x + 1 < side; ++x) {
        // within the limb, whose pixels other rays meet in each run
        const double here = theirs(y, x);
        const bool limb = std::min({theirs(y, x - 1), theirs(y, x + 1), theirs(y - 1, x),
                                    theirs(y + 1, x)}) < 0.5 * here;
        if (limb || here <= 0) continue;
        const double off = ours(y, x) / here - 1;
        worst = std::max(worst, std::abs(off));
        sum += off * off, ++seen;
      }
    EXPECT_GT(seen, 45000U);
    EXPECT_WITHIN(std::sqrt(sum / static_cast<double>(seen)), 0., 0.01,
                  "1 % of the shader's light, as stated");
    EXPECT_WITHIN(worst, 0., 0.02, "as stated, where sunlight begins");
  }
}

TEST_F(BlenderAddOn, BakesAgainWhenAValueChanges) {
  const auto first =
      python("bpy.ops.coppermoon.add_eclipse(date='2018-07-27', " + quick + ")\n" + print_state +
             "bpy.ops.wm.save_as_mainfile(filepath=r'" + here("eclipse.blend").string() +
             "')\nprint('saved', node.image.filepath)\n"
             "print('name', node.image.name)\n"
             "print('clip', bpy.context.scene.camera.data.clip_start)\n"
             "print('device', bpy.context.scene.cycles.device)\n");
  ASSERT_EQ(first.status, 0) << first.out;
  EXPECT_LT(std::filesystem::file_size(here("eclipse.blend")), 9e6) << "bytes of 46 000 faces";
  EXPECT_EQ(line(first, "name"), "Moon 2018-07-27 20:21:45");
  EXPECT_LT(number(first, "clip"), 0.2) << "lunar radii: what stands before the Moon is seen";
  EXPECT_EQ(line(first, "device"), "CPU") << "as the preferences are by default";
  std::filesystem::remove_all(here("cache/coppermoon"));
  const auto again =
      blender({"blender", "-b", "--factory-startup", "--python-exit-code", "3", "--addons",
               "coppermoon", here("eclipse.blend").string(), "--python-expr",
               "import bpy\nmoon = bpy.data.objects['Moon']\nvalues = moon.coppermoon\n"
               "image = next(n.image for n in moon.active_material.node_tree.nodes\n"
               "             if n.type == 'TEX_IMAGE')\n"
               "print('opened', image.filepath, image.size[0])\n"
               "values.by_danjon, values.danjon = True, 1\nbpy.ops.coppermoon.bake()\n" +
                   print_state});
  ASSERT_EQ(again.status, 0) << again.out;
  EXPECT_EQ(line(again, "opened"), line(first, "saved") + " 256") << "its cache is gone";
  EXPECT_TRUE(line(first, "saved").starts_with("//coppermoon/")) << "beside the .blend";
  EXPECT_NE(line(first, "saved"), line(again, "image"));
  EXPECT_TRUE(line(again, "image").starts_with("//coppermoon/")) << "beside the .blend";
  EXPECT_LT(number(again, "lux"), 0.5 * number(first, "lux")) << "a darker eclipse";
  EXPECT_GT(number(again, "lux"), 0);
}

/// From a film that begins when the Moon rises, at frame 1001, to one moment.
TEST_F(BlenderAddOn, KeepsWhatTheUserHasChanged) {
  const auto outcome = python(
      "import os, shutil\n"
      "bpy.ops.coppermoon.add_eclipse(date='2018-07-27', place='42.3,13.4', film=True, frames=9, "
      "start_frame=1001, " +
      quick +
      ")\n"
      "scene = bpy.context.scene\n"
      "lens = scene.camera.data\n"
      "print('range', scene.frame_start, scene.frame_end)\n"
      "print('marks', *[f'{m.name}={m.frame}' for m in scene.timeline_markers])\n"
      "bpy.ops.wm.save_as_mainfile(filepath=r'" +
      here("film.blend").string() +
      "')\n"
      "shutil.rmtree(os.path.join(os.environ['XDG_CACHE_HOME'], 'coppermoon'))\n" +
      square() +
      "scene.frame_set(1009)\n"
      "print('last', bpy.data.lights['Moonlight'].energy)\n"
      "scene.render.filepath = r'" +
      here("last.exr").string() +
      "'\n"
      "bpy.ops.render.render(write_still=True)\n" +
      print_state +
      "print('strip', bpy.data.images['eclipse.exr'].filepath)\n"
      "scene.frame_end, scene.render.fps, lens.lens = 1004, 30, 200\n"
      "values = moon.coppermoon\n"
      "values.film, values.contact, values.place = False, 'U4', ''\n"
      "bpy.ops.coppermoon.bake()\n"
      "exposure = scene.view_settings.exposure\n"
      "scene.frame_set(1003)\n"
      "print('exposure', scene.view_settings.exposure == exposure)\n"
      "print('kept', scene.frame_start, scene.frame_end, scene.render.fps, lens.lens)\n"
      "values.field *= 2\n"
      "bpy.ops.coppermoon.bake()\n"
      "print('degrees', lens.sensor_width / 2 / lens.lens * 2 * 57.29578)\n");
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_EQ(line(outcome, "range"), "1001 1009");
  // The Moon rises between 18:23 and 18:25 UTC, near U1; by the published contacts above, in eight
  // steps of 38 minutes.
  EXPECT_TRUE(line(outcome, "marks").ends_with("U2=1003 U3=1005 U4=1007 P4=1009"));
  EXPECT_TRUE(line(outcome, "image").starts_with("//coppermoon/")) << "beside the .blend";
  EXPECT_TRUE(line(outcome, "strip").starts_with("//coppermoon/2018-07-27_")) << "as well";
  EXPECT_WITHIN_RELATIVE(pixel_sr() * total(luminances(texture::read_image(here("last.exr")))),
                         number(outcome, "last"), 0.005, "as above");
  EXPECT_EQ(line(outcome, "exposure"), "True") << "without keys of the film";
  EXPECT_EQ(line(outcome, "kept"), "1001 1004 30 200.0");
  EXPECT_WITHIN_RELATIVE(number(outcome, "degrees"), 2 * field_deg, 1e-4, "tan of 0.6 degrees");
}

TEST_F(BlenderAddOn, RendersByTheDeviceOfTheUsersPreferences) {
  const auto outcome = python(
      "from types import SimpleNamespace\n"
      "from coppermoon import film\n"
      "def device(kind):\n"
      "    cycles = SimpleNamespace(preferences=SimpleNamespace(compute_device_type=kind))\n"
      "    user = SimpleNamespace(preferences=SimpleNamespace(addons={'cycles': cycles}))\n"
      "    film.bpy = SimpleNamespace(context=user)\n"
      "    return film.users_device()\n"
      "print('devices', device('OPTIX'), device('NONE'))\n");
  EXPECT_EQ(line(outcome, "devices"), "GPU CPU") << outcome.out << outcome.err;
}

TEST_F(BlenderAddOn, IsUndone) {
  const auto outcome = python(
      "bpy.ops.ed.undo_push(message='before')\n"
      "bpy.ops.coppermoon.add_eclipse('EXEC_DEFAULT', True, date='2018-07-27', " +
      quick + ")\n" + print_state +
      "bpy.ops.ed.undo()\n"
      "print('scenes', *[s.name for s in bpy.data.scenes])\n"
      "print('moons', [o.name for o in bpy.data.objects].count('Moon'))\n"
      "bpy.ops.ed.redo()\n"
      "print('again', bpy.context.scene.objects['Moon'].coppermoon.date)\n");
  ASSERT_EQ(outcome.status, 0) << outcome.out;
  EXPECT_NE(line(outcome, "image"), "none");
  EXPECT_EQ(line(outcome, "scenes"), "Scene");
  EXPECT_EQ(number(outcome, "moons"), 0);
  EXPECT_EQ(line(outcome, "again"), "2018-07-27");
}

TEST_F(BlenderAddOn, LeavesASceneOfTheUsersAsItIs) {
  const auto outcome = python(
      "scene = bpy.context.scene\n"
      "before = (scene.camera, scene.world, scene.render.engine, scene.view_settings.exposure)\n"
      "bpy.ops.coppermoon.add_eclipse(date='2018-07-27', own_scene=False, " +
      quick +
      ")\n"
      "after = (scene.camera, scene.world, scene.render.engine, scene.view_settings.exposure)\n"
      "print('same', before == after and len(bpy.data.scenes) == 1)\n"
      "print('objects', *sorted(o.name for o in scene.objects))\n"
      "bpy.ops.coppermoon.bake()\n"
      "print('threshold', scene.cycles.light_sampling_threshold)\n" +
      print_state);
  ASSERT_EQ(outcome.status, 0) << outcome.out;
  EXPECT_EQ(line(outcome, "same"), "True");
  EXPECT_EQ(number(outcome, "threshold"), 0) << "or Cycles drops moonlight at random";
  EXPECT_EQ(line(outcome, "objects"), "Camera Cube Light Moon Moonlight");
  EXPECT_NE(line(outcome, "image"), "none");
}

/// Where Moon and first star stand in the sky of the scene: altitude, azimuth and diameter [degrees].
const std::string print_sky =
    "import math, mathutils\n"
    "scene = bpy.context.scene\n"
    "moon, stars = bpy.data.objects['Moon'], bpy.data.objects['Stars']\n"
    "def places(d):\n"
    "    return math.degrees(math.asin(d.normalized().z)), math.degrees(math.atan2(d.x, d.y)) % "
    "360\n"
    "def star():\n"
    "    corners = [stars.matrix_world @ v.co for v in stars.data.vertices[:4]]\n"
    "    return sum(corners, mathutils.Vector())\n"
    "def say(name):\n"
    "    d = moon.matrix_world.translation\n"
    "    print('moon' + name, *places(d), math.degrees(2 * math.asin(moon.scale[0] / d.length)))\n"
    "    print('star' + name, *places(star()))\n";

TEST_F(BlenderAddOn, HangsMoonAndStarsIntoTheSkyOfALandscape) {
  const auto in_sky =
      fmt::format(
          "bpy.ops.coppermoon.add_eclipse(date='{}', place='{}', own_scene=False, "
          "texture_width=1024)\n",
          look.instant, at(look.observer)) +
      print_sky + "say('')\nprint('clip', scene.camera.data.clip_end)\n" + square() +
      fmt::format(
          "from coppermoon import film\nfilm.set_render(scene)\n"
          "scene.world = film.black_world()\n"
          "bpy.data.objects.remove(bpy.data.objects['Cube'])\n"
          "eye = scene.camera\neye.location, eye.rotation_mode = (0, 0, 0), 'QUATERNION'\n"
          "eye.data.lens = eye.data.sensor_width / 2 / math.tan(math.radians({}) / 2)\n",
          field_deg);
  const auto said = python(
      in_sky +
          "eye.rotation_quaternion = moon.matrix_world.translation.to_track_quat('-Z', 'Y')\n"
          "stars.hide_render = True\n",
      words_of("-o {} -f 1", here("moon.####")));
  ASSERT_EQ(said.status, 0) << said.out << said.err;
  const auto sky = look.sky();
  const auto view = look.view();
  std::istringstream moon(line(said, "moon")), star(line(said, "star"));
  double altitude = 0, azimuth = 0, diameter = 0;
  moon >> altitude >> azimuth >> diameter;
  const auto place = uses::apparent_place(look.observer, sky);
  EXPECT_WITHIN(altitude, in_degrees(place.altitude), 1e-4, "single precision");
  EXPECT_WITHIN(azimuth, in_degrees(place.azimuth), 1e-4, "single precision");
  EXPECT_WITHIN_RELATIVE(
      diameter,
      2 * in_degrees(algebra::radians(std::asin(almanac::lunar_radius / view.moon_distance))), 1e-5,
      "single precision");
  EXPECT_GT(number(said, "clip"), 384e3) << "or the camera would not see it";
  ASSERT_EQ(textures_kept().size(), 1U);
  const auto frame = luminances(texture::read_image(here("moon.0001.exr"))),
             reference = luminances(
                 reference_projection(texture::read_image(textures_kept().front()), look.camera()));
  EXPECT_LT(part_that_differs(frame, reference, radius_px(look.camera()), 0.01), 0.01);
  EXPECT_WITHIN_RELATIVE(total(frame), total(reference), 5e-4,
                         "rays in the pixels of the limb: 1.5e-4");
  EXPECT_LT(glm::length(shift(frame, reference)), 0.1);

  const auto listed =
      coppermoon(words_of("sky {} --at {} --stars 6.5 --json", look.instant, at(look.observer)));
  const auto first = nlohmann::json::parse(listed.out)["stars"][0];
  star >> altitude >> azimuth;
  EXPECT_WITHIN(altitude, first["altitude_deg"].get<double>(), 1e-4, "single precision");
  EXPECT_WITHIN(azimuth, first["azimuth_deg"].get<double>(), 1e-4, "single precision");
  const auto light =
      lux(rendered(in_sky + "eye.rotation_quaternion = star().to_track_quat('-Z', 'Y')\n"));
  for (int k = 0; k < 3; ++k)
    EXPECT_WITHIN_RELATIVE(light[k], first["illuminance_lux"][k].get<double>(), 0.01,
                           "64 rays in the pixels of its edges, an eighth of all");
}

TEST_F(BlenderAddOn, TurnsTheSkyOfALandscapeInAFilm) {
  const auto outcome = python(
      "bpy.ops.coppermoon.add_eclipse(date='2018-07-27', place='-33.9,18.4', own_scene=False, "
      "film=True, frames=3, begin='2018-07-27T20:10Z', end='2018-07-27T21:30Z', " +
      quick + ")\n" + print_sky +
      "for frame in (1, 3):\n    scene.frame_set(frame)\n    say(str(frame))\n");
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const auto sky_of = [&](const std::string& name, const std::string& what) {
    std::istringstream text(line(outcome, what + name));
    std::array<double, 2> place{};
    text >> place[0] >> place[1];
    return place;
  };
  const auto listed = coppermoon("sky 2018-07-27T21:30Z --at -33.9,18.4 --stars 6.5 --json");
  const auto sky = nlohmann::json::parse(listed.out);
  const auto moon = sky_of("3", "moon"), star = sky_of("3", "star"), before = sky_of("1", "star");
  EXPECT_WITHIN(moon[0], sky["altitude_deg"].get<double>(), 1e-3, "a part of a second");
  EXPECT_WITHIN(moon[1], sky["azimuth_deg"].get<double>(), 2e-3, "a part of a second");
  double nearest = 90;
  for (const auto& one : sky["stars"])
    if (one["illuminance_lux"][0] > 1e-5)
      nearest = std::min(nearest, std::hypot(star[0] - one["altitude_deg"].get<double>(),
                                             (star[1] - one["azimuth_deg"].get<double>()) *
                                                 std::cos(in_radians(algebra::degrees(star[0])))));
  EXPECT_WITHIN(nearest, 0, 0.2,
                "degrees: refraction where it was first, and a planet's way in an hour");
  EXPECT_GT(std::hypot(star[0] - before[0], star[1] - before[1]), 10) << "degrees, in 80 minutes";
}

TEST_F(BlenderAddOn, KeysTheFilmOfALandscape) {
  const auto outcome = python(
      "import os\n"
      "bpy.ops.coppermoon.add_eclipse(date='2018-07-27', place='42.3,13.4', own_scene=False, "
      "film=True, frames=5, start_frame=1001, night=True, " +
      quick +
      ")\n"
      "scene = bpy.context.scene\n"
      "print('range', scene.frame_start, scene.frame_end)\n"
      "print('marks', *[f'{m.name}={m.frame}' for m in scene.timeline_markers])\n"
      "stops = []\n"
      "for frame in range(1001, 1006):\n"
      "    scene.frame_set(frame)\n"
      "    stops.append(scene.view_settings.exposure)\n"
      "print('stops', *stops)\n"
      "scene.frame_set(1005)\n"
      "print('sky', bpy.path.abspath(scene.world.node_tree.nodes['Environment "
      "Texture'].image.filepath))\n"
      "values = bpy.data.objects['Moon'].coppermoon\n"
      "values.film, values.night = False, False\n"
      "bpy.ops.coppermoon.bake()\n"
      "now = scene.view_settings.exposure\n"
      "scene.frame_set(1002)\n"
      "print('marked', len(scene.timeline_markers))\n"
      "print('keyed', scene.view_settings.exposure != now)\n");
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  // The Moon rises between 18:23 and 18:25 UTC; by the published contacts above, in four steps of 76 minutes.
  EXPECT_EQ(line(outcome, "range"), "1001 1005");
  EXPECT_TRUE(line(outcome, "marks").ends_with("U2=1002 U3=1003 U4=1004 P4=1005"));
  EXPECT_EQ(line(outcome, "marked"), "0") << "one moment";
  EXPECT_EQ(line(outcome, "keyed"), "False") << "one moment";
  const auto film = std::filesystem::path(line(outcome, "sky")).parent_path().parent_path();
  std::istringstream stops(line(outcome, "stops"));
  for (int frame = 1; frame <= 5; ++frame) {
    double keyed = std::nan("");
    stops >> keyed;
    const auto file = film / fmt::format("frame_lin_rec709.{:04}.exr", frame);
    const auto shot = [&](const char* name) {
      return std::stod(texture::read_attribute(file, name).value_or("nan"));
    };
    EXPECT_WITHIN(
        keyed,
        std::log2(colour::exposure_scale({shot("expTime"), shot("aperture"), shot("isoSpeed")})),
        1e-4, "the program's exposure, of single precision")
        << frame;
  }
}

TEST_F(BlenderAddOn, ListsTheEclipsesOfSomeYears) {
  const auto outcome = python(
      "from types import SimpleNamespace\n"
      "from coppermoon import operators\n"
      "years = SimpleNamespace(first_year=2018, last_year=2019)\n"
      "items = operators.eclipses_listed(years, None)\n"
      "print('list', *[item[1].split(',')[0] for item in items], sep=';')\n");
  ASSERT_EQ(outcome.status, 0) << outcome.out;
  // F. Espenak and J. Meeus, Five Millennium Canon of Lunar Eclipses (NASA, 2006).
  EXPECT_SAYS(outcome.out,
              "list;By date;2018-01-31  total;2018-07-27  total;2019-01-21  total;"
              "2019-07-16  partial\n");
}

TEST_F(BlenderAddOn, SaysWhatTheProgramFindsWrong) {
  const auto said = [&](const std::string& values) {
    const auto outcome = python("bpy.ops.coppermoon.add_eclipse(" + values + ")");
    EXPECT_EQ(outcome.status, 3) << values;
    return line(outcome, "Error:");
  };
  EXPECT_TRUE(said("date='2018-07-29'").starts_with("2018-07-29: no lunar eclipse is greatest"));
  EXPECT_SAYS(said("date='2018-07-27', place='Atlantis'"), "Atlantis");
  EXPECT_TRUE(said("date='--version'").starts_with("date = --version; allowed is a day"));
  EXPECT_TRUE(
      said("date='2018-07-27/../x'").starts_with("date = 2018-07-27/../x; allowed is a day"));
  EXPECT_EQ(said("date='2018-07-27', up='zenith'"), "up = zenith: needs a place");
  EXPECT_EQ(said("date='2018-07-27', texture_width=65"),
            "texture width = 65, allowed is an even number");
}

/// In a window of a screen that nobody sees, the program works in the background: the window's own
/// events go on, and undo takes back what it made.
TEST_F(BlenderAddOn, WorksInAWindow) {
  file("steps.py",
       "import bpy\n"
       "from coppermoon.operators import Running\n"
       "def state(word):\n"
       "    moon = bpy.data.objects['Moon']\n"
       "    node = next(n for n in moon.active_material.node_tree.nodes if n.type == 'TEX_IMAGE')\n"
       "    print(word, node.image.filepath if node.image else 'none', flush=True)\n"
       "def steps():\n"
       "    add = bpy.ops.coppermoon.add_eclipse\n"
       "    add('EXEC_DEFAULT', True, date='2018-07-27', " +
           quick +
           ")\n"
           "    state('added')\n"
           "    while Running.now:\n"
           "        yield\n"
           "    state('baked')\n"
           "    bpy.ops.ed.undo()\n"
           "    yield\n"
           "    state('undone')\n"
           "    bpy.ops.ed.redo()\n"
           "    yield\n"
           "    state('redone')\n"
           "    bpy.data.objects['Moon'].coppermoon.quality = 'reference'\n"
           "    bpy.ops.coppermoon.bake('INVOKE_DEFAULT')\n"
           "    ticks = 0\n"
           "    while Running.now and ticks < 3:\n"
           "        ticks += 1\n"
           "        yield\n"
           "    print('ticks', ticks)\n"
           "    bpy.ops.coppermoon.stop()\n"
           "    while Running.now:\n"
           "        yield\n"
           "    state('stopped')\n"
           "    bpy.data.objects['Moon'].coppermoon.quality = 'draft'\n"
           "    bpy.data.objects['Moon'].coppermoon.film = True\n"
           "    bpy.data.objects['Moon'].coppermoon.frames = 2\n"
           "    bpy.data.objects['Moon'].coppermoon.shader = False\n"
           "    bpy.ops.coppermoon.bake('INVOKE_DEFAULT')\n"
           "    yield\n"
           "    bpy.ops.ed.undo()\n"  // the Moon's own values are gone now
           "    while Running.now:\n"
           "        yield\n"
           "    state('gone_on')\n"
           "    print('finished yes', flush=True)\n"
           "work = steps()\n"
           "def tick():\n"
           "    window = bpy.context.window_manager.windows[0]\n"
           "    area = next(a for a in window.screen.areas if a.type == 'VIEW_3D')\n"
           "    try:\n"
           "        with bpy.context.temp_override(window=window, area=area, "
           "region=area.regions[-1]):\n"
           "            next(work)\n"
           "        return 0.02\n"
           "    except StopIteration:\n"
           "        pass\n"
           "    except Exception as error:\n"
           "        print(error, flush=True)\n"
           "    bpy.ops.wm.quit_blender()\n"
           "bpy.app.timers.register(tick, first_interval=1)\n");
  surroundings = {"LIBGL_ALWAYS_SOFTWARE=1", "TMPDIR=/tmp"};  // no space, for Xvfb
  const auto outcome =
      blender("xvfb-run -a timeout 600 blender --factory-startup --addons coppermoon -P steps.py");
  EXPECT_EQ(line(outcome, "added"), "none");
  EXPECT_GT(number(outcome, "ticks"), 2) << "timers of others, while the program worked";
  EXPECT_TRUE(line(outcome, "baked").ends_with(".tx"));
  EXPECT_EQ(line(outcome, "undone"), "none");
  EXPECT_EQ(line(outcome, "redone"), line(outcome, "baked"));
  EXPECT_EQ(line(outcome, "stopped"), line(outcome, "baked"));
  EXPECT_TRUE(line(outcome, "gone_on").ends_with("0001.exr")) << "after undo, while it baked";
  EXPECT_EQ(line(outcome, "finished"), "yes");
}

TEST_F(BlenderAddOn, PutsTheNightSkyAroundALandscapeNorthToItsY) {
  const auto outcome = python(
      "import math, mathutils\n"
      "scene = bpy.context.scene\n"
      "bpy.ops.coppermoon.add_eclipse(date='2018-07-27', contact='U1', offset=600, "
      "place='-1.28,36.82', own_scene=False, night=True, " +
      quick +
      ")\n"
      "node = next(n for n in scene.world.node_tree.nodes if n.type == 'TEX_ENVIRONMENT')\n"
      "print('dome', node.image.filepath)\n"
      "for thing in scene.objects:\n"
      "    thing.hide_render = True\n"
      "eye = bpy.data.objects.new('Eye', bpy.data.cameras.new('Eye'))\n"
      "scene.collection.objects.link(eye)\n"
      "scene.camera, eye.data.angle, eye.rotation_mode = eye, math.radians(0.3), 'QUATERNION'\n"
      "scene.render.engine, scene.cycles.samples, scene.cycles.use_denoising = 'CYCLES', 4, False\n"
      "scene.render.resolution_x = scene.render.resolution_y = 8\n"
      "scene.render.image_settings.file_format = 'OPEN_EXR'\n"
      "scene.render.image_settings.color_depth = '32'\n"
      "for azimuth in (45, 135, 225, 315):\n"
      "    a, e = math.radians(azimuth), math.radians(30)\n"
      "    to = mathutils.Vector((math.cos(e) * math.sin(a), math.cos(e) * math.cos(a), "
      "math.sin(e)))\n"
      "    eye.rotation_quaternion = to.to_track_quat('-Z', 'Y')\n"
      "    scene.render.filepath = bpy.path.abspath(f'" +
      here().string() +
      "/{azimuth}.exr')\n"
      "    bpy.ops.render.render(write_still=True)\n"
      "moon = bpy.data.objects['Moon']\n"
      "to = moon.matrix_world.translation\n"
      "eye.rotation_quaternion, eye.data.clip_end = to.to_track_quat('-Z', 'Y'), 1e6\n"
      "air = [n for n in moon.active_material.node_tree.nodes if n.type == 'EMISSION'][1]\n"
      "for name, hidden, strength in (('behind', True, 1), ('both', False, 1), ('moon', False, "
      "0)):\n"
      "    moon.hide_render, air.inputs['Strength'].default_value = hidden, strength\n"
      "    scene.render.filepath = r'" +
      here().string() +
      "/' + name + '.exr'\n"
      "    bpy.ops.render.render(write_still=True)\n");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto behind = texture::read_image(here("behind.exr")),
             both = texture::read_image(here("both.exr")),
             moon = texture::read_image(here("moon.exr"));
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_WITHIN(both(4, 4, k), moon(4, 4, k) + behind(4, 4, k),
                  0.01 * behind(4, 4, k) + 1e-5 * moon(4, 4, k),
                  "air before the Moon shines as that beside it: the same texels, other rays");
  const auto dome = texture::read_image(line(outcome, "dome"));
  for (const int azimuth : {45, 135, 225, 315}) {
    const auto seen = texture::read_image(here(fmt::format("{}.exr", azimuth)));
    const auto row = dome.height / 3,
               column = static_cast<std::size_t>(azimuth + 180) % 360 * dome.width / 360;
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_WITHIN_RELATIVE(seen(4, 4, k), dome(row, column, k), 0.02, "a texel beside it")
          << azimuth;
  }
}

/// Cycles reads the recipe itself, by OpenImageIO; nothing is baked before it does.
TEST_F(BlenderAddOn, CyclesRendersARecipe) {
  file("moon.eclipse", fmt::format("instant = \"{}\"\nat = \"{}\"\ntexture-width = 1024\n",
                                   look.instant, at(look.observer)));
  expect_done(coppermoon("bake --recipe moon.eclipse -o moon_lin_rec709.exr"));
  const auto frame_of = [&](const std::string& more) {
    return luminances(rendered("moon_lin_rec709.exr", up, more));
  };
  const std::string by_recipe =
      "node = next(n for n in bpy.context.object.active_material.node_tree.nodes\n"
      "            if n.type == 'TEX_IMAGE')\n"
      "space = node.image.colorspace_settings.name\n"
      "node.image = bpy.data.images.load('moon.eclipse')\n"
      "node.image.colorspace_settings.name = space\n";
  const auto baked = frame_of("");
  const auto unread = frame_of(by_recipe);
  EXPECT_GT(std::abs(total(unread) / total(baked) - 1), 0.5)
      << "who cannot read it shows something else";
  ASSERT_TRUE(textures_kept().empty());
  surroundings = {"OIIO_LIBRARY_PATH=" COPPERMOON_READERS};
  const auto read = frame_of(by_recipe);
  EXPECT_EQ(textures_kept().size(), 1U);
  EXPECT_WITHIN_RELATIVE(total(read), total(baked), 2e-4, "the same texels, in halves");
  EXPECT_EQ(part_that_differs(read, baked, radius_px(look.camera()), 0.001), 0);
}

}  // namespace coppermoon::hand_off::blender_add_on_test
