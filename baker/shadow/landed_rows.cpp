// SPDX-License-Identifier: MIT
#include "shadow/landed_rows.h"

#include <algorithm>
#include <array>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/landed_rows.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace coppermoon::shadow::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Moments of one part of the limb at a node (LandedLight::sums), or at the part's nearest node if it lacks this one.
inline const double* row_at(const LandedLight& part, int node) {
  const int place = std::clamp(node, part.first(), part.last()) - part.first();
  return part.sums() + static_cast<std::size_t>(place) * moments * lanes;
}

/// Adds the moments (LandedLight) of all parts of the limb at one node to the sums of several harmonics at once.
template <std::size_t together>
void add_node(std::span<const double* const> rows, const HarmonicRows* harmonics,
              std::size_t factor, std::size_t terms) {
  const hn::CappedTag<double, lanes> d;
  const std::size_t width = hn::Lanes(d);
  for (std::size_t lane = 0; lane < lanes; lane += width) {
    std::array<std::array<hn::Vec<decltype(d)>, moments>, together> light;
    for (auto& of_harmonic : light) of_harmonic.fill(hn::Zero(d));
    for (std::size_t p = 0; p < rows.size(); ++p) {
      const double* row = rows[p] + lane;
      const auto a = hn::LoadU(d, row), b = hn::LoadU(d, row + lanes),
                 c = hn::LoadU(d, row + 2 * lanes);
      for (std::size_t h = 0; h < together; ++h) {
        const auto weight = hn::Set(d, harmonics[h].weights[p]);
        light[h][0] = hn::MulAdd(weight, a, light[h][0]);
        light[h][1] = hn::MulAdd(weight, b, light[h][1]);
        light[h][2] = hn::MulAdd(weight, c, light[h][2]);
      }
    }
    for (std::size_t h = 0; h < together; ++h) {
      const double* by = harmonics[h].factors + factor;
      double* sum = harmonics[h].sums + lane;
      for (std::size_t term = 0; term < terms; ++term, by += moments, sum += lanes) {
        const auto first = hn::MulAdd(hn::Set(d, by[0]), light[h][0], hn::LoadU(d, sum)),
                   second = hn::MulAdd(hn::Set(d, by[1]), light[h][1], first);
        hn::StoreU(hn::MulAdd(hn::Set(d, by[2]), light[h][2], second), d, sum);
      }
    }
  }
}

void add_weighted(std::span<const LandedLight> parts, std::span<const int> nodes, std::size_t terms,
                  std::span<const HarmonicRows> harmonics) {
  constexpr std::size_t together = 4;
  static_assert(moments == 3);
  std::vector<const double*> rows(parts.size());
  std::size_t factor = 0;
  for (const int node : nodes) {
    for (std::size_t p = 0; p < parts.size(); ++p) rows[p] = row_at(parts[p], node);
    std::size_t h = 0;
    for (; h + together <= harmonics.size(); h += together)
      add_node<together>(rows, &harmonics[h], factor, terms);
    for (; h < harmonics.size(); ++h) add_node<1>(rows, &harmonics[h], factor, terms);
    factor += terms * moments;
  }
}

/// Does the work of turn_factors for some columns of the factors, beginning with number `column`.
template <std::size_t columns>
void turn_columns(const algebra::Grid<double>& factors, std::size_t column, const double* turns,
                  double* turned) {
  const hn::CappedTag<double, angles_together> d;
  const std::size_t width = hn::Lanes(d), apart = factors.columns();
  const double* first = factors.values().data() + column;
  for (std::size_t angle = 0; angle < angles_together; angle += width) {
    std::array<hn::Vec<decltype(d)>, columns> sums;
    for (auto& sum : sums) sum = hn::Zero(d);
    const double *factor = first, *turn = turns + angle;
    for (std::size_t m = 0; m < factors.rows(); ++m, factor += apart, turn += angles_together) {
      const auto by = hn::LoadU(d, turn);
      for (std::size_t i = 0; i < columns; ++i)
        sums[i] = hn::MulAdd(hn::Set(d, factor[i]), by, sums[i]);
    }
    for (std::size_t i = 0; i < columns; ++i)
      hn::StoreU(sums[i], d, turned + (column + i) * angles_together + angle);
  }
}

void turn_all(const algebra::Grid<double>& factors, const std::vector<std::vector<double>>& turns,
              double* turned) {
  constexpr std::size_t at_once = 8;
  const std::size_t columns = factors.columns();
  for (std::size_t column = 0; column < columns;) {
    const bool many = column + at_once <= columns;
    for (std::size_t i = 0; i < turns.size(); ++i) {
      double* to = turned + i * columns * angles_together;
      if (many)
        turn_columns<at_once>(factors, column, turns[i].data(), to);
      else
        turn_columns<1>(factors, column, turns[i].data(), to);
    }
    column += many ? at_once : 1;
  }
}

void add_turned(const LandedLight& part, std::span<const int> nodes, const double* factors,
                std::size_t terms, double* sums) {
  const hn::CappedTag<double, lanes> d;
  const std::size_t width = hn::Lanes(d);
  for (std::size_t term = 0; term < terms; ++term, sums += angles_together * lanes)
    for (std::size_t lane = 0; lane < lanes; lane += width) {
      std::array<hn::Vec<decltype(d)>, angles_together> all;
      for (std::size_t i = 0; i < angles_together; ++i)
        all[i] = hn::LoadU(d, sums + i * lanes + lane);
      const double* factor = factors + term * moments * angles_together;
      for (const int node : nodes) {
        const double* row = row_at(part, node) + lane;
        for (std::size_t m = 0; m < moments; ++m) {
          const auto light = hn::LoadU(d, row + m * lanes);
          for (std::size_t i = 0; i < angles_together; ++i)
            all[i] = hn::MulAdd(hn::Set(d, factor[m * angles_together + i]), light, all[i]);
        }
        factor += terms * moments * angles_together;
      }
      for (std::size_t i = 0; i < angles_together; ++i)
        hn::StoreU(all[i], d, sums + i * lanes + lane);
    }
}

void cosines_of(std::span<double> angles) {
  const hn::CappedTag<double, nodes_together> d;
  for (std::size_t j = 0; j < angles.size(); j += hn::Lanes(d))
    hn::StoreU(hn::Cos(d, hn::LoadU(d, &angles[j])), d, &angles[j]);
}

/// Adds Σ weights(k, j) cos mψ_j to sums[k][m][lane]. Each lane of a vector sums over only some of the nodes j.
void add_lanes(std::span<const double> cosines, const algebra::Grid<double>& weights,
               std::size_t harmonics, double* sums) {
  const hn::CappedTag<double, nodes_together> d;
  const std::size_t width = hn::Lanes(d);
  for (std::size_t j = 0; j < cosines.size(); j += width) {
    const auto twice = hn::Mul(hn::Set(d, 2.), hn::LoadU(d, &cosines[j]));
    auto before = hn::LoadU(d, &cosines[j]), now = hn::Set(d, 1.);  // cos(−ψ) and cos 0, to start
    for (std::size_t m = 0; m < harmonics; ++m) {
      for (std::size_t k = 0; k < weights.rows(); ++k) {
        double* sum = sums + (k * harmonics + m) * nodes_together;
        hn::StoreU(hn::MulAdd(hn::LoadU(d, &weights.row(k)[j]), now, hn::LoadU(d, sum)), d, sum);
      }
      const auto next = hn::MulSub(twice, now, before);
      before = now;
      now = next;
    }
  }
}

}  // namespace coppermoon::shadow::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace coppermoon::shadow {

HWY_EXPORT(add_weighted);

void add_landed_rows(std::span<const LandedLight> parts, std::span<const int> nodes,
                     std::size_t terms, std::span<const HarmonicRows> harmonics) {
  HWY_DYNAMIC_DISPATCH(add_weighted)(parts, nodes, terms, harmonics);
}

HWY_EXPORT(turn_all);

void turn_factors(const algebra::Grid<double>& factors,
                  const std::vector<std::vector<double>>& turns, std::vector<double>& turned) {
  turned.resize(turns.size() * factors.columns() * angles_together);
  HWY_DYNAMIC_DISPATCH(turn_all)(factors, turns, turned.data());
}

HWY_EXPORT(add_turned);

void add_turned_rows(const LandedLight& part, std::span<const int> nodes, const double* factors,
                     std::size_t terms, double* sums) {
  HWY_DYNAMIC_DISPATCH(add_turned)(part, nodes, factors, terms, sums);
}

HWY_EXPORT(cosines_of);

void turn_into_cosines(std::span<double> angles) { HWY_DYNAMIC_DISPATCH(cosines_of)(angles); }

HWY_EXPORT(add_lanes);

void add_harmonics(std::span<const double> cosines, const algebra::Grid<double>& weights,
                   algebra::Grid<double>& harmonics) {
  std::vector<double> sums(weights.rows() * harmonics.columns() * nodes_together);
  HWY_DYNAMIC_DISPATCH(add_lanes)(cosines, weights, harmonics.columns(), sums.data());
  const double* lanes_of_sum = sums.data();
  for (double& value : harmonics.values())
    for (std::size_t i = 0; i < nodes_together; ++i) value += *lanes_of_sum++;
}

}  // namespace coppermoon::shadow
#endif
