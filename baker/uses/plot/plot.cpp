// SPDX-License-Identifier: MIT
#include "uses/plot/plot.h"

#include <fmt/format.h>

#include <array>

#include "files/child_process.h"
#include "files/temporary_folder.h"
#include "files/whole_file.h"

namespace coppermoon::uses {
namespace {

/// Quotes text as a gnuplot string. Characters that could end the string or run a shell command are made harmless.
std::string literal(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' || c == '\\' || c == '`' || c == '\n' ? fmt::format("\\{:03o}", int{c})
                                                             : std::string{c};
  return quoted + '"';
}

std::string png_terminal(const Plot& plot) {
  return fmt::format("pngcairo size {},{} font 'Sans,12'", plot.width, plot.height);
}

std::string svg_terminal(const Plot& plot) {
  return fmt::format("svg size {},{} background rgb 'white' font 'sans-serif,13'", plot.width,
                     plot.height);
}

std::string pdf_terminal(const Plot& plot) {
  return fmt::format("pdfcairo size {}cm,{}cm font 'Sans,14'", plot.width / 40., plot.height / 40.);
}

constexpr std::array formats_of_plots{PlotFile{{".png", "plot"}, png_terminal},
                                      PlotFile{{".svg", "plot"}, svg_terminal},
                                      PlotFile{{".pdf", "plot"}, pdf_terminal}};

/// Gnuplot commands that set up the axis `x` or `y`. Its tics have no numbers if the panel below shows them.
std::string axis(char name, const PlotAxis& axis, bool numbered = true) {
  std::string script =
      fmt::format("set {0}label {1}\n{2} logscale {0}\n", name, literal(numbered ? axis.label : ""),
                  axis.logarithmic ? "set" : "unset");
  script += fmt::format("set format {} {}\n", name,
                        literal(!numbered           ? ""
                                : axis.logarithmic  ? "10^{%L}"
                                : axis.unit.empty() ? "% h"
                                                    : "%g" + axis.unit));
  if (axis.tic_spacing > 0) script += fmt::format("set {}tics {:g}\n", name, axis.tic_spacing);
  if (axis.range)
    return script + fmt::format("set {}range [{:.8g}:{:.8g}]\n", name, axis.range->first,
                                axis.range->second);
  return script + fmt::format("set {}range [*:*] {}reverse\n", name, axis.reversed ? "" : "no");
}

std::string mark(const PlotMark& mark) {
  const auto at = fmt::format("first {:.8g},graph", mark.x), name = literal(mark.name);
  const auto arrow = fmt::format("set arrow from {0} 0 to {0} 1 nohead ", at);
  if (mark.kind == PlotMark::edge)
    return fmt::format(
        "{}dashtype 2 lc rgb '#707070'\n"
        "set label {} at {} 0.12 rotate by 90 left offset -1,0 tc rgb '#505050'\n",
        arrow, name, at);
  if (mark.kind == PlotMark::instant)
    return fmt::format("{}lc rgb '#bbbbbb'\nset label {} at {} 1.05 center font ',11'\n", arrow,
                       name, at);
  return fmt::format(
      "set object rectangle from {} 0 to first {:.8g},graph 1 behind fs solid noborder fc rgb "
      "'#eeeae2'\nset label {} at first {:.8g},graph 0.03 center tc rgb '#505050'\n",
      at, mark.end, name, (mark.x + mark.end) / 2);
}

/// Gnuplot script that defines the curves' data and plots them.
std::string curves(const std::vector<PlotCurve>& curves) {
  std::string data, order = "plot ";
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto& [rows, look, title] = curves[i];
    if (!rows.empty()) data += fmt::format("$c{} << EOD\n{}EOD\n", i, rows);
    order += fmt::format("{}{} with {} {}", i == 0 ? "" : ", ",
                         rows.empty() ? "keyentry" : fmt::format("$c{}", i), look,
                         title.empty() ? "notitle" : "title " + literal(title));
  }
  return data + order + "\n";
}

/// The gnuplot script for a plot, except for the choice of terminal and output.
std::string script(const Plot& plot) {
  std::string script = fmt::format(
      "set encoding utf8\nset datafile separator ','\nset grid {0}\nset key {1}\n"
      "set palette defined (0 '#c9ced6', 1 '#eceae4', 2 '#ffffff')\nset cbrange [0:2]\n"
      "unset colorbox\nset offsets graph {2:g}, graph {2:g}, graph {2:g}, 0\n",
      plot.grid, plot.key, plot.margin);
  for (const auto& one : plot.marks) script += mark(one);
  if (plot.height_per_width > 0)
    script += fmt::format("set size ratio {:g}\n", plot.height_per_width);
  const auto title = fmt::format("title {} font ',{}'", literal(plot.title), plot.title_size);
  if (plot.panels.size() == 1)
    return script + "set " + title + " noenhanced\n" + axis('x', plot.x) +
           axis('y', plot.panels[0].y) + curves(plot.panels[0].curves);
  script += "set multiplot " + title + "\nset lmargin 12\nset rmargin 4\n";
  script += "set origin 0, 0.47\nset size 1, 0.46\nset bmargin 1\nset tmargin 2\n" +
            axis('x', plot.x, false) + axis('y', plot.panels.at(0).y) +
            curves(plot.panels[0].curves);
  return script + "unset label\nset origin 0, 0\nset size 1, 0.49\nset bmargin 4\nset tmargin 1\n" +
         axis('x', plot.x) + axis('y', plot.panels.at(1).y) + curves(plot.panels[1].curves);
}

}  // namespace

std::span<const PlotFile> plot_files() { return formats_of_plots; }

void require_plot_ending(const std::filesystem::path& file, std::string_view what, bool or_table) {
  std::vector<files::Ending> allowed;
  if (or_table) allowed.push_back({".csv", "numbers"});
  allowed.insert(allowed.end(), formats_of_plots.begin(), formats_of_plots.end());
  files::format_of(file, allowed, what);
}

/// Runs gnuplot with -d, so that it ignores ~/.gnuplot. File names are kept out of the script, where they could be read
/// as commands.
void write_plot(const std::filesystem::path& file, const Plot& plot) {
  const auto& format = files::format_of(file, formats_of_plots, "a plot");
  const files::TemporaryFolder folder;
  files::write_whole(folder.path() / "plot.gp",
                     "set terminal " + format.terminal(plot) + "\n" + script(plot));
  files::write_whole(file, [&](const files::Handle& result) {
    files::run_program(
        {.words = {files::program_file("gnuplot", {"gnuplot.exe", "gnuplot/bin"}), "-d", "plot.gp"},
         .package = "gnuplot-nox",
         .folder = folder.path()},
        &result);
  });
}

}  // namespace coppermoon::uses
