// SPDX-License-Identifier: MIT
// Runs long work while other Python threads keep running. Ctrl-C ends the work; a callback receives its progress.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>
#include <utility>

#include "algebra/progress.h"

namespace coppermoon::python {

/// An optional Python function that receives the fraction of the work that is done.
using Callback = std::optional<pybind11::function>;

/// Runs work on another thread, without Python's lock. Twenty times a second the calling thread checks whether Ctrl-C
/// was pressed, and tells the callback how far the work has come. If Ctrl-C or the callback raises an exception, the
/// work ends when it next reports its progress, and the exception is then raised again.
///
/// Throws  whatever the work throws; error_already_set for an exception of Python
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

/// Reports the progress of a part of the work, which covers `from` to `to` of the whole, as progress of the whole.
inline algebra::Progress part_of(const algebra::Progress& whole, double from, double to) {
  return [=](double part) { whole(from + (to - from) * part); };
}

}  // namespace coppermoon::python
