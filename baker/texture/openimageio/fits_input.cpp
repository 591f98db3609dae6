// SPDX-License-Identifier: MIT
#include "texture/openimageio/fits_input.h"

#include <fitsio.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "algebra/error.h"

namespace coppermoon::texture {
namespace {

using algebra::Error;

void require_success(int status) {
  if (status == 0) return;
  fits_clear_errmsg();
  std::array<char, FLEN_STATUS> text{};
  fits_get_errstatus(status, text.data());
  throw Error(text.data());
}

/// Refuses a file that does not start as a FITS file, because CFITSIO would unpack any compressed file, however large.
void require_plain(const std::string& name) {
  constexpr std::string_view sign = "SIMPLE  =";
  std::array<char, sign.size()> bytes{};
  std::ifstream(name, std::ios::binary).read(bytes.data(), bytes.size());
  if (std::string_view(bytes.data(), bytes.size()) != sign)
    throw Error("no FITS file, which begins with SIMPLE");
}

/// Value of a header card; nothing if the card is absent or has another type.
template <class Value>
std::optional<Value> card(fitsfile* file, int type, const char* name) {
  int status = 0;
  Value value{};
  void* place = &value;
  if constexpr (!std::is_arithmetic_v<Value>) place = value.data();
  fits_read_key(file, type, name, place, nullptr, &status);
  if (status != 0) fits_clear_errmsg();
  return status == 0 ? std::optional(value) : std::nullopt;
}

std::optional<double> number_in_card(fitsfile* file, const char* name) {
  return card<double>(file, TDOUBLE, name);
}

std::optional<std::string> text_in_card(fitsfile* file, const char* name) {
  const auto text = card<std::array<char, FLEN_VALUE>>(file, TSTRING, name);
  return text ? std::optional<std::string>(text->data()) : std::nullopt;
}

/// Layout of an image, and the stored number that is read as 1 (`full`).
struct Header {
  int bitpix = 0, width = 0, height = 0, planes = 1;
  double full = 1;
  bool first_row_on_top = false;
};

int axis_of(LONGLONG length, int number) {
  if (length < 1 || length > 1 << 20)
    throw Error(fmt::format("NAXIS{} = {}, allowed 1 to {}", number, length, 1 << 20));
  return static_cast<int>(length);
}

Header header_of(fitsfile* file) {
  int status = 0, axes = 0;
  std::array<LONGLONG, 3> lengths{};
  Header header;
  fits_get_img_paramll(file, 3, &header.bitpix, &axes, lengths.data(), &status);
  require_success(status);
  if (axes != 2 && axes != 3)
    throw Error(fmt::format("NAXIS = {}, allowed 2 or 3, of the file's first image", axes));
  header.width = axis_of(lengths[0], 1);
  header.height = axis_of(lengths[1], 2);
  if (axes == 3) header.planes = axis_of(lengths[2], 3);
  if (header.planes != 1 && header.planes != 3)
    throw Error(fmt::format("NAXIS3 = {}, allowed 1, or 3 for red, green and blue", header.planes));
  if (const auto mosaic = text_in_card(file, "BAYERPAT"); mosaic && header.planes == 1)
    throw Error(
        fmt::format("BAYERPAT = {}, a mosaic of colours, allowed are colours of each pixel, "
                    "as a program that debayers writes them",
                    *mosaic));
  const double zero = number_in_card(file, "BZERO").value_or(0),
               scale = number_in_card(file, "BSCALE").value_or(1);
  if (header.bitpix > 0 && scale == 1)
    header.full = zero + (header.bitpix == 8 ? 255 : std::exp2(header.bitpix - 1) - 1);
  if (!(header.full > 0 && std::isfinite(header.full) && std::isfinite(scale)))
    throw Error(fmt::format("BZERO = {:g}, allowed what leaves light above 0", zero));
  header.first_row_on_top = text_in_card(file, "ROWORDER") == "TOP-DOWN";
  return header;
}

/// Copies the header's data about a photograph under EXIF's names. INSTRUME, GAIN, TIMESYS and DATAMAX are not renamed.
void add_cards(fitsfile* file, OIIO::ImageSpec& spec) {
  using Named = std::pair<const char*, const char*>;
  auto date = text_in_card(file, "DATE-OBS");
  constexpr std::size_t date_alone = 10;
  if (const auto time = text_in_card(file, "TIME-OBS"); date && date->size() == date_alone && time)
    *date += 'T' + *time;
  if (date) spec.attribute("Exif:DateTimeOriginal", *date);
  spec.attribute("TIMESYS", text_in_card(file, "TIMESYS").value_or("UTC"));
  for (const auto& [theirs, name] :
       {Named{"INSTRUME", "INSTRUME"}, Named{"EGAIN", "GAIN"}, Named{"GAIN", "GAIN"}})
    if (const auto text = text_in_card(file, theirs)) spec.attribute(name, *text);
  for (const auto& [theirs, name] :
       {Named{"EXPOSURE", "ExposureTime"}, Named{"EXPTIME", "ExposureTime"},
        Named{"FOCRATIO", "FNumber"}, Named{"ISOSPEED", "Exif:PhotographicSensitivity"},
        Named{"DATAMAX", "DATAMAX"}})
    if (const auto number = number_in_card(file, theirs))
      spec.attribute(name, static_cast<float>(*number));
}

class FitsInput : public OIIO::ImageInput {
 public:
  ~FitsInput() override { FitsInput::close(); }

  const char* format_name() const override { return "fits"; }

  bool open(const std::string& name, OIIO::ImageSpec& spec) override try {
    require_plain(name);
    int status = 0;
    // An absolute path, because CFITSIO would replace a leading ~ by a home folder. No other character is special.
    fits_open_diskfile(&file_, std::filesystem::absolute(name).string().c_str(), READONLY, &status);
    require_success(status);
    header_ = header_of(file_);
    LONGLONG begin = 0;
    fits_get_hduaddrll(file_, nullptr, &begin, nullptr, &status);
    require_success(status);
    if (static_cast<double>(std::filesystem::file_size(name)) <
        static_cast<double>(begin) +
            std::abs(header_.bitpix) / 8. * header_.width * header_.height * header_.planes)
      throw Error("it ends early");
    m_spec = {header_.width, header_.height, header_.planes, OIIO::TypeDesc::FLOAT};
    m_spec.channelnames = header_.planes == 3 ? std::vector<std::string>{"R", "G", "B"}
                                              : std::vector<std::string>{"Y"};
    m_spec.attribute("oiio:ColorSpace", "Linear");
    add_cards(file_, m_spec);
    if (auto most = m_spec.get_float_attribute("DATAMAX"); most > 0)
      m_spec.attribute("coppermoon:clipped_at", static_cast<float>(most / header_.full));
    spec = m_spec;
    return true;
  } catch (const Error& error) {
    errorfmt("{}", error.what());
    return false;
  }

  bool close() override {
    int status = 0;
    if (file_) fits_close_file(std::exchange(file_, nullptr), &status);
    return status == 0;
  }

  bool read_native_scanline(int, int, int y, int, void* data) override {
    auto* values = static_cast<float*>(data);
    std::vector<double> row(static_cast<std::size_t>(header_.width));
    double nothing = std::numeric_limits<double>::quiet_NaN();
    int status = 0, has_nothing = 0;
    for (int plane = 0; plane < header_.planes; ++plane) {
      std::array<LONGLONG, 3> first{1, (header_.first_row_on_top ? y : header_.height - 1 - y) + 1,
                                    plane + 1};
      fits_read_pixll(file_, TDOUBLE, first.data(), header_.width, &nothing, row.data(),
                      &has_nothing, &status);
      for (std::size_t x = 0; x < row.size(); ++x)
        values[x * static_cast<std::size_t>(header_.planes) + static_cast<std::size_t>(plane)] =
            static_cast<float>(row[x] / header_.full);
    }
    if (status == 0) return true;
    fits_clear_errmsg();
    errorfmt("its numbers cannot be read");
    return false;
  }

 private:
  fitsfile* file_ = nullptr;
  Header header_;
};

}  // namespace

std::unique_ptr<OIIO::ImageInput> fits_input() { return std::make_unique<FitsInput>(); }

}  // namespace coppermoon::texture
