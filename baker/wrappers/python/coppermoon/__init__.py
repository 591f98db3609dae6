# SPDX-License-Identifier: MIT
"""Eclipsed Moons: sunlight bent, reddened and dimmed by the Earth's air, in real units.

A moment is given as a datetime with a time zone, NumPy's datetime64 in UTC, or an ISO 8601 text, which is in UTC unless
it ends in an offset. A day alone, as a date or a text, stands for its greatest eclipse. A text can also name a day and
a contact, such as '2018-07-27 U2+10min'. Names of arguments end in their unit, and wavelengths are in nanometres.
Arrays are NumPy's. Long computations let other threads run, end on Ctrl-C, and take a callback `progress`. Wrong input
raises Error, a subclass of ValueError.

>>> import coppermoon
>>> eclipse = coppermoon.nearest_eclipse('2018-07-27')
>>> eclipse.type
'total'
"""
from ._coppermoon import (Air, Brightness, BrightnessSeen, ClippedAt, Clock, Dome, Eclipse, Error, Estimate, Fit, Light,
                          Misfit, Moonlight, Night, Photograph, PhotographRead, Region, ShadowProfile, Sky, Suspicion,
                          Texture, __version__, bake, brightness, dome, eclipses, fit, light_curve, moonlight,
                          nearest_eclipse, shadow_profile, sky)

__all__ = ["Air", "Brightness", "BrightnessSeen", "ClippedAt", "Clock", "Dome", "Eclipse", "Error", "Estimate", "Fit",
           "Light", "Misfit", "Moonlight", "Night", "Photograph", "PhotographRead", "Region", "ShadowProfile", "Sky",
           "Suspicion", "Texture", "__version__", "bake", "brightness", "dome", "eclipses", "fit", "light_curve",
           "moonlight", "nearest_eclipse", "shadow_profile", "sky"]

for _name in __all__:
    if isinstance(globals()[_name], type):
        globals()[_name].__module__ = __name__
