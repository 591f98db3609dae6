// SPDX-License-Identifier: MIT
#include "shadow/weighted_rows.h"

#include <algorithm>
#include <array>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/weighted_rows.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace coppermoon::shadow::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void add_rows(const double* rows, std::size_t nodes, const double* factors, std::size_t stride,
              double* sums) {
  const hn::CappedTag<double, lanes> d;
  const std::size_t width = hn::Lanes(d);
  for (std::size_t lane = 0; lane < lanes; lane += width) {
    auto a = hn::Load(d, sums + lane), b = hn::Zero(d), c = hn::Zero(d);
    const double *row = rows + lane, *factor = factors;
    for (std::size_t i = 0; i < nodes; ++i, row += moments * lanes, factor += stride) {
      a = hn::MulAdd(hn::Set(d, factor[0]), hn::LoadU(d, row), a);
      b = hn::MulAdd(hn::Set(d, factor[1]), hn::LoadU(d, row + lanes), b);
      c = hn::MulAdd(hn::Set(d, factor[2]), hn::LoadU(d, row + 2 * lanes), c);
    }
    hn::Store(hn::Add(a, hn::Add(b, c)), d, sums + lane);
  }
}

void add_at(const double* rows, int first, int last, std::span<const int> nodes, double factor,
            double* sums) {
  const hn::CappedTag<double, lanes> d;
  const std::size_t width = hn::Lanes(d);
  const auto weight = hn::Set(d, factor);
  for (const int node : nodes) {
    const double* row =
        rows + static_cast<std::size_t>(std::clamp(node, first, last) - first) * moments * lanes;
    for (std::size_t i = 0; i < moments * lanes; i += width, sums += width)
      hn::StoreU(hn::MulAdd(weight, hn::LoadU(d, row + i), hn::LoadU(d, sums)), d, sums);
  }
}

/// So many columns from one on, of all angles.
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

void add_turned(const double* rows, int first, int last, std::span<const int> nodes,
                const double* factors, std::size_t terms, double* sums) {
  const hn::CappedTag<double, lanes> d;
  const std::size_t width = hn::Lanes(d);
  for (std::size_t term = 0; term < terms; ++term, sums += angles_together * lanes)
    for (std::size_t lane = 0; lane < lanes; lane += width) {
      std::array<hn::Vec<decltype(d)>, angles_together> all;
      for (std::size_t i = 0; i < angles_together; ++i)
        all[i] = hn::LoadU(d, sums + i * lanes + lane);
      const double* factor = factors + term * moments * angles_together;
      for (const int node : nodes) {
        const double* row =
            rows +
            static_cast<std::size_t>(std::clamp(node, first, last) - first) * moments * lanes +
            lane;
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

/// sums[k][m][lane], each lane its share of the nodes.
void add_lanes(std::span<const double> cosines, const algebra::Grid<double>& weights,
               std::size_t harmonics, double* sums) {
  const hn::CappedTag<double, nodes_together> d;
  const std::size_t width = hn::Lanes(d);
  for (std::size_t j = 0; j < cosines.size(); j += width) {
    const auto twice = hn::Mul(hn::Set(d, 2.), hn::LoadU(d, &cosines[j]));
    auto before = hn::LoadU(d, &cosines[j]), now = hn::Set(d, 1.);  // cos(−ψ), cos 0
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

HWY_EXPORT(add_rows);

void add_weighted_rows(const double* rows, std::size_t nodes, const double* factors,
                       std::size_t stride, double* sums) {
  HWY_DYNAMIC_DISPATCH(add_rows)(rows, nodes, factors, stride, sums);
}

HWY_EXPORT(add_at);

void add_rows_at(const double* rows, int first, int last, std::span<const int> nodes, double factor,
                 double* sums) {
  HWY_DYNAMIC_DISPATCH(add_at)(rows, first, last, nodes, factor, sums);
}

HWY_EXPORT(turn_all);

void turn_factors(const algebra::Grid<double>& factors,
                  const std::vector<std::vector<double>>& turns, std::vector<double>& turned) {
  turned.resize(turns.size() * factors.columns() * angles_together);
  HWY_DYNAMIC_DISPATCH(turn_all)(factors, turns, turned.data());
}

HWY_EXPORT(add_turned);

void add_turned_rows(const double* rows, int first, int last, std::span<const int> nodes,
                     const double* factors, std::size_t terms, double* sums) {
  HWY_DYNAMIC_DISPATCH(add_turned)(rows, first, last, nodes, factors, terms, sums);
}

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
