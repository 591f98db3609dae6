// SPDX-License-Identifier: MIT
#include "shadow/photon_spectra.h"

#include "algebra/random.h"
#include "support/every_target.h"
#include "support/testing.h"

namespace coppermoon::shadow::photon_spectra_test {

using algebra::Grid;

constexpr std::size_t waves = 37;

Grid<float> random_rows(std::size_t rows, double least, double greatest) {
  algebra::Random random(3, rows);
  Grid<float> grid(rows, padded(waves));
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t w = 0; w < waves; ++w)
      grid(r, w) = static_cast<float>(least + (greatest - least) * random.uniform());
  return grid;
}

TEST(PhotonRows, LieBetweenTheirNeighbours) {
  const auto table = random_rows(2, -1e6, 1e6);
  support::on_every_target([&] {
    Grid<float> rows(1, padded(waves));
    const std::vector<Between> places{{table.row(0).data(), 0.25F, 2}};
    interpolate(places, rows);
    for (std::size_t w = 0; w < waves; ++w)
      EXPECT_WITHIN(rows(0, w), 2 * (0.75 * table(0, w) + 0.25 * table(1, w)), 1,
                    "single precision of 2e6");
    multiply(places, rows);
    for (std::size_t w = 0; w < waves; ++w)
      EXPECT_WITHIN_RELATIVE(rows(0, w), std::pow(1.5 * table(0, w) + 0.5 * table(1, w), 2), 1e-4,
                             "single precision, some of it lost where the two cancel");
  });
}

TEST(PhotonRows, GatherInTheRingAndSectorWhereTheyLand) {
  // Against row(), in double precision; a landing within 1e-4 of a border may fall either side, so
  // what is compared is the mean row of all light, and that none is lost.
  const std::size_t photons = 200;
  const auto landing_m = random_rows(photons, -6e6, 6e6);
  const auto light = random_rows(photons, 1, 2);
  for (const std::size_t sectors : {1U, 2U, 7U, 24U}) {
    const Rings rings{50e3F, 100, sectors};
    std::vector<Aside> asides;
    Tally expected(rings.rows(), waves);
    algebra::Random random(5, sectors);
    for (std::size_t i = 0; i < photons; ++i) {
      const double angle = 6.28 * random.uniform();
      asides.push_back({static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle)),
                        static_cast<float>(1e6 * random.uniform()),
                        static_cast<float>(-1e6 * random.uniform())});
      for (std::size_t w = 0; w < waves; ++w)
        expected.light(rings.row(landing_m(i, w) * asides[i].toward_x - asides[i].source_x_m,
                                 landing_m(i, w) * asides[i].toward_y - asides[i].source_y_m),
                       w) += light(i, w);
    }
    support::on_every_target([&] {
      Tally tally(rings.rows(), waves);
      gather(asides, landing_m, light, rings, 0, tally);
      std::size_t differ = 0;
      for (std::size_t row = 0; row < rings.rows(); ++row)
        for (std::size_t w = 0; w < waves; ++w)
          differ += std::abs(tally.light(row, w) - expected.light(row, w)) > 1e-3F;
      EXPECT_LE(differ, 8U) << "of 7400 landings, two rows for each that rounding moves";
    });
  }
}

TEST(PhotonRows, DrainAsSumsAndSquares) {
  support::on_every_target([] {
    Tally tally(3, waves);
    tally.light = random_rows(3, 0, 5);
    const auto light = tally.light;
    tally.touched = {1, 0, 1};
    Grid<double> sums(3, waves, 1), squares(3, waves, 2);
    drain(tally, sums, squares);
    for (std::size_t w = 0; w < waves; ++w) {
      const double x = light(2, w);
      EXPECT_EQ(sums(2, w), 1 + x);
      EXPECT_WITHIN_RELATIVE(squares(2, w), 2 + x * x, 1e-15, "one rounding or two");
      EXPECT_EQ(sums(1, w), 1) << "not touched";
      EXPECT_EQ(tally.light(0, w), 0);
    }
    EXPECT_EQ(tally.touched[2], 0);
  });
}

}  // namespace coppermoon::shadow::photon_spectra_test
