// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "support/csv_rows.h"
#include "support/program.h"

namespace coppermoon::end_to_end::tradeoff_test {

using Row = std::map<std::string, std::string>;

const Words quick = "tradeoff --quick --albedo-map built-in -o measured";

/// In air of one column, a tenth as dear as that of a date.
const Words quickest = quick + "--atmosphere undated";

class Tradeoff : public ProgramTest {
 protected:
  std::vector<Row> measured(const Words& words) const {
    expect_done(coppermoon(words));
    return csv_rows(text_of(here("measured/tradeoff.csv")));
  }
};

/// One column of a sweep.
std::vector<double> column(const std::vector<Row>& rows, const std::string& solver,
                           const std::string& varied, const std::string& name) {
  std::vector<double> values;
  for (const auto& row : rows)
    if (row.at("solver") == solver && row.at("varied") == varied)
      values.push_back(std::stod(row.at(name)));
  return values;
}

void expect_falling(const std::vector<double>& errors, double share, const char* why) {
  ASSERT_GE(errors.size(), 3U);
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_LT(errors[i], share * errors[i - 1]) << why;
}

using TradeoffThoroughly = Tradeoff;

TEST_F(TradeoffThoroughly, MeasuresEverySolverAndEveryErrorFallsAsItIsPaidFor) {
  const auto rows = measured(quick);
  EXPECT_EQ(listing(),
            std::set<std::string>({"here/measured", "here/measured/tradeoff.csv",
                                   "here/measured/tradeoff.md", "here/measured/tradeoff.svg"}));
  const auto plot = text_of(here("measured/tradeoff.svg"));
  EXPECT_SAYS(plot, "</svg>");
  EXPECT_SAYS_NOT(plot, " & ") << "gnuplot leaves it bare, which is no XML";
  for (const auto& row : rows)
    for (const auto& [name, cell] : row) {
      if (name == "solver" || name == "varied" || name == "extrapolated" || cell.empty()) continue;
      EXPECT_TRUE(std::isfinite(std::stod(cell)) && std::stod(cell) >= 0) << name << " " << cell;
    }
  const auto errors = [&](const char* solver, const char* varied, const char* of) {
    return column(rows, solver, varied, of);
  };
  constexpr auto ten =
                     "each value has ten times the photons of the one before or more, so a third "
                     "of its noise; some hundred cells know that to a tenth",
                 heavy = "a third of the noise, which few bright cells dominate",
                 noiseless =
                     "the quadrature has no noise, and its error falls as the square of "
                     "its spacing";
  expect_falling(errors("photons by table", "photons", "umbra_rms"), 0.4, ten);
  expect_falling(errors("photons by table", "photons", "delta_e_mean"), 1, ten);
  expect_falling(errors("photons literal", "photons", "umbra_rms"), 0.7, heavy);
  for (const char* of : {"umbra_rms", "penumbra_rms", "delta_e_mean"}) {
    expect_falling(errors("quadrature", "rays", of), 0.5, noiseless);
    expect_falling(errors("quadrature", "wavelengths", of), 0.5, noiseless);
  }
  expect_falling(errors("quadrature", "texture width", "delta_e_mean"), 1,
                 "against the widest, whose own is 0");
  EXPECT_LT(errors("quadrature", "rays", "umbra_worst").back(), 0.01) << "300 rays";
}

/// In the air of a date, whose tables take seconds: they stand out from what timing errs by.
TEST_F(TradeoffThoroughly, ExtrapolatesWhatWouldTakeTooLong) {
  const auto rows = measured(quick + "--only 'photons literal' --longest 0");
  const auto photons = column(rows, "photons literal", "photons", "photons"),
             seconds = column(rows, "photons literal", "photons", "seconds"),
             errors = column(rows, "photons literal", "photons", "umbra_rms");
  ASSERT_EQ(photons.size(), 3U);
  EXPECT_EQ(rows.size(), 6U) << "no other solver's";
  for (std::size_t i = 1; i < 3; ++i) {
    const double more = photons[i] / photons[0];
    EXPECT_EQ(rows[i].at("extrapolated"), "true");
    EXPECT_WITHIN_RELATIVE(errors[i] / errors[0], 1 / std::sqrt(more), 1e-3,
                           "written to four digits");
  }
  EXPECT_WITHIN_RELATIVE((seconds[2] - seconds[0]) / (seconds[1] - seconds[0]),
                         (photons[2] - photons[0]) / (photons[1] - photons[0]), 5e-3,
                         "a straight line; differences of what is written to four digits");
  EXPECT_EQ(rows[0].at("extrapolated"), "false");
  EXPECT_SAYS(text_of(here("measured/tradeoff.md")), "| extrapolated |");
}

TEST_F(TradeoffThoroughly, LeavesNothingWhereThereIsNoRoom) {
  const auto full = coppermoon(quickest + "--only quadrature", {.file_limit = 500});
  EXPECT_EQ(full.status, 1);
  EXPECT_EQ(std::count(full.err.begin(), full.err.end(), '\n'), 1) << full.err;
  EXPECT_TRUE(listing().empty()) << "the table has more than 500 bytes";
}

TEST_F(TradeoffThoroughly, KeepsTheTablesWhenThePlotCannotBeDrawn) {
  const auto plotless = coppermoon(quickest + "--only quadrature", {.path = "/nowhere"});
  EXPECT_EQ(plotless.status, 1);
  EXPECT_SAYS(plotless.err, "gnuplot");
  EXPECT_EQ(listing(), std::set<std::string>({"here/measured", "here/measured/tradeoff.csv",
                                              "here/measured/tradeoff.md"}));
}

TEST_F(Tradeoff, SaysItsRowsAsOneDocument) {
  const auto outcome = coppermoon(quickest + "--only quadrature --json");
  expect_done(outcome);
  const auto said = nlohmann::json::parse(outcome.out, nullptr, false);
  const auto written = csv_rows(text_of(here("measured/tradeoff.csv")));
  ASSERT_TRUE(said.is_array());
  ASSERT_EQ(said.size(), written.size());
  for (std::size_t i = 0; i < said.size(); ++i) {
    EXPECT_TRUE(said[i]["photons"].is_null()) << "the quadrature has none";
    EXPECT_EQ(said[i]["extrapolated"], false);
    for (const char* name : {"seconds", "umbra_rms", "delta_e_99"})
      EXPECT_WITHIN_RELATIVE(said[i][name].get<double>(), std::stod(written[i].at(name)), 1e-3,
                             "written to four digits");
  }
}

TEST_F(Tradeoff, RefusesAFolderThatCannotBeAndASolverThereIsNot) {
  EXPECT_EQ(coppermoon("tradeoff --quick -o no/such/folder").status, 1);
  file("taken", "");
  EXPECT_EQ(coppermoon("tradeoff --quick -o taken").status, 1);
  EXPECT_EQ(coppermoon("tradeoff --quick --only guessing -o x").status, 2);
  EXPECT_EQ(coppermoon("tradeoff --quick").status, 2);
  EXPECT_EQ(listing(), std::set<std::string>({"here/taken"}));
}

}  // namespace coppermoon::end_to_end::tradeoff_test
