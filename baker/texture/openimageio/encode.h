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

/// Range in which a file's values must lie.
struct Limits {
  float lowest, highest;

  bool hold(float value) const { return value >= lowest && value <= highest; }
};

/// Consecutive rows of an image that is being written to a file.
struct Band {
  std::size_t first_row = 0;
  std::vector<float> values{};
};

/// An image to be encoded. Its rows are computed, checked and passed to the encoder, a few at a time.
struct Source {
  const std::filesystem::path& path;
  const Layout& layout;
  const Rows& rows;
  Limits limits;

  std::size_t row_length() const { return layout.width * layout.channels.size(); }

  /// Computes all rows in order, in bands of a multiple of 64 rows, and calls `act` with each band. The next band is
  /// computed while `act` works on the previous one.
  ///
  /// Throws  Error  when a value is outside the limits; the message gives the value's row, column and channel
  void for_each_band(const std::function<void(const Band&)>& act) const;

  /// Checks that all values in the given rows are within the limits.
  ///
  /// Throws  Error  as for for_each_band
  void require_all(std::span<const float> values, std::size_t first_row = 0) const;

 private:
  std::size_t rows_at_once() const;
  void make(Band& band) const;
  void require_values(std::size_t row, std::span<const float> values) const;
};

/// Throws  Error  when a layout has no texels, or when a channel's name is empty or appears twice
void require_layout(const std::filesystem::path& path, const Layout& layout);

/// OpenImageIO's description of an image.
OIIO::ImageSpec spec_of(const Layout& layout, OIIO::TypeDesc type, const Attributes& attributes);

/// OpenImageIO's description of an OpenEXR file whose fingerprint has not been computed yet. If `attributes` has no
/// `capDate`, the file gets an empty one.
OIIO::ImageSpec exr_spec(const Layout& layout, ExrType type, const Attributes& attributes);

/// Largest value that a texel of the given type can hold.
float highest_of(ExrType type);

/// Writes all rows of an image to an output that is already open.
///
/// Returned  whether the output accepted all rows
bool write_scanlines(OIIO::ImageOutput& output, const Source& source);

/// Encodes a file with OpenImageIO, whole or not at all. An OpenEXR file is also sealed: its fingerprint is written
/// into its header.
///
/// Given   format  OpenImageIO's name for the format
///         encode  opens the given output, writes the image, and returns whether that succeeded. Its second argument is
///                 the file's path, for formats that OpenImageIO cannot write to a sink
/// Throws  Error   when the file cannot be written; the message gives the reason
void write_encoded(const std::filesystem::path& path, const char* format,
                   const std::function<bool(OIIO::ImageOutput&, const std::string&)>& encode);

}  // namespace coppermoon::texture
