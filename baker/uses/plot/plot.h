// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/endings.h"

namespace coppermoon::uses {

/// A horizontal or vertical axis of a plot.
struct PlotAxis {
  std::string label{};
  std::optional<std::pair<double, double>> range{};  ///< if absent, as the curves need
  bool logarithmic = false, reversed = false;
  double tic_spacing = 0;  ///< 0: chosen by gnuplot
  std::string unit{};      ///< written after the number at each tic
};

/// Data drawn in one style. Without rows it appears only in the key; without a title, only in the plot.
struct PlotCurve {
  std::string rows;  ///< comma-separated columns; an empty row interrupts a line
  std::string look;  ///< in gnuplot's words: "lines lw 2 lc rgb 'red'"
  std::string title{};
};

/// Something that is marked along the x axis.
struct PlotMark {
  enum Kind {
    edge,     ///< dashed line with the name along it
    instant,  ///< line through all panels with the name above
    band      ///< shading up to `end` with the name at its foot
  } kind;
  double x;
  std::string name;
  double end = 0;
};

struct PlotPanel {
  PlotAxis y;
  std::vector<PlotCurve> curves;
};

struct Plot {
  std::string title{};
  int title_size = 12;              ///< points
  int width = 1000, height = 640;   ///< pixels; 40 to a centimetre in PDF
  PlotAxis x{};                     ///< shared by all panels
  std::vector<PlotPanel> panels{};  ///< one, or two above one another
  std::vector<PlotMark> marks{};
  std::string key = "off";      ///< its place in gnuplot's words: "top left"
  std::string grid = "lt 0";    ///< its lines in gnuplot's words: dotted
  double margin = 0;            ///< around the curves, as a share of the plot
  double height_per_width = 0;  ///< of the panel; 0: as it fits
};

/// A file format for plots.
struct PlotFile : files::Ending {
  std::string (*terminal)(const Plot& plot);  ///< gnuplot's terminal and its settings
};

/// All file formats for plots.
std::span<const PlotFile> plot_files();

/// Draws a plot with gnuplot. The file appears whole or not at all.
///
/// Given   file   with the ending of one of plot_files()
/// Throws  Error  for another ending; when gnuplot is missing or fails
void write_plot(const std::filesystem::path& file, const Plot& plot);

/// Refuses a file that is neither a plot nor, if that is allowed, a table.
///
/// Given   what   will be written, such as "a curve"
/// Throws  Error  when the path has no ending of plot_files() nor, with `or_table`, .csv
void require_plot_ending(const std::filesystem::path& file, std::string_view what, bool or_table);

}  // namespace coppermoon::uses
