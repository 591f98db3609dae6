// SPDX-License-Identifier: MIT
#include "colour/picture_part.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

namespace coppermoon::colour {

PicturePart window_about(const Disc& disc, std::size_t rows, std::size_t columns) {
  const auto within = [](double at, std::size_t most) {
    return static_cast<std::size_t>(std::clamp(at, 0., static_cast<double>(most)));
  };
  const auto left = within(disc.x_px - disc.radius_px, columns),
             top = within(disc.y_px - disc.radius_px, rows);
  return {left, top, within(disc.x_px + disc.radius_px, columns) - left,
          within(disc.y_px + disc.radius_px, rows) - top};
}

algebra::Grid<float> reduced(const algebra::Grid<float>& picture, const PicturePart& part,
                             std::size_t by) {
  algebra::Grid<float> small(part.rows / by, part.columns / by);
  tbb::parallel_for(std::size_t{0}, small.rows(), [&](std::size_t r) {
    std::vector<double> sums(small.columns());
    for (std::size_t i = 0; i < by; ++i) {
      const auto line = picture.row(part.top + r * by + i).subspan(part.left);
      for (std::size_t c = 0; c < small.columns(); ++c)
        for (std::size_t k = 0; k < by; ++k) sums[c] += double{line[c * by + k]};
    }
    for (std::size_t c = 0; c < small.columns(); ++c)
      small(r, c) = static_cast<float>(sums[c] / static_cast<double>(by * by));
  });
  return small;
}

}  // namespace coppermoon::colour
