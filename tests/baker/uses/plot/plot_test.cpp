// SPDX-License-Identifier: MIT
#include "uses/plot/plot.h"

#include <sys/resource.h>
#include <csignal>

#include "support/helper_folder.h"
#include "support/left_behind.h"
#include "support/testing.h"

namespace coppermoon::uses::plot_test {

namespace fs = std::filesystem;

Plot line_named(const std::string& name) {
  return {.title = name,
          .x = {.label = name},
          .panels = {{{.label = name}, {{"0,0\n1,1\n", "lines", name}}}},
          .marks = {{PlotMark::edge, 0.5, name}},
          .key = "top left"};
}

class Plots : public HelperFolder {
 protected:
  std::string drawn(const Plot& plot) const {
    write_plot(here() / "a.svg", plot);
    std::ifstream in(here() / "a.svg");
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

TEST_F(Plots, HaveTheirWordsInThem) {
  const auto svg = drawn(line_named("Moon's \"light\" [W]"));
  std::size_t count = 0;
  for (std::size_t at = 0; (at = svg.find("Moon's \"light\" [W]", at)) != svg.npos; ++at) ++count;
  EXPECT_GE(count, 5U) << "title, two axes, the mark and the key\n" << svg.substr(0, 4000);
}

TEST_F(Plots, HaveATitleOfTwoLines) {
  const auto svg = drawn(line_named("above\nbelow"));
  EXPECT_SAYS(svg, ">above<");
  EXPECT_SAYS(svg, ">below<");
}

TEST_F(Plots, TakeNoWordForAnOrder) {
  const auto order = "touch " + (here() / "obeyed").string();
  for (const std::string& name :
       {"`" + order + "`", "'; system('" + order + "') #", "\"; system(\"" + order + "\") #",
        "\n!" + order, std::string("a\\")})
    drawn(line_named(name));
  EXPECT_FALSE(fs::exists(here() / "obeyed"));
}

TEST_F(Plots, HaveAPanelAboveAnother) {
  auto plot = line_named("one");
  plot.panels.push_back({{.label = "two", .logarithmic = true}, {{"1,1\n2,100\n", "linespoints"}}});
  const auto svg = drawn(plot);
  EXPECT_SAYS(svg, ">one<");
  EXPECT_SAYS(svg, ">two<");
}

TEST_F(Plots, EndInWhatGnuplotDraws) {
  EXPECT_EQ(refusal_of([] { write_plot("a.gif", line_named("x")); }),
            "a.gif: a plot ends in .png (plot), .svg (plot), .pdf (plot)");
  EXPECT_EQ(refusal_of([] { require_plot_ending("a.gif", "a curve", true); }),
            "a.gif: a curve ends in .csv (numbers), .png (plot), .svg (plot), .pdf (plot)");
  EXPECT_NO_THROW(require_plot_ending("a.csv", "a curve", true));
  for (const char* name : {"a.png", "a.pdf"}) {
    write_plot(here() / name, line_named("x"));
    EXPECT_GT(fs::file_size(here() / name), 1000U) << name;
  }
}

TEST_F(Plots, ThatGnuplotDoesNotDrawAreSaid) {
  stand_in("gnuplot", "exit 0");
  EXPECT_EQ(refusal_of([&] { write_plot(here() / "a.svg", line_named("x")); }),
            "gnuplot: ended without a result");
  EXPECT_FALSE(fs::exists(here() / "a.svg"));
}

/// gnuplot itself, which exits 0 when its file cannot grow.
TEST_F(Plots, OfAFullDiskReplaceNothing) {
  std::signal(SIGXFSZ, SIG_IGN);  // as in the program
  for (const char* name : {"a.png", "a.svg", "a.pdf"}) {
    std::ofstream(here() / name) << "old";
    rlimit before{};
    ::getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{2048, before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
    const auto said = refusal_of([&] { write_plot(here() / name, line_named("x")); });
    ::setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_EQ(said, "gnuplot: its file is cut off after 2048 bytes; is the disk full?") << name;
    EXPECT_EQ(fs::file_size(here() / name), 3U) << "the old one";
  }
}

TEST_F(Plots, ThatFailHaveTheFirstWord) {
  stand_in("gnuplot", "echo >&2; echo 'out of ink' >&2; echo end >&2; exit 1");
  EXPECT_EQ(refusal_of([&] { write_plot(here() / "a.svg", line_named("x")); }),
            "gnuplot: out of ink");
}

TEST_F(Plots, ThatHangAreNotLeftBehind) {
  stand_in("gnuplot",
           "cd " + here().string() + "; echo $$ > pid.tmp; mv pid.tmp pid; exec sleep 20");
  EXPECT_EQ(signal_after_our_death(here() / "pid",
                                   [&] { write_plot(here() / "a.svg", line_named("x")); }),
            SIGKILL);
}

}  // namespace coppermoon::uses::plot_test
