// SPDX-License-Identifier: MIT
// Lets OpenImageIO read an eclipse. A recipe file whose name ends in .eclipse is read as the texture that `coppermoon
// bake` makes from it. The program bakes the texture into a cache folder when the recipe is first read, and later reads
// use the baked file. Baking runs in a process of its own, so that a faulty recipe cannot crash the host application.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>
#include <OpenImageIO/sysutil.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "algebra/error.h"
#include "files/cache_folder.h"
#include "files/child_process.h"
#include "files/loaded_library.h"

namespace coppermoon::wrappers {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view ending = ".eclipse";

/// Options that may follow a file's name, as in moon.eclipse?texture-width=2048&instant=2018-07-27. No others are
/// allowed, because a file name in someone's scene must not be able to make the program write other files.
constexpr std::array allowed_options{"at",        "instant", "quality", "space", "texture-width",
                                     "tolerance", "type"};

/// A recipe's file and the options that follow its name.
struct Request {
  fs::path recipe;
  std::map<std::string, std::string> options;
};

/// The file at the beginning of a name, even if the options after it cannot be parsed.
fs::path file_in(const std::string& name) { return name.substr(0, name.find('?')); }

/// Splits a name into a file and its options. Throws Error if an option cannot be parsed or is not allowed.
Request request_of(const std::string& name) {
  Request request;
  std::string file;
  if (!OIIO::Strutil::get_rest_arguments(name, file, request.options))
    throw algebra::Error(fmt::format(
        "{}: its options cannot be read, allowed FILE?option=value&option=value", name));
  request.recipe = file;
  for (const auto& [option, value] : request.options)
    if (std::ranges::find(allowed_options, option) == allowed_options.end())
      throw algebra::Error(fmt::format("{}: has an option {}, allowed {}", name, option,
                                       fmt::join(allowed_options, ", ")));
  return request;
}

/// Finds the program above this library's folder (as in the build), where it was installed, or on the PATH.
std::string program() {
  static const char mine = 0;
  const auto folder = files::file_that_has(&mine).parent_path();
  for (const char* programs : {"..", COPPERMOON_PROGRAMS}) {
    std::error_code failed;
    const auto path = folder / programs / "coppermoon";
    if (fs::is_regular_file(path, failed)) return path.lexically_normal().string();
  }
  return "coppermoon";
}

/// Environment variable that lists the recipes being read, one per line. Each recipe names the next as its albedo map.
/// The variable passes the list to the program, which may itself read a recipe with this reader.
constexpr const char* variable_of_recipes = "COPPERMOON_RECIPES_BEING_READ";

/// Returns the list of recipes being read, with the given recipe appended.
///
/// Throws  Error  if the recipe is already in the list
std::string recipes_read_with(const fs::path& recipe) {
  const std::string before(OIIO::Sysutil::getenv(variable_of_recipes));
  const auto name = fs::weakly_canonical(recipe).string();
  auto all = before.empty() ? name : before + "\n" + name;
  if (const auto first = ("\n" + before + "\n").find("\n" + name + "\n"); first != all.npos)
    throw algebra::Error(
        fmt::format("{}: its map is made from itself: {}", name,
                    OIIO::Strutil::replace(all.substr(first), "\n", " -> ", true)));
  return all;
}

/// Runs the program, and returns what it writes to standard output.
///
/// Throws  Error  for the same reasons as files::output_of, but without the program's name at the start of the message
std::string said_by(const files::Program& program) {
  try {
    return files::output_of(program);
  } catch (const algebra::Error& error) {
    const std::string text(error.what()), name("coppermoon: ");
    throw algebra::Error(text.starts_with(name) ? text.substr(name.size()) : text);
  }
}

/// Path of a recipe's texture, which is baked unless it exists. Paths in the recipe are relative to its own folder.
fs::path texture_of(const Request& request) {
  const auto recipe = fs::absolute(request.recipe);
  std::vector<std::string> words{program(), "bake", "--recipe=" + recipe.string(),
                                 "--cache=" + files::usual_cache().string()};
  for (const auto& [option, value] : request.options)
    words.push_back(fmt::format("--{}={}", option, value));
  auto path = said_by(
      {.words = words,
       .package = "coppermoon",
       .folder = recipe.parent_path(),
       .variables = {fmt::format("{}={}", variable_of_recipes, recipes_read_with(recipe))}});
  path.resize(std::min(path.find('\n'), path.size()));
  return path;
}

/// Prints an error about a file name with options to stderr, once. This helps users of oiiotool, which tries to open
/// such a file several times, drops the reader's message, and ends with "File does not exist".
void say_once(const std::string& wrong) {
  static std::mutex alone;
  static std::string last;
  const std::scoped_lock lock(alone);
  if (std::exchange(last, wrong) == wrong) return;
  std::fputs(fmt::format("coppermoon: {}\n", wrong).c_str(), stderr);
}

/// OpenImageIO's reader for the texture that a recipe describes.
class EclipseInput final : public OIIO::ImageInput {
 public:
  const char* format_name() const override { return "eclipse"; }

  int supports(OIIO::string_view feature) const override {
    return texture_ ? texture_->supports(feature) : feature == "exif";
  }

  bool valid_file(const std::string& name) const override {
    std::error_code failed;
    const auto recipe = file_in(name);
    return recipe.extension() == ending && fs::is_regular_file(recipe, failed);
  }

  bool open(const std::string& name, OIIO::ImageSpec& spec) override {
    close();
    try {
      const auto request = request_of(name);
      std::error_code failed;
      if (!fs::is_regular_file(request.recipe, failed))
        throw algebra::Error(fmt::format("{}: there is no such file", request.recipe.string()));
      const auto texture = texture_of(request);
      texture_ = OIIO::ImageInput::open(texture.string());
      if (!texture_)
        throw algebra::Error(fmt::format("{}: {}", texture.string(), OIIO::geterror()));
    } catch (const std::exception& error) {
      errorfmt("{}", error.what());
      if (name.find('?') != name.npos) say_once(error.what());
      return false;
    }
    spec = m_spec = texture_->spec();
    return true;
  }

  bool close() override {
    texture_.reset();
    return true;
  }

  int current_subimage() const override { return texture_ ? texture_->current_subimage() : 0; }
  int current_miplevel() const override { return texture_ ? texture_->current_miplevel() : 0; }

  bool seek_subimage(int subimage, int miplevel) override {
    if (!texture_ || !texture_->seek_subimage(subimage, miplevel)) return false;
    m_spec = texture_->spec();
    return true;
  }

  bool read_native_scanline(int subimage, int miplevel, int y, int z, void* data) override {
    return read(texture_ && texture_->read_native_scanline(subimage, miplevel, y, z, data));
  }

  bool read_native_tile(int subimage, int miplevel, int x, int y, int z, void* data) override {
    return read(texture_ && texture_->read_native_tile(subimage, miplevel, x, y, z, data));
  }

  bool read_native_tiles(int subimage, int miplevel, int x_begin, int x_end, int y_begin, int y_end,
                         int z_begin, int z_end, void* data) override {
    return read(texture_ && texture_->read_native_tiles(subimage, miplevel, x_begin, x_end, y_begin,
                                                        y_end, z_begin, z_end, data));
  }

 private:
  /// If reading failed, passes on the error message of the texture's own reader. Returns `done`.
  bool read(bool done) {
    if (!done) errorfmt("{}", texture_ ? texture_->geterror() : "no eclipse is open");
    return done;
  }

  std::unique_ptr<OIIO::ImageInput> texture_;
};

}  // namespace
}  // namespace coppermoon::wrappers

// OpenImageIO looks up these names in a library called eclipse.imageio.so. The format is not called coppermoon,
// because OpenImageIO's writers drop attributes that begin with the name of another format, such as coppermoon:recipe.
extern "C" {
OIIO_EXPORT int eclipse_imageio_version = OIIO_PLUGIN_VERSION;
OIIO_EXPORT const char* eclipse_imageio_library_version() { return nullptr; }
OIIO_EXPORT OIIO::ImageInput* eclipse_input_imageio_create() {
  return new coppermoon::wrappers::EclipseInput;
}
OIIO_EXPORT const char* eclipse_input_extensions[] = {"eclipse", nullptr};
}
