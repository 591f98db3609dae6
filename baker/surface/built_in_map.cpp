// SPDX-License-Identifier: MIT
#include "surface/built_in_map.h"

#include <jpeglib.h>
#include <cstdio>  // defines FILE for jpeglib.h

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <vector>

#include "surface/albedo_map.h"
#include "surface/tables.h"

namespace coppermoon::surface {
namespace {

/// Normal albedo for each of the 256 grey values in the map's file.
std::array<float, 256> albedo_of_codes() {
  std::array<float, 256> albedo{};
  for (std::size_t code = 0; code < albedo.size(); ++code)
    albedo[code] = static_cast<float>(kit_2019_albedo(static_cast<double>(code) / 255));
  return albedo;
}

}  // namespace

algebra::Grid<float> built_in_map() {
  const auto file = tables::moon_albedo();
  const auto albedo = albedo_of_codes();
  jpeg_error_mgr errors{};
  jpeg_decompress_struct jpeg{};
  jpeg.err = jpeg_std_error(&errors);
  // the file is part of the library, so decoding can fail only for lack of memory
  errors.error_exit = [](j_common_ptr) { throw std::bad_alloc(); };
  const std::unique_ptr<jpeg_decompress_struct, decltype(&jpeg_destroy_decompress)> destroyed(
      &jpeg, jpeg_destroy_decompress);
  jpeg_create_decompress(&jpeg);
  jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(file.data()),
               static_cast<unsigned long>(file.size()));
  jpeg_read_header(&jpeg, TRUE);
  jpeg_start_decompress(&jpeg);
  algebra::Grid<float> map(jpeg.output_height, jpeg.output_width);
  std::vector<JSAMPLE> codes(jpeg.output_width);
  for (std::size_t r = 0; r < map.rows(); ++r) {
    JSAMPROW row = codes.data();
    jpeg_read_scanlines(&jpeg, &row, 1);
    std::ranges::transform(codes, map.row(r).begin(), [&](JSAMPLE code) { return albedo[code]; });
  }
  jpeg_finish_decompress(&jpeg);
  return map;
}

}  // namespace coppermoon::surface
