// SPDX-License-Identifier: MIT
// The extension module coppermoon._coppermoon. The package exports its names through coppermoon/__init__.py.
#include "algebra/error.h"
#include "wrappers/python/arguments.h"
#include "wrappers/python/nouns.h"

PYBIND11_MODULE(_coppermoon, package) {
  using namespace coppermoon;
  pybind11::options options;
  options.disable_function_signatures();  // our docstrings begin with their own signatures
  package.attr("__version__") = COPPERMOON_VERSION;
  pybind11::register_exception<algebra::Error>(package, "Error", PyExc_ValueError).doc() =
      "Wrong input, in one line: the value, its unit, what is allowed.";
  python::add_eclipses(package);
  python::add_sky(package);
  python::add_requests(package);
  python::add_shadow(package);
  python::add_moonlight(package);
  python::add_bake(package);
  python::add_brightness(package);
  python::add_dome(package);
  python::add_fit(package);
}
