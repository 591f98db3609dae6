// SPDX-License-Identifier: MIT
#include "colour/fourier.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <kissfft/kissfft.hh>
#include <vector>

namespace coppermoon::colour {
namespace {

void transform_rows(Spectrum& spectrum, Direction direction) {
  const kissfft<double> fft(spectrum.columns(), direction == Direction::back);
  tbb::parallel_for(std::size_t{0}, spectrum.rows(), [&](std::size_t r) {
    const auto row = spectrum.row(r);
    std::vector<std::complex<double>> out(row.size());
    fft.transform(row.data(), out.data());
    std::ranges::copy(out, row.begin());
  });
}

void transform_columns(Spectrum& spectrum, Direction direction) {
  const kissfft<double> fft(spectrum.rows(), direction == Direction::back);
  tbb::parallel_for(std::size_t{0}, spectrum.columns(), [&](std::size_t c) {
    std::vector<std::complex<double>> in(spectrum.rows()), out(spectrum.rows());
    for (std::size_t r = 0; r < in.size(); ++r) in[r] = spectrum(r, c);
    fft.transform(in.data(), out.data());
    for (std::size_t r = 0; r < out.size(); ++r) spectrum(r, c) = out[r];
  });
}

}  // namespace

std::size_t quick_length(std::size_t length) {
  for (;; ++length) {
    std::size_t rest = length;
    for (const std::size_t prime : {2, 3, 5})
      while (rest % prime == 0) rest /= prime;
    if (rest == 1) return length;
  }
}

void fourier_transform(Spectrum& spectrum, Direction direction) {
  transform_rows(spectrum, direction);
  transform_columns(spectrum, direction);
}

}  // namespace coppermoon::colour
