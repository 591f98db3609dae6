// SPDX-License-Identifier: MIT
#include "shadow/photon_sums.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algebra/error.h"
#include "shadow/by_photons.h"
#include "support/within.h"

namespace coppermoon::shadow {
namespace {

const Arrangement february_2008{1.479e11, {3.83e8}};
const std::vector<double> waves{500, 580, 680};

PhotonSettings settings_of(std::uint64_t photons) {
  PhotonSettings settings;
  settings.photons = photons;
  settings.trace = Trace::table;
  settings.ring_width_m = 100e3;
  settings.key = "a test";
  return settings;
}

PhotonSums traced_blocks(BlockRange blocks) {
  auto settings = settings_of(1);
  settings.blocks = blocks;
  return traced({}, february_2008, waves, settings);
}

/// Cell by cell, the light and its error.
void expect_same(const RefractedLight& a, const RefractedLight& b) {
  EXPECT_EQ(a.photons, b.photons);
  for (std::size_t i = 0; i < a.ratio[0].values().size(); ++i) {
    EXPECT_WITHIN_RELATIVE(a.ratio[0].values()[i], b.ratio[0].values()[i], 1e-12,
                           "rounding of sums in another order");
    EXPECT_WITHIN_RELATIVE(a.standard_error[0].values()[i], b.standard_error[0].values()[i], 1e-9,
                           "the same, in a difference of sums");
  }
}

TEST(PhotonSums, OfEightShardsAreThoseOfOneRun) {
  const auto all = blocks_of(100 * photons_a_block);
  const auto whole = traced_blocks(all);
  auto together = traced_blocks(shard(all, 8, 8));
  for (const std::uint64_t part : {3U, 1U, 2U, 7U, 5U, 4U, 6U})
    together = merged(std::move(together), traced_blocks(shard(all, part, 8)));
  EXPECT_EQ(together.done, whole.done);
  expect_same(estimated(together), estimated(whole));
}

TEST(PhotonSums, AreAddedToWithoutTracingAnyTwice) {
  auto before = merged(traced_blocks({0, 10}), traced_blocks({30, 41}));
  const auto more = traced({}, february_2008, waves, settings_of(50 * photons_a_block), &before);
  EXPECT_EQ(more.done, (std::vector<BlockRange>{{0, 50}}));
  expect_same(estimated(more), estimated(traced_blocks({0, 50})));
}

TEST(PhotonSums, AlreadyThereAreLeftAlone) {
  const auto before = traced_blocks({0, 20});
  const auto same = traced({}, february_2008, waves, settings_of(5 * photons_a_block), &before);
  EXPECT_EQ(same.done, before.done);
  EXPECT_EQ(same.sum[0](20, 1), before.sum[0](20, 1));
}

TEST(PhotonSums, OfTheSameBlocksAreRefused) {
  EXPECT_THROW(merged(traced_blocks({0, 10}), traced_blocks({9, 12})), algebra::Error);
}

TEST(PhotonSums, OfDifferentThingsAreRefused) {
  const auto one = traced_blocks({0, 1});
  auto other = traced_blocks({1, 2});
  other.key = "another";
  EXPECT_THROW(merged(one, other), algebra::Error);
  other = traced_blocks({1, 2});
  other.wavelengths_nm[0] += 1;
  EXPECT_THROW(merged(one, other), algebra::Error);
}

TEST(PhotonSums, HaveTheMeanOfTheirBlocksAndTheErrorOfIt) {
  // By hand: eight blocks in one ring of 1 km, seven bring 0 and one 8 · 1024 · 1e6 π m².
  PhotonSums sums;
  sums.arrangement = {1e11, {1e8}};
  sums.wavelengths_nm = {550};
  sums.ring_width_m = 1e3;
  sums.rings = 1;
  sums.done = {{0, 8}};
  const double light = 8 * 1024 * 1e6 * std::acos(-1.);
  sums.sum = {algebra::Grid<double>(1, 1, light)};
  sums.sum_of_squares = {algebra::Grid<double>(1, 1, light * light)};
  const auto found = estimated(sums);
  const double spread = 1.001 * 1.001;
  EXPECT_WITHIN_RELATIVE(found.ratio[0](0, 0), spread, 1e-14, "the mean is 1 · 1024 · area");
  EXPECT_WITHIN_RELATIVE(found.standard_error[0](0, 0), spread, 1e-14,
                         "variance (64 − 8)/7 = 8, over 8 blocks: 1");
}

TEST(BlockRange, OfPhotonsIsRoundedUp) {
  EXPECT_EQ(blocks_of(1), (BlockRange{0, 1}));
  EXPECT_EQ(blocks_of(1024), (BlockRange{0, 1}));
  EXPECT_EQ(blocks_of(1025), (BlockRange{0, 2}));
}

TEST(Shards, AreAllTheBlocksAndNoneTwice) {
  std::uint64_t next = 5;
  for (std::uint64_t part = 1; part <= 7; ++part) {
    const auto blocks = shard({5, 29}, part, 7);
    EXPECT_EQ(blocks.from, next);
    EXPECT_GE(blocks.to - blocks.from, 3U);
    EXPECT_LE(blocks.to - blocks.from, 4U);
    next = blocks.to;
  }
  EXPECT_EQ(next, 29U);
  EXPECT_THROW(shard({0, 10}, 0, 3), algebra::Error);
  EXPECT_THROW(shard({0, 10}, 4, 3), algebra::Error);
}

}  // namespace
}  // namespace coppermoon::shadow
