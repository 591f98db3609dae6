// SPDX-License-Identifier: MIT
#include "texture/write_stellarium.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <system_error>

#include "algebra/error.h"
#include "files/lock.h"
#include "files/own_file.h"
#include "files/whole_file.h"
#include "texture/own_image.h"
#include "texture/write_image.h"

namespace coppermoon::texture {
namespace {

namespace fs = std::filesystem;

constexpr const char *shader_file = "data/shaders/planet.frag",
                     *script_file = "scripts/startup.ssc";

// Stellarium compiles this shader several times, with IS_MOON for the Moon and IS_OBJ for bodies that are not spheres.
constexpr std::string_view shader = R"(// The light of the Moon is in its texture.
varying mediump vec2 texc;
uniform sampler2D tex;

#ifdef IS_MOON

void main() { gl_FragColor = vec4(texture2D(tex, texc).rgb, 1.0); }

#else

varying mediump vec3 normalVS;
uniform highp vec3 lightDirection;
uniform mediump vec3 diffuseLight;
uniform mediump vec3 ambientLight;

void main() {
  mediump float cosine = max(dot(normalize(normalVS), lightDirection), 0.0);
  gl_FragColor = texture2D(tex, texc) * vec4(cosine * diffuseLight + ambientLight, 1.0);
}

#endif
)";

std::string script_of(const StellariumSight& sight) {
  auto utc = almanac::utc_text(sight.when);
  utc.pop_back();  // removes the final Z
  const auto& at = sight.observer;
  return fmt::format(R"(// The eclipsed Moon of coppermoon. Its light is that of this moment alone.
core.setObserverLocation({:.6f}, {:.6f}, {:.0f}, 0, "coppermoon", "Earth");
core.setDate("{}", "utc");
core.setTimeRate(0);
SolarSystem.setFlagPlanets(true);
SolarSystem.setFlagMoonScale(false);
SolarSystem.setFlagDrawMoonHalo(false);
LandscapeMgr.setFlagLandscape(false);
LandscapeMgr.setFlagAtmosphere(false);
StelMovementMgr.setEquatorialMount(false);
core.setSelectedObjectInfo("None");
core.selectObjectByName("Moon", false);
core.moveToSelectedObject(0);
StelMovementMgr.setFlagTracking(true);
StelMovementMgr.zoomTo(0.7, 0);
)",
                     algebra::in_degrees(at.longitude), algebra::in_degrees(at.latitude),
                     algebra::in_metres(at.elevation), utc);
}

void make_folder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed)
    throw algebra::Error(
        fmt::format("{}: no folder can be made there: {}", folder.string(), failed.message()));
}

}  // namespace

void require_stellarium_place(const fs::path& folder) {
  for (const char* part : {"textures", "data", "data/shaders", "scripts"})
    files::require_no_link(folder / part);
  for (const char* file : {shader_file, script_file}) files::require_stamped(folder / file);
  require_own_image(folder / stellarium_picture);
}

void write_stellarium(const fs::path& folder, const Layout& layout, const Rows& developed,
                      const StellariumSight& sight, const Attributes& attributes) {
  std::error_code ignored;
  const bool made = !fs::exists(folder, ignored);
  make_folder(folder);
  const auto alone = files::lock_folder(folder);
  require_stellarium_place(folder);
  try {
    for (const char* part : {"textures", "data/shaders", "scripts"}) make_folder(folder / part);
    write_picture(folder / stellarium_picture, layout, developed, {"png", 8}, attributes);
    files::write_whole(folder / shader_file, files::stamped(shader, "//"));
    files::write_whole(folder / script_file, files::stamped(script_of(sight), "//"));
  } catch (...) {
    if (made) fs::remove_all(folder, ignored);
    throw;
  }
}

}  // namespace coppermoon::texture
