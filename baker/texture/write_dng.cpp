// SPDX-License-Identifier: MIT
#include "texture/write_dng.h"

#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <memory>

#include "algebra/error.h"
#include "files/whole_file.h"

namespace coppermoon::texture {
namespace {

using algebra::Error;

/// XYZ of D65 white. D65 is illuminant 21 in the DNG specification.
constexpr glm::dvec3 white_xyz{0.95047, 1, 1.08883};

void require_sound(const RawPhotograph& photograph) {
  const auto& [numbers, black_dn, white_dn, matrix, camera, focal_length] = photograph;
  if (numbers.values().empty()) throw Error("raw photograph without a pixel, allowed one or more");
  algebra::require_within("black level [DN]", black_dn, 0, 65534);
  algebra::require_within("white level [DN]", white_dn, std::floor(black_dn) + 1, 65535);
  algebra::require_within("focal length [mm]", focal_length, 1e-3, 1e7);
  const auto neutral = matrix * white_xyz;
  algebra::require_within("least channel of white", std::min({neutral.r, neutral.g, neutral.b}),
                          1e-3, 1e3);
}

/// Error handler for libtiff that stores the last message.
int keep_words(TIFF*, void* words, const char*, const char* form, std::va_list values) {
  std::array<char, 256> text{};
  std::vsnprintf(text.data(), text.size(), form, values);
  *static_cast<std::string*>(words) = text.data();
  return 1;
}

int pass_over(TIFF*, void*, const char*, const char*, std::va_list) { return 1; }

/// A TIFF file that is being written.
class TiffFile {
 public:
  explicit TiffFile(const files::Handle& file) {
    const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(
        TIFFOpenOptionsAlloc(), &TIFFOpenOptionsFree);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_words, &words_);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), pass_over, nullptr);
    file_.reset(TIFFOpenExt(files::name_of(file).c_str(), "wl", options.get()));
    require(file_ != nullptr);
  }

  TIFF* get() { return file_.get(); }

  template <typename... Values>
  void set(std::uint32_t tag, Values... values) {
    require(TIFFSetField(file_.get(), tag, values...) == 1);
  }

  void require(bool done) const {
    if (!done) throw Error(words_.empty() ? "no room" : words_);
  }

  /// Writes the data that libtiff still holds in memory, and closes the file.
  void close() {
    require(TIFFFlush(file_.get()) == 1);
    file_.reset();
    require(words_.empty());
  }

 private:
  std::string words_;
  std::unique_ptr<TIFF, void (*)(TIFF*)> file_{nullptr, &TIFFClose};
};

std::string text_of(const Attributes& attributes, const char* name) {
  const auto found = attributes.find(name);
  const auto* text = found == attributes.end() ? nullptr : std::get_if<std::string>(&found->second);
  return text ? *text : "";
}

double number_of(const Attributes& attributes, const char* name) {
  const auto found = attributes.find(name);
  const auto* number = found == attributes.end() ? nullptr : std::get_if<float>(&found->second);
  return number ? *number : 0;
}

void set_layout(TiffFile& file, const RawPhotograph& photograph) {
  constexpr int filters = 32803, rectangular = 1;
  constexpr std::array<std::uint16_t, 2> cell{2, 2};
  // FAULT red and blue of the mosaic exchanged: {0, 1, 1, 2} => {2, 1, 1, 0}
  constexpr std::array<std::uint8_t, 4> red_green_green_blue{0, 1, 1, 2};
  file.set(TIFFTAG_SUBFILETYPE, 0);
  file.set(TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(photograph.numbers.columns()));
  file.set(TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(photograph.numbers.rows()));
  file.set(TIFFTAG_BITSPERSAMPLE, 16);
  file.set(TIFFTAG_SAMPLESPERPIXEL, 1);
  file.set(TIFFTAG_COMPRESSION, COMPRESSION_NONE);
  file.set(TIFFTAG_PHOTOMETRIC, filters);
  file.set(TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  file.set(TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
  file.set(TIFFTAG_ROWSPERSTRIP, static_cast<std::uint32_t>(photograph.numbers.rows()));
  file.set(TIFFTAG_CFAREPEATPATTERNDIM, cell.data());
  file.set(TIFFTAG_CFAPATTERN, 4, red_green_green_blue.data());
  file.set(TIFFTAG_CFALAYOUT, rectangular);
}

void set_camera(TiffFile& file, const RawPhotograph& photograph) {
  constexpr std::array<std::uint8_t, 4> version{1, 4, 0, 0}, readers{1, 1, 0, 0};
  constexpr int d65 = 21;
  const auto name = "coppermoon " + photograph.camera;
  file.set(TIFFTAG_MAKE, "coppermoon");
  file.set(TIFFTAG_MODEL, photograph.camera.c_str());
  file.set(TIFFTAG_SOFTWARE, "coppermoon");
  file.set(TIFFTAG_DNGVERSION, version.data());
  file.set(TIFFTAG_DNGBACKWARDVERSION, readers.data());
  file.set(TIFFTAG_UNIQUECAMERAMODEL, name.c_str());
  const auto black_level = static_cast<float>(photograph.black_dn);
  const auto white_level = static_cast<std::uint32_t>(photograph.white_dn);
  file.set(TIFFTAG_BLACKLEVEL, 1, &black_level);
  file.set(TIFFTAG_WHITELEVEL, 1, &white_level);
  const auto neutral = photograph.camera_from_xyz * white_xyz;
  const double most = std::max({neutral.r, neutral.g, neutral.b});
  std::array<float, 9> matrix{};
  std::array<float, 3> white_balance{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      matrix[static_cast<std::size_t>(3 * row + column)] =
          static_cast<float>(photograph.camera_from_xyz[column][row]);
    white_balance[static_cast<std::size_t>(row)] = static_cast<float>(neutral[row] / most);
  }
  file.set(TIFFTAG_COLORMATRIX1, 9, matrix.data());
  file.set(TIFFTAG_ASSHOTNEUTRAL, 3, white_balance.data());
  file.set(TIFFTAG_CALIBRATIONILLUMINANT1, d65);
}

/// Writes the directory of EXIF tags.
///
/// Returned  the directory's offset in the file
std::uint64_t exif_directory(TiffFile& file, const RawPhotograph& photograph,
                             const Attributes& attributes) {
  constexpr std::array<std::uint8_t, 4> version{'0', '2', '3', '1'};
  constexpr double most = 65535;  // largest ISO speed that this 16-bit tag can hold
  constexpr int recommended_index = 2;
  file.require(TIFFCreateEXIFDirectory(file.get()) == 0);
  file.set(EXIFTAG_EXIFVERSION, version.data());
  if (const double time_s = number_of(attributes, "expTime"); time_s > 0)
    file.set(EXIFTAG_EXPOSURETIME, time_s);
  if (const double f_number = number_of(attributes, "aperture"); f_number > 0)
    file.set(EXIFTAG_FNUMBER, f_number);
  if (const double iso = std::round(number_of(attributes, "isoSpeed")); iso > 0) {
    const auto speed = static_cast<std::uint16_t>(std::min(iso, most));
    file.set(EXIFTAG_ISOSPEEDRATINGS, 1, &speed);
    file.set(EXIFTAG_SENSITIVITYTYPE, recommended_index);
    file.set(EXIFTAG_RECOMMENDEDEXPOSUREINDEX, static_cast<std::uint32_t>(iso));
  }
  if (const auto date = text_of(attributes, "capDate"); !date.empty()) {
    file.set(EXIFTAG_DATETIMEORIGINAL, date.c_str());
    file.set(EXIFTAG_OFFSETTIMEORIGINAL, "+00:00");
  }
  file.set(EXIFTAG_FOCALLENGTH, photograph.focal_length_mm);
  std::uint64_t place = 0;
  file.require(TIFFWriteCustomDirectory(file.get(), &place) == 1);
  return place;
}

void write(const files::Handle& to, const RawPhotograph& photograph, const Attributes& attributes) {
  TiffFile file(to);
  set_layout(file, photograph);
  set_camera(file, photograph);
  if (const auto date = text_of(attributes, "capDate"); !date.empty())
    file.set(TIFFTAG_DATETIME, date.c_str());
  auto row = std::vector<std::uint16_t>(photograph.numbers.columns());
  for (std::size_t r = 0; r < photograph.numbers.rows(); ++r) {
    std::ranges::copy(photograph.numbers.row(r), row.begin());  // libtiff accepts no const data
    file.require(TIFFWriteScanline(file.get(), row.data(), static_cast<std::uint32_t>(r), 0) == 1);
  }
  file.require(TIFFWriteDirectory(file.get()) == 1);
  const auto exif = exif_directory(file, photograph, attributes);
  file.require(TIFFSetDirectory(file.get(), 0) == 1);
  file.set(TIFFTAG_EXIFIFD, exif);
  file.close();
}

}  // namespace

void write_dng(const std::filesystem::path& path, const RawPhotograph& photograph,
               const Attributes& attributes) {
  require_sound(photograph);
  files::write_whole(path, [&](const files::Handle& file) {
    try {
      write(file, photograph, attributes);
    } catch (const Error& error) {
      throw Error(fmt::format("{}: cannot be written: {}", path.string(), error.what()));
    }
  });
}

}  // namespace coppermoon::texture
