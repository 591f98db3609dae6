// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace coppermoon::uses {

/// Frames in a second of a film: a ratio of whole numbers, as 24/1 or 24000/1001.
struct FrameRate {
  int frames = 24, seconds = 1;

  double value() const { return static_cast<double>(frames) / seconds; }
};

/// Frame rate of a text.
///
/// Given     text  "24", "12.5" or "24000/1001"; a television rate as it is mostly written, "23.976", "29.97" or
///                 "59.94", is the ratio with 1001 that is meant
/// Returned  in lowest terms; a decimal number is rounded to a thousandth
/// Throws    Error  when it is none, or outside 1 to 1000; for a ratio with more than 10000 below
FrameRate frame_rate_from(const std::string& text);

/// "24", "12.5", "24000/1001": frame_rate_from reads it back.
std::string text_of(const FrameRate& rate);

/// As frame_rate_from, for request::parameter.
void read_text(const std::string& text, FrameRate& rate);

}  // namespace coppermoon::uses
