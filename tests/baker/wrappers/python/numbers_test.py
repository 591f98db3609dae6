# SPDX-License-Identifier: MIT
"""The package's numbers are the command's, and those that others published."""
import csv
import datetime
import json
import pathlib
import tempfile
import unittest

import coppermoon
import numpy
import OpenImageIO

from support import clear, command, draft, small, small_flags, tests_folder, thorough, when


class Shadow(unittest.TestCase):
    def test_is_the_commands_csv_digit_by_digit(self):
        distances = "0,2000,4000,4500"
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "umbra.csv"
            command("shadow", when, "--atmosphere", "undated", "--wavelengths", "420,550,680", "--axis-distances", distances,
                    "-o", str(file))
            rows = list(csv.reader(file.read_text().splitlines()))
        profile = coppermoon.shadow_profile(when, [420, 550, 680], numpy.fromstring(distances, sep=","),
                                            air=coppermoon.Air(atmosphere="undated"))
        self.assertEqual(len(rows), 5)
        for row, km, ratio, error in zip(rows[1:], profile.axis_distance_km, profile.irradiance_ratio, profile.standard_error):
            numbers = [f"{km:g}"]
            for r, e in zip(ratio, error):
                numbers += [f"{r:.6g}", f"{e:.3g}"]
            self.assertEqual(row, numbers)

    def test_of_photons_is_the_commands_and_has_their_error(self):
        rows = command("shadow", when, "--atmosphere", "clear", "--wavelengths", "600", "--axis-distances", "3000",
                       "--solver", "photons", "--photons", "20000", "--seed", "5").splitlines()
        profile = coppermoon.shadow_profile(when, [600], [3000], air=clear,
                                            light=coppermoon.Light(solver="photons", photons=2e4, seed=5))
        self.assertEqual(rows[1], f"3000,{profile.irradiance_ratio[0, 0]:.6g},{profile.standard_error[0, 0]:.3g}")
        self.assertGreater(profile.standard_error[0, 0], 0)

    def test_goes_by_position_angle_and_reaches_sunlight(self):
        profile = coppermoon.shadow_profile(when, [550], position_angle_deg=90, air=clear)
        numpy.testing.assert_array_equal(numpy.diff(profile.axis_distance_km[:-1]), 100)
        # direct sunlight beyond the penumbra, to rounding
        self.assertAlmostEqual(profile.irradiance_ratio[-1, 0], 1, delta=1e-3)


class Domes(unittest.TestCase):
    def test_are_the_commands(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "sky.exr"
            said = json.loads(command("dome", when, "--at", "Nairobi", "--width", "32", "--type", "float", "--tolerance",
                                      "5%", "--stars", "3", "--json", "-o", str(file)))
            texels = OpenImageIO.ImageBuf(str(file)).get_pixels(OpenImageIO.FLOAT)
        dome = coppermoon.dome(when, at="Nairobi", width=32, stars="3", light=coppermoon.Light(tolerance=0.05))
        numpy.testing.assert_array_equal(dome.pixels, texels)
        for name, value in dome.figures.items():
            self.assertEqual(said[name], value)


class Eclipses(unittest.TestCase):
    def test_have_moments_by_their_contacts_as_for_the_command(self):
        for text in ("2018-07-27", "2018-07-27 U2+10min", "2018-07-27 greatest", "2018-07-27 P4-0.5h"):
            said = json.loads(command("sky", text, "--json"))["instant"]
            self.assertEqual(coppermoon.sky(text).instant, datetime.datetime.fromisoformat(said))
        with self.assertRaisesRegex(coppermoon.Error, "allowed an instant or one of"):
            coppermoon.sky("2018-07-27 U9")

    def test_have_the_published_contacts(self):
        lines = (tests_folder / "baker/eclipse/data/published_contacts.csv").read_text().splitlines()
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
        compared = 0
        for row in rows:
            eclipse = coppermoon.nearest_eclipse(row["P1"], convention=row["convention"])
            for name, found in {**eclipse.contacts, "greatest": eclipse.greatest}.items():
                if row[name]:
                    published = datetime.datetime.fromisoformat(row[name].rstrip("Z")).replace(tzinfo=datetime.timezone.utc)
                    # 7.9 s at worst, as contacts_test.cpp measures; and the millisecond that datetimes are rounded to
                    self.assertLess(abs((found - published).total_seconds()), 12, (name, row))
                    compared += 1
        self.assertGreater(compared, 50)

    def test_are_the_commands(self):
        told = json.loads(command("almanac", "--from", "2000-01-01", "--to", "2003-01-01", "--json"))
        found = coppermoon.eclipses("2000-01-01", datetime.datetime(2003, 1, 1, tzinfo=datetime.timezone.utc))
        self.assertEqual([e.type for e in found], [one["type"] for one in told])
        self.assertEqual([e.gamma for e in found], [one["gamma"] for one in told])
        self.assertEqual([list(e.contacts) for e in found], [list(one["contacts"]) for one in told])

    def test_of_many_years_are_each_there_once(self):
        many = coppermoon.eclipses("1901-01-01", "2001-01-01")
        # all kinds of 1901 to 2000: Espenak & Meeus (2009), Five Millennium Canon, table of centuries
        self.assertEqual(len(many), 229)
        self.assertEqual(len({e.greatest for e in many}), len(many))


class Sky(unittest.TestCase):
    def test_is_the_commands(self):
        told = json.loads(command("sky", when, "--at", "Nairobi", "--json"))
        sky = coppermoon.sky(when, at="Nairobi")
        self.assertEqual({name: getattr(sky, name) for name in told if name != "instant"},
                         {name: told[name] for name in told if name != "instant"})

    def test_takes_moments_of_any_zone(self):
        nairobi = datetime.timezone(datetime.timedelta(hours=3))
        here = datetime.datetime(2018, 7, 27, 23, 21, 45, 250000, tzinfo=nairobi)
        self.assertEqual(coppermoon.sky(here).instant, here)
        self.assertEqual(coppermoon.sky("2018-07-27T23:21:45.25+03:00").axis_distance_km, coppermoon.sky(here).axis_distance_km)

    def test_matrix_turns_the_moon_to_the_earth(self):
        sky = coppermoon.sky(when)
        towards_earth = sky.selenographic_from_gcrs @ (-sky.moon_m / numpy.linalg.norm(sky.moon_m))
        latitude = numpy.degrees(numpy.arcsin(towards_earth[2]))
        self.assertAlmostEqual(latitude, sky.sub_earth_latitude_deg, delta=0.006)  # aberration: 20.5 arcseconds


class Texture(unittest.TestCase):
    def test_is_the_commands_texel_by_texel(self):
        with tempfile.TemporaryDirectory() as folder:
            file = str(pathlib.Path(folder) / "moon.exr")
            command("bake", when, *small_flags, "--space", "acescg", "--type", "float", "-o", file)
            image = OpenImageIO.ImageInput.open(file)
            written, spec = image.read_image("float"), image.spec()
        moon = coppermoon.bake(when, space="acescg", **small)
        numpy.testing.assert_array_equal(moon.pixels, written)
        self.assertEqual(moon.pixels.dtype, numpy.float32)
        self.assertTrue(moon.pixels.flags.c_contiguous)
        self.assertEqual((moon.space, moon.header["coppermoon:colour_space"]), ("acescg", "acescg"))
        distance = "coppermoon:distance_km"
        self.assertEqual(moon.header[distance], numpy.float32(spec.get_float_attribute(distance)))

    def baked_by_its_recipe(self, moon):
        """Pixels that the program bakes by the recipe in a texture's header."""
        with tempfile.TemporaryDirectory() as folder:
            recipe, file = pathlib.Path(folder) / "moon.toml", str(pathlib.Path(folder) / "again.exr")
            recipe.write_text(moon.header["coppermoon:recipe"])
            command("bake", "--recipe", str(recipe), "-o", file)
            return OpenImageIO.ImageInput.open(file).read_image("float")

    def test_has_the_recipe_that_bakes_it_again(self):
        south = coppermoon.Region(from_latitude=-90, to_latitude=0.1, dust_extinction=1e-5, stratospheric_aerosol=0.3)
        for text, settings in {
                "small": small,
                "regions": {**small, "air": coppermoon.Air(atmosphere="undated", ozone_du=280.1, regions=[south])},
                "a place": {**small, "at": (-1.2833333, 36.8166667, 1684.3), "observer_ozone_du": 250},
                "a city": {**small, "at": "Nairobi", "reddening": False, "space": "acescg"},
                "mean ground": {**small, "ground": "mean", "light": coppermoon.Light(tolerance=0.1)},
                "photons": {**small, "light": coppermoon.Light(bands=4, photons=1e4, seed=2**63 + 1)},
                "sunlight": {**small, "unshadowed": True},
                "a camera": {**small, "response": "sony-ilce-7m3"},
                "spectra": {**small, "spectral_nm": 100, "passes": True}}.items():
            with self.subTest(text):
                moon = coppermoon.bake("2018-07-27T20:21:45.123456Z", **settings)
                numpy.testing.assert_array_equal(self.baked_by_its_recipe(moon), moon.pixels)

    def test_is_seen_through_a_cameras_filters(self):
        eye, camera = coppermoon.bake(when, **small).pixels, coppermoon.bake(when, response="nikon-d850", **small).pixels
        lit = eye[..., 0] > 0.1 * eye[..., 0].max()
        self.assertGreater(abs(camera[lit] / eye[lit] - 1).max(), 0.03)
        with self.assertRaisesRegex(coppermoon.Error, "response = eye, allowed colorimetric, canon-eos"):
            coppermoon.bake(when, response="eye", **small)

    def test_has_spectra_and_passes(self):
        moon = coppermoon.bake(when, spectral_nm=100, passes=True, **small)
        self.assertEqual(moon.pixels.shape, (32, 64, 7))
        self.assertEqual(moon.channels[3], "S0.430,000000nm")
        self.assertIn("refracted", moon.parts)

    def test_is_an_array(self):
        moon = coppermoon.bake(when, **small)
        numpy.testing.assert_array_equal(numpy.asarray(moon), moon.pixels)

    def test_of_the_whole_moon_shines_as_bright_as_it_is_measured(self):
        full = coppermoon.bake(when, unshadowed=True, width=256, albedo_map="built-in", light=draft)
        eclipsed = coppermoon.bake(when, width=256, albedo_map="built-in", air=clear, light=draft)
        seen = full.pixels[..., 1] > 0
        self.assertTrue((eclipsed.pixels[..., 1][seen] < full.pixels[..., 1][seen]).all())


class Moonlight(unittest.TestCase):
    def test_is_the_shadows_where_the_moon_stands_in_it(self):
        scattered = {"scattered_light": "on"}  # the profile has it always, moonlight where luminance asks for it
        light = coppermoon.moonlight(when, air=clear, light=coppermoon.Light(bands=4, rays=60, **scattered))
        ratio = light.ratio(*numpy.meshgrid([-60, -30, 0, 30, 60], [-60, 0, 60], indexing="ij"))
        self.assertEqual(ratio.shape, (5, 3, len(light.wavelengths_nm)))
        # the farthest ground is 745 + 1737 km from the axis. The profile is the mean around the axis: an ellipsoid's light
        # differs by a tenth from it
        profile = coppermoon.shadow_profile(when, light.wavelengths_nm, numpy.arange(0, 2501, 100), air=clear)
        self.assertTrue((ratio > 0.9 * profile.irradiance_ratio.min(axis=0)).all())
        self.assertTrue((ratio < 1.1 * profile.irradiance_ratio.max(axis=0)).all())
        self.assertLess(ratio[..., 0].max(), ratio[..., -1].min())  # copper


class Brightness(unittest.TestCase):
    def check(self, flags, **keywords):
        told = json.loads(command("brightness", when, "--albedo-map", "built-in", "--atmosphere", "clear", "--json", *flags))
        moon = coppermoon.brightness(when, albedo_map="built-in", air=clear, **keywords)
        self.assertEqual(moon.magnitudes, told["magnitudes"])
        self.assertEqual(moon.mean_luminance_cd_m2, told["mean_luminance_cd_m2"])
        self.assertEqual(moon.illuminance_lx, told["illuminance_lx"])
        self.assertEqual(moon.danjon, told["danjon"])
        return moon, told

    def test_of_sunlight_is_the_commands_and_the_full_moons(self):
        moon, _ = self.check(["--unshadowed"], unshadowed=True)
        # the full Moon: -12.74 at its mean distance (Allen 1973); at 406 099 km 0.12 fainter; at a phase of a degree or two a
        # surge brighter than where observers can see it
        self.assertAlmostEqual(moon.magnitudes["V"], -12.62, delta=0.4)
        # a disc of 1737.4 km at 406 099 km; half a per cent of it lies beyond the limb that is seen
        self.assertAlmostEqual(moon.illuminance_lx / moon.mean_luminance_cd_m2 / (numpy.pi * (1737.4 / 406098.75) ** 2), 1,
                               delta=0.01)

    def test_over_time_is_the_commands(self):
        words = ["--from", "2018-07-27T18:24Z", "--to", "2018-07-27T19:24Z", "--step", "30", "--at", "Nairobi"]
        told = json.loads(command("brightness", when, "--albedo-map", "built-in", "--atmosphere", "clear", "--bands", "4",
                                  "--rays", "60", "--json", *words))
        curve = coppermoon.light_curve("2018-07-27T18:24Z", "2018-07-27T19:24Z", step_min=30, at="Nairobi", air=clear,
                                       light=draft, albedo_map="built-in")
        self.assertEqual(curve["instant"][1], numpy.datetime64("2018-07-27T18:54"))
        self.assertEqual(set(curve), set(told["moments"][0]))
        for name in set(curve) - {"instant"}:
            numpy.testing.assert_array_equal(curve[name], [numpy.nan if row[name] is None else row[name]
                                                           for row in told["moments"]], name)
        self.assertLess(curve["seen_illuminance_lx"][2], curve["seen_illuminance_lx"][0])

    @unittest.skipUnless(thorough, "sums up the light of eight channels closely")
    def test_is_the_commands_thoroughly(self):
        moon, told = self.check(["--at", "Nairobi", "--bands", "4", "--rays", "60"], at="Nairobi", light=draft)
        self.assertEqual(moon.seen.magnitudes, told["seen"]["magnitudes"])
        self.assertEqual(moon.seen.altitude_deg, told["seen"]["altitude_deg"])


if __name__ == "__main__":
    unittest.main()
