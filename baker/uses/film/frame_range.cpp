// SPDX-License-Identifier: MIT
#include "uses/film/frame_range.h"

#include <fmt/format.h>

#include <optional>
#include <sstream>

#include "algebra/error.h"

namespace coppermoon::uses {
namespace {

struct Run {
  std::size_t from, to, step;
};

std::optional<Run> run_from(const std::string& text) {
  const auto cross = text.find('x');
  const auto ends = text.substr(0, cross);
  const auto dash = ends.find('-');
  const auto from = whole_number(ends.substr(0, dash)),
             to = dash == std::string::npos ? from : whole_number(ends.substr(dash + 1)),
             step = cross == std::string::npos ? 1 : whole_number(text.substr(cross + 1));
  if (!from || !to || !step || *step == 0 || *to < *from) return std::nullopt;
  return Run{*from, *to, *step};
}

}  // namespace

std::vector<std::size_t> frames_in(const std::string& text, std::size_t count, std::size_t first) {
  const auto last = first + count - 1;
  const auto all = fmt::format("{}-{}", first, last);
  std::vector<std::size_t> frames;
  std::vector<bool> taken(count);
  std::istringstream parts(text.empty() ? all : text);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto run = run_from(part);
    if (!run || run->from < first || run->to > last)
      throw algebra::Error(fmt::format(
          "range = {}, allowed frames of {}, as 1-240, 1-240x2 or 7,9,20-30", text, all));
    for (std::size_t frame = run->from; frame <= run->to; frame += run->step) {
      if (!taken[frame - first]) frames.push_back(frame);
      taken[frame - first] = true;
    }
  }
  return frames;
}

std::vector<std::size_t> part_of(const std::vector<std::size_t>& frames, const Shard& shard) {
  std::vector<std::size_t> mine;
  for (std::size_t i = shard.part - 1; i < frames.size(); i += shard.parts)
    mine.push_back(frames[i]);
  return mine;
}

}  // namespace coppermoon::uses
