// SPDX-License-Identifier: MIT
#include "wrappers/python/fields.h"
#include "wrappers/python/nouns.h"

namespace coppermoon::python {

void add_requests(py::module_& package) {
  add_class<uses::AirRegion>(
      package, "Region",
      "A part of the Earth's limb with air of its own: between two latitudes, or between two "
      "position angles. None: as the air has it.\n\n"
      ">>> coppermoon.Region(from_latitude=-90, to_latitude=0, dust_extinction=1e-5)\n"
      "Region(from_latitude=-90.0, to_latitude=0.0, dust_extinction=1e-05)");
  add_class<uses::Air>(
      package, "Air",
      "The Earth's air, term by term, as the command's options of these names have it. "
      "None: as the atmosphere has it.\n\n"
      ">>> coppermoon.Air(atmosphere='clear', ozone_du=280)\n"
      "Air(atmosphere='clear', ozone_du=280.0)");
  add_class<uses::LightRequest>(
      package, "Light",
      "How light is computed, as the command's options of these names have it. None: chosen "
      "so that the tolerance is met.\n\n"
      ">>> coppermoon.Light(tolerance=0.05)\n"
      "Light(tolerance=0.05)");
}

}  // namespace coppermoon::python
