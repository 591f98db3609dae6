// SPDX-License-Identifier: MIT
#include "texture/resize.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "algebra/error.h"

namespace coppermoon::texture {
namespace {

using algebra::Grid;

/// The texels in a row or column of the map that one texel of a smaller map covers, with their weights.
LineShare covered(std::size_t i, std::size_t size, std::size_t map_size) {
  const double width = static_cast<double>(map_size) / static_cast<double>(size);
  const double from = static_cast<double>(i) * width, to = from + width;
  const auto first = std::min(static_cast<std::size_t>(from), map_size - 1);
  const auto last = std::min(static_cast<std::size_t>(std::ceil(to)), map_size) - 1;
  if (first >= last) return {first, first, 1, 0};
  return {first, last, (static_cast<double>(first) + 1 - from) / width,
          (std::min(to, static_cast<double>(map_size)) - static_cast<double>(last)) / width};
}

/// Two neighbours in a row or column of the map. The centre of texel `i` in a larger map lies between their centres.
LineShare either_side(std::size_t i, std::size_t size, std::size_t map_size, bool closed) {
  const auto n = static_cast<double>(map_size);
  // FAULT a map half a texel aside: (size) - 0.5 => (size)
  double x = (static_cast<double>(i) + 0.5) * n / static_cast<double>(size) - 0.5;
  x = closed ? x - n * std::floor(x / n) : std::clamp(x, 0., n - 1);
  const auto first = std::min(static_cast<std::size_t>(x), map_size - 1);
  const auto last = closed ? (first + 1) % map_size : std::min(first + 1, map_size - 1);
  const double part = x - static_cast<double>(first);
  return {first, last, 1 - part, part};
}

std::vector<LineShare> column_shares(std::size_t columns, std::size_t map_columns) {
  std::vector<LineShare> shares(columns);
  for (std::size_t c = 0; c < columns; ++c)
    shares[c] = columns < map_columns ? covered(c, columns, map_columns)
                                      : either_side(c, columns, map_columns, true);
  return shares;
}

/// Weighted sum of neighbouring rows in a map.
std::vector<double> summed_rows(const Grid<float>& map, const LineShare& rows, double full) {
  std::vector<double> sums(map.columns());
  const auto add = [&](std::size_t row, double part) {
    const auto values = map.row(row);
    for (std::size_t c = 0; c < sums.size(); ++c) sums[c] += part * values[c];
  };
  add(rows.first, rows.first_part);
  for (std::size_t r = rows.first + 1; r < rows.last; ++r) add(r, full);
  if (rows.last_part > 0) add(rows.last, rows.last_part);
  return sums;
}

}  // namespace

ResizedRows::ResizedRows(const Grid<float>& map, std::size_t rows) : map_(&map), rows_(rows) {
  algebra::require_within("texture height [texels]", static_cast<double>(rows), 2, 16384);
  if (map.columns() != 2 * map.rows() || map.empty())
    throw algebra::Error(
        fmt::format("albedo map is {} x {} texels, allowed 2:1", map.columns(), map.rows()));
  if (rows != map.rows()) columns_ = column_shares(2 * rows, map.columns());
}

std::span<const float> ResizedRows::row(std::size_t row, std::vector<float>& buffer) const {
  if (rows_ == map_->rows()) return map_->row(row);
  const bool smaller = rows_ < map_->rows();
  const double full = smaller ? static_cast<double>(rows_) / static_cast<double>(map_->rows()) : 0;
  const auto sums = summed_rows(
      *map_,
      smaller ? covered(row, rows_, map_->rows()) : either_side(row, rows_, map_->rows(), false),
      full);
  buffer.resize(columns_.size());
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    const auto& share = columns_[c];
    double value = share.first_part * sums[share.first] + share.last_part * sums[share.last];
    if (smaller)
      for (std::size_t k = share.first + 1; k < share.last; ++k) value += full * sums[k];
    buffer[c] = static_cast<float>(value);
  }
  return buffer;
}

Grid<float> resized(const Grid<float>& map, std::size_t rows) {
  const ResizedRows source(map, rows);
  Grid<float> result(rows, 2 * rows);
  tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t r) {
    std::vector<float> buffer;
    std::ranges::copy(source.row(r, buffer), result.row(r).begin());
  });
  return result;
}

}  // namespace coppermoon::texture
