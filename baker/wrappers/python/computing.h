// SPDX-License-Identifier: MIT
// Runs long work without blocking other Python threads. Ctrl-C ends the work, and a callback receives its progress.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>
#include <utility>

#include "algebra/progress.h"

namespace coppermoon::python {

/// An optional Python function that receives the fraction of the work that is done.
using Callback = std::optional<pybind11::function>;

/// Runs work on another thread, without holding Python's global lock. Twenty times a second, the calling thread checks
/// whether Ctrl-C was pressed, and tells the callback how far the work has come. If Ctrl-C or the callback raises an
/// exception, the work ends when it next reports its progress, and the exception is then raised again.
///
/// Throws  whatever the work throws, or error_already_set after an exception in Python
void run(const Callback& callback, const std::function<void(const algebra::Progress&)>& work);

/// Calls a function through `run` and returns its value.
///
/// Given  work  a function that takes an algebra::Progress; it must not use Python objects
template <class Work>
auto computed(const Callback& callback, Work&& work) {
  std::optional<decltype(work(algebra::Progress{}))> made;
  run(callback, [&](const algebra::Progress& progress) { made.emplace(work(progress)); });
  return std::move(*made);
}

/// Progress function for a part of the work. The part's fractions 0 to 1 are reported to `whole` as `from` to `to`.
inline algebra::Progress part_of(const algebra::Progress& whole, double from, double to) {
  return [=](double part) { whole(from + (to - from) * part); };
}

}  // namespace coppermoon::python
