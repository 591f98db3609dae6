// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cmath>

/// |value − reference| <= tolerance, with the reason why the tolerance is that number. A NaN fails.
#define EXPECT_WITHIN(value, reference, tolerance, reason)                       \
  EXPECT_TRUE(std::abs((value) - (reference)) <= (tolerance))                    \
      << #value " = " << (value) << ", reference " << (reference) << ", off by " \
      << (value) - (reference) << ", tolerance " << (tolerance) << " (" << (reason) << ")"

/// The same, the tolerance relative to the reference.
#define EXPECT_WITHIN_RELATIVE(value, reference, tolerance, reason) \
  EXPECT_WITHIN(value, reference, (tolerance)*std::abs(reference), reason)
