// SPDX-License-Identifier: MIT
#include "wrappers/python/computing.h"

#include <atomic>
#include <chrono>
#include <exception>
#include <future>

namespace coppermoon::python {
namespace {

namespace py = pybind11;

/// The exception that ends the work early. It is not a Python exception, because it passes through threads and
/// libraries that know nothing of Python.
struct Stopped {};

}  // namespace

void run(const Callback& callback, const std::function<void(const algebra::Progress&)>& work) {
  std::atomic<bool> stop = false;
  std::atomic<double> done = 0;
  const algebra::Progress progress = [&](double part) {
    if (stop) throw Stopped();
    done = part;
  };
  std::exception_ptr raised;
  {
    const py::gil_scoped_release others_run;
    auto ended = std::async(std::launch::async, [&] { work(progress); });
    while (ended.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready) {
      const py::gil_scoped_acquire lock;
      try {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (callback) (*callback)(done.load());
      } catch (const py::error_already_set&) {
        raised = std::current_exception();
        stop = true;
        break;
      }
    }
    try {
      ended.get();
    } catch (const Stopped&) {
    } catch (...) {
      if (!raised) throw;
    }
  }
  if (raised) std::rethrow_exception(raised);
  if (callback) (*callback)(1.);
}

}  // namespace coppermoon::python
