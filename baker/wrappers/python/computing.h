// SPDX-License-Identifier: MIT
// Work that takes long: other threads of Python run on meanwhile, Ctrl-C ends it, a callback hears of it.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>
#include <utility>

#include "algebra/progress.h"

namespace coppermoon::python {

/// Function of Python that hears how far the work is; or none.
using Callback = std::optional<pybind11::function>;

/// Runs work on another thread, without Python's lock. The calling thread looks twenty times a second whether Ctrl-C
/// was pressed, and tells the callback how far the work is; what either raises ends the work when it next
/// tells its progress, and is raised then.
///
/// Throws  what the work throws; error_already_set
void run(const Callback& callback, const std::function<void(const algebra::Progress&)>& work);

/// Value that a function returns, called through `run`.
///
/// Given  work  function of an algebra::Progress; must not use Python objects
template <class Work>
auto computed(const Callback& callback, Work&& work) {
  std::optional<decltype(work(algebra::Progress{}))> made;
  run(callback, [&](const algebra::Progress& progress) { made.emplace(work(progress)); });
  return std::move(*made);
}

/// Progress of one part of several, of the whole.
inline algebra::Progress part_of(const algebra::Progress& whole, double from, double to) {
  return [=](double part) { whole(from + (to - from) * part); };
}

}  // namespace coppermoon::python
