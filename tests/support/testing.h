// SPDX-License-Identifier: MIT
// What nearly every test includes; the standard headers are compiled once beforehand.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "support/refusals.h"
#include "support/within.h"

/// The text has the part in it, or has not; it is shown where that is otherwise.
#define EXPECT_SAYS(text, part)                                            \
  EXPECT_TRUE(std::string_view(text).find(part) != std::string_view::npos) \
      << "no \"" << (part) << "\" in: " << (text)
#define EXPECT_SAYS_NOT(text, part)                                        \
  EXPECT_TRUE(std::string_view(text).find(part) == std::string_view::npos) \
      << "\"" << (part) << "\" in: " << (text)
