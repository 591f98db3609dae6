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

struct PlotAxis {
  std::string label{};
  std::optional<std::pair<double, double>> range{};  ///< if absent, fitted to the curves
  bool logarithmic = false, reversed = false;
  double tic_spacing = 0;  ///< if 0, chosen by gnuplot
  std::string unit{};      ///< written after the number at each tic
};

/// Data drawn in one style. A curve without rows appears only in the key. A curve without a title is not in the key.
struct PlotCurve {
  std::string rows;  ///< comma-separated columns; an empty row leaves a gap in the line
  std::string look;  ///< gnuplot style such as "lines lw 2 lc rgb 'red'"
  std::string title{};
};

/// A labelled mark at a position on the x axis.
struct PlotMark {
  enum Kind {
    edge,     ///< dashed vertical line with the name written along it
    instant,  ///< line through all panels, with the name above
    band      ///< shading up to `end`, with the name at the bottom
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
  int title_size = 12;              ///< [points]
  int width = 1000, height = 640;   ///< [pixels]; in PDF, 40 pixels are 1 cm
  PlotAxis x{};                     ///< shared by all panels
  std::vector<PlotPanel> panels{};  ///< one panel, or two stacked vertically
  std::vector<PlotMark> marks{};
  std::string key = "off";      ///< position of the key, in gnuplot's words, such as "top left"
  std::string grid = "lt 0";    ///< line style of the grid, in gnuplot's words; "lt 0" is dotted
  double margin = 0;            ///< space around the curves, as a fraction of the plot
  double height_per_width = 0;  ///< aspect ratio of a panel; if 0, the panel fills the space
};

struct PlotFile : files::Ending {
  std::string (*terminal)(const Plot& plot);  ///< returns gnuplot's terminal and its settings
};

std::span<const PlotFile> plot_files();

/// Draws a plot with gnuplot. If drawing fails, no partial file is left behind.
///
/// Given   file   a file whose ending is one of those in plot_files()
/// Throws  Error  if the file has another ending, or if gnuplot is missing or fails
void write_plot(const std::filesystem::path& file, const Plot& plot);

/// Checks that a file name has the ending of a plot or, if tables are allowed, of a table.
///
/// Given   what   name, for the message, of what will be written, such as "a curve"
/// Throws  Error  unless the ending is one of those in plot_files() or, with `or_table`, is .csv
void require_plot_ending(const std::filesystem::path& file, std::string_view what, bool or_table);

}  // namespace coppermoon::uses
