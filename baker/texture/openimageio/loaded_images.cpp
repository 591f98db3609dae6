// SPDX-License-Identifier: MIT
// The program's definitions of all functions that need OpenImageIO. The first call of any of them loads OpenImageIO,
// which takes 0.2 s. At link time, these definitions come before the library's, which are therefore left out.
#include <tbb/parallel_for.h>

#include <cstddef>
#include <new>
#include <string_view>
#include <system_error>

#include "algebra/error.h"
#include "files/loaded_library.h"
#include "files/memory.h"
#include "texture/images_ahead.h"
#include "texture/openimageio/image_functions.h"

namespace coppermoon::texture {
namespace {

namespace fs = std::filesystem;
using algebra::Error;

/// Path of coppermoon_images.so: after a build it is beside the program, otherwise where it was installed.
///
/// Throws  Error  when the module is in neither place
fs::path module_file() {
  constexpr const char* name = "coppermoon_images.so";
  static const char mine = 0;
  const auto folder = files::file_that_has(&mine).parent_path();
  std::error_code failed;
  if (auto built = folder / name; fs::exists(built, failed)) return built;
  auto installed = (folder / COPPERMOON_MODULES / name).lexically_normal();
  if (fs::exists(installed, failed)) return installed;
  throw Error(fmt::format(
      "{}: no such file; it is installed with the program, and reads and writes its images",
      installed.string()));
}

/// Refuses to load the module if the system would not grant the address space for its libraries, because OpenImageIO's
/// start-up code uses memory without checking that it was allocated.
///
/// Throws  std::bad_alloc
void require_addresses() {
  constexpr std::size_t taken =
      512U << 20U;  // the module's 269 libraries take 474 MB in Debian 12; 296 take 484 MB in 13
  if (!files::has_addresses(taken)) throw std::bad_alloc();
}

/// Loads the module of functions that need OpenImageIO. It then stays loaded.
///
/// Throws  Error  (one line, naming the module's path) if the module is missing, if it or one of its libraries cannot
///                be loaded, or if it belongs to another version of coppermoon
const ImageFunctions& loaded() {
  const auto file = module_file();
  require_addresses();
  const auto give =
      reinterpret_cast<GiveImageFunctions*>(files::function_of(file, image_functions_name));
  const std::string_view version = give ? give()->version : "of unknown version";
  if (version != COPPERMOON_VERSION)
    throw Error(fmt::format("{}: belongs to coppermoon {}, allowed {}", file.string(), version,
                            COPPERMOON_VERSION));
  return *give();
}

const ImageFunctions& images() {
  static const ImageFunctions& functions = loaded();
  return functions;
}

}  // namespace

ImagesAhead::ImagesAhead() {
  if (files::addresses_are_limited()) return;
  // oneTBB is started first, because it also loads libraries and would otherwise have to wait for those of the module.
  tbb::parallel_for(0, 2, [](int) {});
  try {
    loading_ = std::thread([] {
      try {
        images();
      } catch (...) {  // the first use of an image tries again and reports the error
      }
    });
  } catch (const std::system_error&) {  // without a thread, the module is loaded later
  }
}

ImagesAhead::~ImagesAhead() {
  if (loading_.joinable()) loading_.join();
}

Image read_image(const fs::path& path) { return images().read_image(path); }

Image read_channels(const fs::path& path, const std::vector<std::string>& names) {
  return images().read_channels(path, names);
}

Windows windows_of(const fs::path& path) { return images().windows_of(path); }

std::vector<std::optional<std::string>> read_attributes(const fs::path& path,
                                                        std::span<const std::string_view> names) {
  return images().read_attributes(path, names);
}

Image read_light(const fs::path& path, Coding coding,
                 const std::optional<glm::dmat3>& rec709_from_raw) {
  return images().read_light(path, coding, rec709_from_raw);
}

bool is_raw_file(const fs::path& path) { return images().is_raw_file(path); }

algebra::Grid<float> read_albedo_map(const fs::path& path, Coding coding) {
  return images().read_albedo_map(path, coding);
}

void require_albedo_map(const fs::path& path) { images().require_albedo_map(path); }

void write_exr(const fs::path& path, const Image& image, const Attributes& attributes,
               const ExrOptions& options) {
  images().write_exr(path, image, attributes, options);
}

void write_exr(const fs::path& path, std::span<const Part> parts, const Attributes& attributes,
               const ExrOptions& options) {
  images().write_exr_of_parts(path, parts, attributes, options);
}

void write_mipmapped(const fs::path& path, const Layout& layout, const Rows& rows,
                     const Attributes& attributes, ExrType type) {
  images().write_mipmapped(path, layout, rows, attributes, type);
}

void write_picture(const fs::path& path, const Layout& layout, const Rows& rows,
                   const PictureFormat& format, const Attributes& attributes) {
  images().write_picture(path, layout, rows, format, attributes);
}

void write_png(const fs::path& path, const Image& image, int bits, const Attributes& attributes) {
  images().write_png(path, image, bits, attributes);
}

void write_tiff(const fs::path& path, const Image& image, const Attributes& attributes) {
  images().write_tiff(path, image, attributes);
}

void write_dng(const fs::path& path, const RawPhotograph& photograph,
               const Attributes& attributes) {
  images().write_dng(path, photograph, attributes);
}

void write_usdz(const fs::path& path, const Image& developed) {
  images().write_usdz(path, developed);
}

void write_glb(const fs::path& path, const Image& image, const std::string& generator,
               GlbTexels texels) {
  images().write_glb(path, image, generator, texels);
}

fs::path sheet_font() { return images().sheet_font(); }

Image drawn(const ContactSheet& sheet) { return images().drawn(sheet); }

void write_captions(Image& picture, const std::string& left, const std::string& right, float grey,
                    const fs::path& font) {
  images().write_captions(picture, left, right, grey, font);
}

}  // namespace coppermoon::texture
