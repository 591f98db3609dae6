// SPDX-License-Identifier: MIT
#include "surface/noise.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "surface/noise.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

#ifndef COPPERMOON_SURFACE_HASH
#define COPPERMOON_SURFACE_HASH
namespace coppermoon::surface {

/// What a hash multiplies by, coordinate by coordinate, and the seed.
inline constexpr std::array<std::uint64_t, 4> hash_factors{
    0x9E3779B97F4A7C15ULL, 0xBF58476D1CE4E5B9ULL, 0x94D049BB133111EBULL, 0xD6E8FEB86659FD93ULL};

/// The four values of each of a cube's eight corners, as whole numbers up to 65535.
using Corners = std::array<std::array<float, 4>, 8>;

inline Corners corners_of(const std::array<std::int32_t, 3>& at, std::uint32_t seed) {
  Corners corners;
  for (std::int32_t i = 0; i < 8; ++i) {
    const auto hash = hashed(at[0] + (i & 1), at[1] + (i >> 1 & 1), at[2] + (i >> 2), seed);
    for (std::size_t k = 0; k < 4; ++k)
      corners[static_cast<std::size_t>(i)][k] = static_cast<float>((hash >> (16 * k)) & 0xFFFF);
  }
  return corners;
}

/// The last cube that all points of a vector lay in.
struct Cube {
  std::array<std::int32_t, 3> at{INT32_MIN, 0, 0};
  Corners corners{};
};

struct Octave {
  float frequency;
  std::uint32_t seed;
  std::array<float, 4> amplitude;
};

}  // namespace coppermoon::surface
#endif

HWY_BEFORE_NAMESPACE();
namespace coppermoon::surface::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Single = hn::CappedTag<float, 16>;
using Whole = hn::RebindToSigned<Single>;
using Words = hn::RebindToUnsigned<Single>;
using Hashes = hn::Repartition<std::uint64_t, Single>;
using V = hn::Vec<Single>;

/// The sums of the corners' values so far.
using Sums = std::array<V, 4>;

#if HWY_TARGET != HWY_SCALAR  // of one lane all points lie in one cube

/// Half of the lanes each.
struct Hash {
  hn::Vec<Hashes> low, high;
};

HWY_INLINE hn::Vec<Hashes> times(hn::Vec<Hashes> a, std::uint64_t factor) {
  const Hashes d;
  const Words words;
  const auto low = hn::BitCast(words, hn::Set(d, factor & 0xFFFFFFFF)),
             high = hn::BitCast(words, hn::Set(d, factor >> 32));
  const auto a_low = hn::BitCast(words, a), a_high = hn::BitCast(words, hn::ShiftRight<32>(a));
  const auto across = hn::Add(hn::MulEven(a_high, low), hn::MulEven(a_low, high));
  return hn::Add(hn::MulEven(a_low, low), hn::ShiftLeft<32>(across));
}

HWY_INLINE Hash times(const Hash& a, std::uint64_t factor) {
  return {times(a.low, factor), times(a.high, factor)};
}

HWY_INLINE Hash each_xor(const Hash& a, const Hash& b) {
  return {hn::Xor(a.low, b.low), hn::Xor(a.high, b.high)};
}

/// Lanes 0, 2, … and 1, 3, …, so that no lane moves.
HWY_INLINE Hash words_of(hn::Vec<Whole> values) {
  const Hashes d;
  const auto all = hn::BitCast(d, values);
  return {hn::And(all, hn::Set(d, 0xFFFFFFFFULL)), hn::ShiftRight<32>(all)};
}

template <int bits>
HWY_INLINE Hash mixed(const Hash& a) {
  return {hn::Xor(a.low, hn::ShiftRight<bits>(a.low)),
          hn::Xor(a.high, hn::ShiftRight<bits>(a.high))};
}

/// Adds one corner's four values of 16 bits each.
HWY_INLINE void add_corner(const Hash& hash, V weight, Sums& sums) {
  const Hashes d;
  const Single single;
  const Whole whole;
  const auto low_half = hn::Set(d, 0xFFFFFFFFULL);
  const auto first = hn::BitCast(whole,
                                 hn::Or(hn::And(hash.low, low_half), hn::ShiftLeft<32>(hash.high))),
             second = hn::BitCast(
                 whole, hn::Or(hn::ShiftRight<32>(hash.low), hn::AndNot(low_half, hash.high)));
  const auto mask = hn::Set(whole, 0xFFFF);
  const auto value = [&](auto bits) { return hn::ConvertTo(single, hn::And(bits, mask)); };
  sums[0] = hn::MulAdd(weight, value(first), sums[0]);
  sums[1] = hn::MulAdd(weight, value(hn::ShiftRight<16>(first)), sums[1]);
  sums[2] = hn::MulAdd(weight, value(second), sums[2]);
  sums[3] = hn::MulAdd(weight, value(hn::ShiftRight<16>(second)), sums[3]);
}

/// As `hashed`, of eight corners whose coordinates they have in common.
HWY_INLINE void add_hashed(const std::array<hn::Vec<Whole>, 3>& at, std::uint32_t seed,
                           const std::array<V, 8>& weights, Sums& sums) {
  const Hashes d;
  const Whole whole;
  const auto one = hn::Set(whole, 1);
  const auto seeds = hn::Set(d, std::uint64_t{seed});
  for (std::size_t i = 0; i < 2; ++i) {
    const auto x = times(words_of(i == 0 ? at[0] : hn::Add(at[0], one)), hash_factors[0]);
    for (std::size_t j = 0; j < 2; ++j) {
      const auto y = mixed<29>(
          times(each_xor(x, words_of(j == 0 ? at[1] : hn::Add(at[1], one))), hash_factors[1]));
      for (std::size_t k = 0; k < 2; ++k) {
        const auto z = mixed<32>(
            times(each_xor(y, words_of(k == 0 ? at[2] : hn::Add(at[2], one))), hash_factors[2]));
        const Hash seeded{hn::Xor(z.low, seeds), hn::Xor(z.high, seeds)};
        add_corner(mixed<32>(times(seeded, hash_factors[3])), weights[i + 2 * j + 4 * k], sums);
      }
    }
  }
}

#endif

/// Noise of the points of one vector, x, y, z turned: the lattice away from the poles and the seam,
/// where its planes would show.
HWY_INLINE Sums noise_at(V x, V y, V z, const Octave& octave, Cube& cube) {
  const Single d;
  const Whole whole;
  const auto turned = [&](float a, float b, float c) {
    const auto sum =
        hn::MulAdd(hn::Set(d, a), x, hn::MulAdd(hn::Set(d, b), y, hn::Mul(hn::Set(d, c), z)));
    return hn::Mul(sum, hn::Set(d, octave.frequency));
  };
  const std::array p{turned(0.36F, 0.48F, -0.8F), turned(-0.8F, 0.6F, 0),
                     turned(0.48F, 0.64F, 0.6F)};
  std::array<hn::Vec<Whole>, 3> at{hn::Zero(whole), hn::Zero(whole), hn::Zero(whole)};
  std::array<V, 3> near{hn::Zero(d), hn::Zero(d), hn::Zero(d)}, far = near;
  bool alike = true, same = true;
  std::array<std::int32_t, 3> first{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto floor = hn::Floor(p[i]), t = hn::Sub(p[i], floor);
    far[i] = hn::Mul(hn::Mul(t, t), hn::NegMulAdd(hn::Set(d, 2), t, hn::Set(d, 3)));
    near[i] = hn::Sub(hn::Set(d, 1), far[i]);
    at[i] = hn::ConvertTo(whole, floor);
    first[i] = hn::GetLane(at[i]);
    alike = alike && hn::AllTrue(whole, hn::Eq(at[i], hn::Set(whole, first[i])));
    same = same && first[i] == cube.at[i];
  }
  std::array<V, 8> weights{near[0], near[0], near[0], near[0], near[0], near[0], near[0], near[0]};
  for (std::size_t i = 0; i < 8; ++i)
    weights[i] = hn::Mul((i & 1) != 0 ? far[0] : near[0],
                         hn::Mul((i & 2) != 0 ? far[1] : near[1], (i & 4) != 0 ? far[2] : near[2]));
  Sums sums{hn::Zero(d), hn::Zero(d), hn::Zero(d), hn::Zero(d)};
#if HWY_TARGET != HWY_SCALAR
  if (!alike) add_hashed(at, octave.seed, weights, sums);
#endif
  if (alike) {
    if (!same) cube = {first, corners_of(first, octave.seed)};
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t k = 0; k < 4; ++k)
        sums[k] = hn::MulAdd(weights[i], hn::Set(d, cube.corners[i][k]), sums[k]);
  }
  for (auto& sum : sums) sum = hn::MulSub(sum, hn::Set(d, 2.0F / 65535), hn::Set(d, 1));
  return sums;
}

void add_octave(const Directions& points, const Octave& octave, const Noise& sums) {
  const Single d;
  const std::size_t lanes = hn::Lanes(d), count = points.x.size();
  Cube cube;
  for (std::size_t i = 0; i < count; i += lanes) {
    const std::size_t here = std::min(lanes, count - i);
    const auto load = [&](std::span<const float> values) {
      if (here == lanes) return hn::LoadU(d, &values[i]);
      std::array<float, 16> last;
      last.fill(values[count - 1]);
      std::copy_n(&values[i], here, last.begin());
      return hn::LoadU(d, last.data());
    };
    const auto noise = noise_at(load(points.x), load(points.y), load(points.z), octave, cube);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto more = hn::Mul(noise[k], hn::Set(d, octave.amplitude[k]));
      if (here == lanes) {
        hn::StoreU(hn::Add(hn::LoadU(d, &sums[k][i]), more), d, &sums[k][i]);
        continue;
      }
      std::array<float, 16> last;
      hn::StoreU(more, d, last.data());
      for (std::size_t j = 0; j < here; ++j) sums[k][i + j] += last[j];
    }
  }
}

}  // namespace coppermoon::surface::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace coppermoon::surface {

std::uint64_t hashed(std::int32_t x, std::int32_t y, std::int32_t z, std::uint32_t seed) {
  std::uint64_t h = static_cast<std::uint32_t>(x) * hash_factors[0];
  h = (h ^ static_cast<std::uint32_t>(y)) * hash_factors[1];
  h = (h ^ h >> 29 ^ static_cast<std::uint32_t>(z)) * hash_factors[2];
  h = (h ^ h >> 32 ^ seed) * hash_factors[3];
  return h ^ h >> 32;
}

double unit_interval(std::uint64_t hash) { return static_cast<double>(hash >> 11) * 0x1p-53; }

HWY_EXPORT(add_octave);

void add_noise(const Directions& points, float frequency, const std::array<float, 4>& amplitude,
               const Noise& sums) {
  const auto seed = static_cast<std::uint32_t>(frequency * 16);
  HWY_DYNAMIC_DISPATCH(add_octave)(points, Octave{frequency, seed, amplitude}, sums);
}

}  // namespace coppermoon::surface
#endif
