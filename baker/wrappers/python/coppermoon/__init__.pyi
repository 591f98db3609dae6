# SPDX-License-Identifier: MIT
from collections.abc import Callable, Iterable, Sequence
from datetime import datetime
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

Moment = datetime | str
Place = str | Sequence[float]
Progress = Callable[[float], object]

Convention = Literal["danjon", "danjon-oblate", "chauvenet", "herald-sinnott"]
Space = Literal["lin_rec709", "acescg", "lin_ciexyzd65_scene"]
Photometry = Literal["lommel-seeliger-rolo", "yapo-cutler"]
Stratosphere = Literal["dated", "none", "background", "moderate", "high", "extreme"] | float
MeasuredMagnitude = tuple[Moment, Literal["B", "V", "R"], float] | tuple[Moment, Literal["B", "V", "R"], float, float]

__version__: str

class Error(ValueError): ...

class Eclipse:
    @property
    def greatest(self) -> datetime: ...
    @property
    def type(self) -> Literal["penumbral", "partial", "total"]: ...
    @property
    def gamma(self) -> float: ...
    @property
    def umbral_magnitude(self) -> float: ...
    @property
    def penumbral_magnitude(self) -> float: ...
    @property
    def contacts(self) -> dict[str, datetime]: ...

def eclipses(
    start: Moment, stop: Moment, *, convention: Convention = "danjon", progress: Progress | None = None
) -> list[Eclipse]: ...
def nearest_eclipse(when: Moment, *, convention: Convention = "danjon") -> Eclipse: ...

class Sky:
    @property
    def when(self) -> datetime: ...
    @property
    def delta_t_s(self) -> float: ...
    @property
    def moon_ra_deg(self) -> float: ...
    @property
    def moon_dec_deg(self) -> float: ...
    @property
    def moon_distance_km(self) -> float: ...
    @property
    def sun_distance_au(self) -> float: ...
    @property
    def sub_earth_latitude_deg(self) -> float: ...
    @property
    def sub_earth_longitude_deg(self) -> float: ...
    @property
    def sub_solar_latitude_deg(self) -> float: ...
    @property
    def sub_solar_longitude_deg(self) -> float: ...
    @property
    def axis_position_angle_deg(self) -> float: ...
    @property
    def axis_distance_km(self) -> float: ...
    @property
    def sun_m(self) -> NDArray[np.float64]: ...
    @property
    def moon_m(self) -> NDArray[np.float64]: ...
    @property
    def selenographic_from_gcrs(self) -> NDArray[np.float64]: ...
    @property
    def altitude_deg(self) -> float | None: ...
    @property
    def azimuth_deg(self) -> float | None: ...
    @property
    def parallactic_angle_deg(self) -> float | None: ...
    @property
    def observer_moon_distance_km(self) -> float | None: ...
    @property
    def sub_observer_latitude_deg(self) -> float | None: ...
    @property
    def sub_observer_longitude_deg(self) -> float | None: ...

def sky(when: Moment, at: Place | None = None) -> Sky: ...

class _Column:
    @property
    def danjon(self) -> int | None: ...
    @property
    def ozone_du(self) -> float | None: ...
    @property
    def cloud_cover(self) -> float | None: ...
    @property
    def dust_extinction(self) -> float | None: ...
    @property
    def tropospheric_aerosol(self) -> float | None: ...
    @property
    def stratospheric_aerosol(self) -> Stratosphere | None: ...
    @property
    def free_troposphere(self) -> float | None: ...
    @property
    def cloud_chance(self) -> float | None: ...
    @property
    def cirrus(self) -> float | None: ...
    @property
    def tropopause_km(self) -> float | None: ...
    @property
    def cloud_top_km(self) -> float | None: ...
    @property
    def dust_bottom_km(self) -> float | None: ...
    @property
    def dust_top_km(self) -> float | None: ...

class Region(_Column):
    def __init__(
        self,
        *,
        from_latitude: float | None = None,
        to_latitude: float | None = None,
        from_position_angle: float | None = None,
        to_position_angle: float | None = None,
        danjon: int | None = None,
        ozone_du: float | None = None,
        cloud_cover: float | None = None,
        dust_extinction: float | None = None,
        tropospheric_aerosol: float | None = None,
        stratospheric_aerosol: Stratosphere | None = None,
        free_troposphere: float | None = None,
        cloud_chance: float | None = None,
        cirrus: float | None = None,
        tropopause_km: float | None = None,
        cloud_top_km: float | None = None,
        dust_bottom_km: float | None = None,
        dust_top_km: float | None = None,
    ) -> None: ...
    @property
    def from_latitude(self) -> float | None: ...
    @property
    def to_latitude(self) -> float | None: ...
    @property
    def from_position_angle(self) -> float | None: ...
    @property
    def to_position_angle(self) -> float | None: ...

class Air(_Column):
    def __init__(
        self,
        *,
        atmosphere: Literal["standard", "monthly", "undated", "clear", "molecular", "paper", "none"] = "standard",
        earth: Literal["sphere", "ellipsoid"] | None = None,
        density: Literal["seasonal", "us-1976", "yapo-cutler"] | None = None,
        refraction: bool = True,
        dispersion: Literal["ciddor", "crc"] | None = None,
        rayleigh: bool = True,
        king_factor: Literal["bates", "fixed"] | None = None,
        ozone_path: Literal["bent", "filter"] | None = None,
        ozone_profile: Literal["climatology", "us-1976"] | None = None,
        oxygen_pairs: bool | None = None,
        nitrogen_dioxide: bool | None = None,
        danjon: int | None = None,
        ozone_du: float | None = None,
        cloud_cover: float | None = None,
        dust_extinction: float | None = None,
        tropospheric_aerosol: float | None = None,
        stratospheric_aerosol: Stratosphere | None = None,
        free_troposphere: float | None = None,
        cloud_chance: float | None = None,
        cirrus: float | None = None,
        tropopause_km: float | None = None,
        cloud_top_km: float | None = None,
        dust_bottom_km: float | None = None,
        dust_top_km: float | None = None,
        regions: list[Region] = [],
    ) -> None: ...
    @property
    def atmosphere(self) -> Literal["standard", "monthly", "undated", "clear", "molecular", "paper", "none"]: ...
    @property
    def earth(self) -> Literal["sphere", "ellipsoid"] | None: ...
    @property
    def density(self) -> Literal["seasonal", "us-1976", "yapo-cutler"] | None: ...
    @property
    def refraction(self) -> bool: ...
    @property
    def dispersion(self) -> Literal["ciddor", "crc"] | None: ...
    @property
    def rayleigh(self) -> bool: ...
    @property
    def king_factor(self) -> Literal["bates", "fixed"] | None: ...
    @property
    def ozone_path(self) -> Literal["bent", "filter"] | None: ...
    @property
    def ozone_profile(self) -> Literal["climatology", "us-1976"] | None: ...
    @property
    def oxygen_pairs(self) -> bool | None: ...
    @property
    def nitrogen_dioxide(self) -> bool | None: ...
    @property
    def regions(self) -> list[Region]: ...

class Light:
    def __init__(
        self,
        *,
        tolerance: float | None = 0.01,
        budget_s: float | None = None,
        bands: int | None = None,
        rays: int | None = None,
        sun_terms: int | None = None,
        planes: int | None = None,
        place_error: float | None = None,
        limb_darkening: bool | None = None,
        scattered_light: Literal["auto", "on", "off"] = "auto",
        starlight: bool = False,
        solver: Literal["auto", "quadrature", "photons"] = "auto",
        photons: float | None = None,
        trace: Literal["table", "marched", "each"] = "table",
        precision: Literal["full", "single"] = "full",
        step_km: float = 1.0,
        ring_km: float = 50.0,
        smoothing_km: float = 0.0,
        seed: int = 1,
    ) -> None: ...
    @property
    def tolerance(self) -> float | None: ...
    @property
    def budget_s(self) -> float | None: ...
    @property
    def bands(self) -> int | None: ...
    @property
    def rays(self) -> int | None: ...
    @property
    def sun_terms(self) -> int | None: ...
    @property
    def planes(self) -> int | None: ...
    @property
    def place_error(self) -> float | None: ...
    @property
    def limb_darkening(self) -> bool | None: ...
    @property
    def scattered_light(self) -> Literal["auto", "on", "off"]: ...
    @property
    def starlight(self) -> bool: ...
    @property
    def solver(self) -> Literal["auto", "quadrature", "photons"]: ...
    @property
    def photons(self) -> float | None: ...
    @property
    def trace(self) -> Literal["table", "marched", "each"]: ...
    @property
    def precision(self) -> Literal["full", "single"]: ...
    @property
    def step_km(self) -> float: ...
    @property
    def ring_km(self) -> float: ...
    @property
    def smoothing_km(self) -> float: ...
    @property
    def seed(self) -> int: ...

class ShadowProfile:
    @property
    def wavelengths_nm(self) -> NDArray[np.float64]: ...
    @property
    def axis_distances_km(self) -> NDArray[np.float64]: ...
    @property
    def ratio(self) -> NDArray[np.float64]: ...
    @property
    def standard_error(self) -> NDArray[np.float64]: ...

def shadow_profile(
    when: Moment,
    wavelengths_nm: ArrayLike = (450.0, 550.0, 650.0),
    axis_distances_km: ArrayLike | None = None,
    *,
    position_angle_deg: float | None = None,
    air: Air | None = None,
    light: Light | None = None,
    progress: Progress | None = None,
) -> ShadowProfile: ...

class Moonlight:
    @property
    def when(self) -> datetime: ...
    @property
    def wavelengths_nm(self) -> NDArray[np.float64]: ...
    @property
    def method(self) -> str: ...
    @property
    def error_found(self) -> float: ...
    def ratio(self, latitude_deg: ArrayLike, longitude_deg: ArrayLike) -> NDArray[np.float64]: ...

def moonlight(
    when: Moment, *, air: Air | None = None, light: Light | None = None, progress: Progress | None = None
) -> Moonlight: ...

class Texture:
    @property
    def pixels(self) -> NDArray[np.float32]: ...
    @property
    def channels(self) -> list[str]: ...
    @property
    def space(self) -> Space: ...
    @property
    def header(self) -> dict[str, Any]: ...
    @property
    def parts(self) -> dict[str, NDArray[np.float32]]: ...
    def __array__(self, *args: Any) -> NDArray[Any]: ...

def bake(
    when: Moment,
    *,
    width: int = 4096,
    space: Space = "lin_rec709",
    air: Air | None = None,
    light: Light | None = None,
    albedo_map: str = "auto",
    albedo_exponent: float | None = None,
    photometry: Photometry = "lommel-seeliger-rolo",
    unshadowed: bool = False,
    at: Place | None = None,
    reddening: bool = True,
    spectral_nm: float | None = None,
    passes: bool = False,
    progress: Progress | None = None,
) -> Texture: ...

class _Disc:
    @property
    def magnitudes(self) -> dict[str, float]: ...
    @property
    def mean_luminance_cd_m2(self) -> float: ...
    @property
    def illuminance_lx(self) -> float: ...

class BrightnessSeen(_Disc):
    @property
    def altitude_deg(self) -> float: ...
    @property
    def azimuth_deg(self) -> float: ...
    @property
    def extinction_mag(self) -> dict[str, float]: ...

class Brightness(_Disc):
    @property
    def danjon(self) -> float | None: ...
    @property
    def seen(self) -> BrightnessSeen | None: ...

def brightness(
    when: Moment,
    *,
    air: Air | None = None,
    light: Light | None = None,
    albedo_map: str = "auto",
    albedo_exponent: float | None = None,
    photometry: Photometry = "lommel-seeliger-rolo",
    unshadowed: bool = False,
    at: Place | None = None,
    reddening: bool = True,
    progress: Progress | None = None,
) -> Brightness: ...

class Estimate:
    @property
    def median(self) -> float: ...
    @property
    def low(self) -> float: ...
    @property
    def high(self) -> float: ...
    @property
    def information(self) -> float: ...

class Fit:
    @property
    def dust_extinction(self) -> Estimate: ...
    @property
    def cloud_cover(self) -> Estimate: ...
    @property
    def ozone_du(self) -> Estimate: ...
    @property
    def correlation(self) -> NDArray[np.float64]: ...
    @property
    def chi_squared(self) -> float: ...
    @property
    def numbers(self) -> int: ...
    @property
    def explained(self) -> bool: ...

def fit(
    magnitudes: Iterable[MeasuredMagnitude],
    *,
    air: Air | None = None,
    light: Light | None = None,
    albedo_map: str = "auto",
    albedo_exponent: float | None = None,
    photometry: Photometry = "lommel-seeliger-rolo",
    progress: Progress | None = None,
) -> Fit: ...
