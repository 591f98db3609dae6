// SPDX-License-Identifier: MIT
// A result of every kind of value.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algebra/described.h"
#include "algebra/grid.h"
#include "almanac/instant.h"

namespace coppermoon::result {

struct Wick {
  double height_mm = 2;
  std::optional<double> burnt{};
};

template <class Field>
void describe(Field&& is, const Wick& wick) {
  is.a("Wick", "What burns.");
  is("height_mm", wick.height_mm, algebra::Unit{"mm"}, "its height");
  is("burnt", wick.burnt, "share that is burnt");
}

struct Lamp {
  almanac::Instant lit = almanac::instant_from_utc("1503-07-27T20:21:45.678Z");
  algebra::Angle tilt = algebra::degrees(45);
  algebra::ByName<double> colours{{"red", 1}, {"blue", 0.25}};
  std::optional<double> soot{};
  std::optional<std::string> maker{};
  std::optional<Wick> wick{};
  std::vector<Wick> spares{{1, 0.5}, {3, {}}};
  std::vector<double> flicker{1, 2};
};

template <class Field>
void describe(Field&& is, const Lamp& lamp) {
  is.a("Lamp", "A lamp.");
  is("lit", lamp.lit, "when it was lit");
  is("tilt_deg", lamp.tilt, algebra::unit::degrees, "its tilt");
  is("kind", algebra::Word{"oil", {"oil", "gas"}}, "what it burns");
  is("colours", lamp.colours, "its light by colour");
  is("soot", lamp.soot, "soot; none of gas");
  is("maker", algebra::if_any(lamp.maker), "who made it");
  is("wick", lamp.wick, "its wick");
  is("spares", lamp.spares, "other wicks");
  is("flicker", lamp.flicker, "its light over time");
  is(
      "warm", [] { return true; }, "whether it is warm");
}

}  // namespace coppermoon::result
