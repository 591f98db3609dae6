// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "texture/image.h"
#include "texture/openimageio/oiio.h"
#include "texture/write_image.h"

namespace coppermoon::texture {

/// Allowed range for a file's values.
struct Limits {
  float lowest, highest;

  bool hold(float value) const { return value >= lowest && value <= highest; }
};

/// Some rows on their way into a file.
struct Band {
  std::size_t first_row = 0;
  std::vector<float> values{};
};

/// An image to be encoded: rows are made, checked and handed on, a few at a time.
struct Source {
  const std::filesystem::path& path;
  const Layout& layout;
  const Rows& rows;
  Limits limits;

  std::size_t row_length() const { return layout.width * layout.channels.size(); }

  /// Has all rows made, in order, some multiple of 64 at a time. The next are made while `act` works
  /// on the previous ones.
  ///
  /// Throws  Error  when a value is outside the limits, with its place and channel
  void for_each_band(const std::function<void(const Band&)>& act) const;

  /// Checks rows that are already made.
  ///
  /// Throws  Error  as for_each_band
  void require_all(std::span<const float> values, std::size_t first_row = 0) const;

 private:
  std::size_t rows_at_once() const;
  void make(Band& band) const;
  void require_values(std::size_t row, std::span<const float> values) const;
};

/// Throws  Error  when there are no texels, or a channel's name is empty or appears twice
void require_layout(const std::filesystem::path& path, const Layout& layout);

/// OpenImageIO's description of an image.
OIIO::ImageSpec spec_of(const Layout& layout, OIIO::TypeDesc type, const Attributes& attributes);

/// OpenImageIO's description of an OpenEXR file, not yet sealed. If `capDate` is absent, that attribute is left empty.
OIIO::ImageSpec exr_spec(const Layout& layout, ExrType type, const Attributes& attributes);

/// Largest value that a texel of the type can hold.
float highest_of(ExrType type);

/// Writes all rows of an image to an open output.
///
/// Returned  whether the output accepted them
bool write_scanlines(OIIO::ImageOutput& output, const Source& source);

/// Has OpenImageIO encode a file, whole or not at all; an OpenEXR file is sealed.
///
/// Given   format  OpenImageIO's name for it
///         encode  opens the output it is given and returns whether all was written; its second argument is the name
///                 of an open file, for formats that OpenImageIO writes only by name (otherwise any name will do)
/// Throws  Error   when the file cannot be written, with the reason
void write_encoded(const std::filesystem::path& path, const char* format,
                   const std::function<bool(OIIO::ImageOutput&, const std::string&)>& encode);

}  // namespace coppermoon::texture
