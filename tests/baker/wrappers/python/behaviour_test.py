# SPDX-License-Identifier: MIT
"""How the package behaves: interrupts, threads, memory, wrong input, its stubs and its docstrings."""
import ast
import copy
import datetime
import doctest
import gc
import inspect
import json
import multiprocessing
import pathlib
import pickle
import re
import resource
import signal
import subprocess
import sys
import tempfile
import threading
import time
import typing
import unittest
import warnings

import coppermoon
import numpy

from support import clear, command, draft, small, thorough, when

# ignored, also by what tests start, where a shell began them in the background
signal.signal(signal.SIGINT, signal.default_int_handler)

public = [name for name in coppermoon.__all__ if not name.startswith("_")]
endless = coppermoon.Light(solver="literal", photons=1e9)


class Interrupts(unittest.TestCase):
    def interrupted(self, text):
        """Seconds from the signal to the end of a program that says when it begins."""
        program = subprocess.Popen([sys.executable, "-c", text], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual(program.stdout.readline(), "begun\n")
        time.sleep(0.5)
        self.assertIsNone(program.poll())
        program.send_signal(signal.SIGINT)
        try:
            _, err = program.communicate(timeout=60)  # a hang, not slowness
        finally:
            program.kill()
        self.assertIn("KeyboardInterrupt", err)
        self.assertNotIn("terminate", err)

    def test_ctrl_c_ends_light(self):
        self.interrupted("import coppermoon\nprint('begun', flush=True)\n"
                         "coppermoon.shadow_profile('2018-07-27T20:21:45Z', [550], light=coppermoon.Light("
                         "solver='literal', photons=1e9))")

    def test_ctrl_c_ends_the_search_for_eclipses(self):
        self.interrupted("import coppermoon\nprint('begun', flush=True)\ncoppermoon.eclipses('-1998-01-01', '2999-01-01')")

    def test_ctrl_c_ends_a_fit(self):
        self.interrupted("import coppermoon\nprint('begun', flush=True)\n"  # an hour's work
                         "coppermoon.fit([(f'2018-07-27T{hour}:{minute:02}:{second:02}Z', 'V', -0.47) for hour in (20, 21)"
                         " for minute in range(10) for second in range(60)], albedo_map='built-in')")

    def test_a_fit_is_ended_while_it_computes(self):
        class Enough(Exception):
            pass

        def callback(part):
            if part > 0:
                raise Enough(part)

        with self.assertRaises(Enough) as raised:
            coppermoon.fit([(when, "V", -0.47)], albedo_map="built-in", progress=callback)
        self.assertLess(raised.exception.args[0], 0.9)

    def test_what_a_callback_raises_ends_the_work(self):
        class Enough(Exception):
            pass

        def callback(part):
            raise Enough(part)

        with self.assertRaises(Enough):
            coppermoon.shadow_profile(when, [550], light=endless, progress=callback)

    def test_a_callback_hears_that_all_is_done(self):
        parts = []
        coppermoon.bake(when, progress=parts.append, **small)
        self.assertEqual(parts[-1], 1)
        self.assertEqual(parts, sorted(parts))


class Threads(unittest.TestCase):
    def test_two_at_once_find_the_same(self):
        alone, found = coppermoon.bake(when, **small), {}
        threads = [threading.Thread(target=lambda k=k: found.update({k: coppermoon.bake(when, **small)})) for k in range(2)]
        for each in threads:
            each.start()
        for each in threads:
            each.join()
        for k in range(2):
            numpy.testing.assert_array_equal(found[k].pixels, alone.pixels)

    def test_others_run_meanwhile(self):
        turns, begun = [], threading.Event()

        def callback(part):  # is called as long as light is computed
            begun.set()
            if len(turns) > 100:
                raise StopIteration

        def other():
            begun.wait()
            for turn in range(200):
                turns.append(turn)

        thread = threading.Thread(target=other)
        thread.start()
        with self.assertRaises(StopIteration):
            coppermoon.shadow_profile(when, [550], light=endless, progress=callback)
        thread.join()


class Memory(unittest.TestCase):
    def test_an_array_outlives_its_texture(self):
        pixels = coppermoon.bake(when, **small).pixels
        gc.collect()
        self.assertGreater(pixels.max(), 0)
        self.assertFalse(pixels.flags.owndata)  # it is the library's own, not a copy

    def test_arrays_give_their_memory_back(self):
        settings = {**small, "width": 1024}  # 6 MB

        def most_mb():
            return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024

        coppermoon.bake(when, **settings)
        before = most_mb()
        for _ in range(8):
            coppermoon.bake(when, **settings)
        self.assertLess(most_mb() - before, 25)  # four of them; 50 were all of them kept

    def test_references_are_counted(self):
        air, callback = coppermoon.Air(atmosphere="clear"), lambda part: None
        before = sys.getrefcount(air), sys.getrefcount(callback)
        for _ in range(20):
            coppermoon.shadow_profile(when, [550], [0], air=air, light=draft, progress=callback)
        self.assertEqual((sys.getrefcount(air), sys.getrefcount(callback)), before)


class Places(unittest.TestCase):
    def test_mean_their_own_days_and_moonrises(self):
        los_angeles = coppermoon.sky("2026-08-27", at="Los Angeles")  # 21:13 there, 04:13 UTC of the 28th
        self.assertEqual(los_angeles.instant, coppermoon.sky("2026-08-28").instant)
        berlin = coppermoon.sky("2025-09-07 moonrise+20min", at="Berlin, Germany")
        self.assertTrue(1 < berlin.altitude_deg < 3)
        self.assertEqual(coppermoon.sky(when, at="51.5, -0.12").altitude_deg, coppermoon.sky(when, at=(51.5, -0.12)).altitude_deg)


class OtherKinds(unittest.TestCase):
    """Values of NumPy's and Python's own types stand for the plain ones."""

    def test_textures_and_domes_are_arrays_of_numpys_protocol(self):
        light = {"at": "Nairobi", "unshadowed": True, "width": 16, "air": clear, "light": draft, "albedo_map": "built-in"}
        for made in (coppermoon.bake(when, **small), coppermoon.dome(when, **light)):
            with warnings.catch_warnings():
                warnings.simplefilter("error")  # NumPy 2 warns of a protocol without copy
                copied, doubled = numpy.array(made), numpy.asarray(made, dtype=numpy.float64)
                shared = numpy.asarray(made)
            numpy.testing.assert_array_equal(copied, made.pixels)
            numpy.testing.assert_array_equal(doubled, made.pixels)
            self.assertEqual((copied.dtype, doubled.dtype), (numpy.float32, numpy.float64))
            self.assertFalse(numpy.shares_memory(copied, made.pixels))
            self.assertTrue(numpy.shares_memory(shared, made.pixels))
            self.assertTrue(numpy.shares_memory(made.__array__(copy=False), made.pixels))
            self.assertFalse(numpy.shares_memory(made.__array__("float32", copy=True), made.pixels))
            with self.assertRaisesRegex(ValueError, "float32 as float64 is a copy, allowed copy=None"):
                made.__array__(numpy.float64, copy=False)
            if numpy.lib.NumpyVersion(numpy.__version__) >= "2.0.0":
                self.assertTrue(numpy.shares_memory(numpy.array(made, copy=False), made.pixels))

    def test_moments(self):
        instant = coppermoon.sky(when).instant
        for text in ("2018-07-27T20:21:45", "2018-07-27T20:21:45.000000000"):
            self.assertEqual(coppermoon.sky(numpy.datetime64(text)).instant, instant)
        self.assertEqual(coppermoon.sky(numpy.datetime64("2018-07-27T20")).instant, coppermoon.sky("2018-07-27T20:00Z").instant)
        greatest = coppermoon.sky("2018-07-27").instant
        for day in (datetime.date(2018, 7, 27), numpy.datetime64("2018-07-27")):
            self.assertEqual(coppermoon.sky(day).instant, greatest)
            self.assertEqual(coppermoon.nearest_eclipse(day).greatest, coppermoon.nearest_eclipse("2018-07-27").greatest)
            self.assertEqual(len(coppermoon.eclipses(datetime.date(2018, 1, 1), day)), 1, "midnight")
        with self.assertRaisesRegex(coppermoon.Error, "NaT"):
            coppermoon.sky(numpy.datetime64("NaT"))

    def test_numbers_and_paths(self):
        plain = coppermoon.bake(when, **small)
        for width in (numpy.int64(64), numpy.uint16(64)):
            light = coppermoon.Light(bands=numpy.int32(4), rays=numpy.int64(60))
            made = coppermoon.bake(when, **{**small, "width": width, "light": light})
            numpy.testing.assert_array_equal(made.pixels, plain.pixels)
        self.assertEqual(coppermoon.Air(ozone_du=numpy.float32(250)), coppermoon.Air(ozone_du=250))
        self.assertEqual(coppermoon.Air(stratospheric_aerosol=numpy.float64(0.25)), coppermoon.Air(stratospheric_aerosol=0.25))
        for sun in (numpy.True_, numpy.False_):
            self.assertEqual(coppermoon.Air(refraction=sun).refraction, bool(sun))
        place = coppermoon.sky(when, at=(-1.25, 36.75)).altitude_deg
        self.assertEqual(coppermoon.sky(when, at=numpy.array([-1.25, 36.75], numpy.float32)).altitude_deg, place)
        self.assertEqual(coppermoon.sky(when, at=(numpy.float32(-1.25), numpy.float64(36.75))).altitude_deg, place)
        with self.assertRaisesRegex(coppermoon.Error, "^/nowhere.png: "):
            coppermoon.bake(when, albedo_map=pathlib.Path("/nowhere.png"))
        shot = coppermoon.Photograph(pathlib.Path("a.jpg"), numpy.datetime64("2018-07-27T20:21:45"), iso=numpy.int64(800),
                                     exposure_time_s=numpy.float32(0.5))
        self.assertEqual((shot.file, shot.iso, shot.exposure_time_s), ("a.jpg", 800, 0.5))
        self.assertEqual(shot.instant, datetime.datetime(2018, 7, 27, 20, 21, 45, tzinfo=datetime.timezone.utc))

    def test_are_in_the_stub(self):
        names = {"Number": numpy.float32(1), "Whole": numpy.int64(1), "Switch": numpy.True_, "File": pathlib.Path("a")}
        module = {"np": numpy, "os": __import__("os"), "Any": typing.Any}
        for node in Texts.stub.body:
            if isinstance(node, ast.Assign) and node.targets[0].id in names:
                kinds = typing.get_args(eval(ast.unparse(node.value), module))
                value = names.pop(node.targets[0].id)
                self.assertTrue(isinstance(value, tuple(typing.get_origin(kind) or kind for kind in kinds)))
        self.assertEqual(names, {})


class Results(unittest.TestCase):
    """Results are values: they are compared, pickled and shown by what they describe."""

    @classmethod
    def setUpClass(cls):
        eclipse = coppermoon.nearest_eclipse("2018-07-27")
        cls.all = [eclipse, coppermoon.nearest_eclipse("-0584-05-28"), coppermoon.sky(when), coppermoon.sky(when, at="Nairobi"),
                   coppermoon.shadow_profile(when, [550, 650], [0, 4000], air=clear),
                   coppermoon.moonlight(when, air=clear, light=draft), coppermoon.bake(when, **small),
                   coppermoon.brightness(when, at="Nairobi", air=clear, light=draft, albedo_map="built-in"),
                   coppermoon.dome(when, at="Nairobi", width=16, unshadowed=True, albedo_map="built-in"),
                   coppermoon.Air(ozone_du=250, regions=[coppermoon.Region(from_latitude=0, to_latitude=90, cloud_cover=1)]),
                   coppermoon.Light(tolerance=None, budget_s=1), coppermoon.Region(from_latitude=0, to_latitude=90)]

    def test_come_back_equal_from_pickles_and_pools(self):
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            for result, from_pool in zip(self.all, pool.map(copy.copy, self.all)):
                with self.subTest(repr(result)):
                    again = pickle.loads(pickle.dumps(result))
                    self.assertEqual((again, from_pool), (result, result))
                    self.assertEqual((hash(again), repr(again)), (hash(result), repr(result)))
                    self.assertTrue(repr(result).startswith(type(result).__name__ + "("))

    def test_are_not_equal_to_others(self):
        for i, one in enumerate(self.all):
            for other in [*self.all[:i], None, {}]:
                self.assertNotEqual(one, other)

    def test_of_arrays_are_equal_by_their_arrays(self):
        light = coppermoon.moonlight(when, air=clear, light=draft)
        self.assertEqual(light, self.all[5])
        self.assertNotEqual(light, coppermoon.moonlight(when, air=coppermoon.Air(atmosphere="molecular"), light=draft))
        again = pickle.loads(pickle.dumps(light))
        numpy.testing.assert_array_equal(again.ratio([0, 60], [0, 30]), light.ratio([0, 60], [0, 30]))

    def test_properties_say_their_units(self):
        self.assertEqual(coppermoon.Sky.moon_distance_km.__doc__, "distance of the Moon from the Earth's centre [km]")
        self.assertEqual(self.all[7].seen.extinction_mag.keys(), {"B", "V", "R"})


class Errors(unittest.TestCase):
    def refused(self, kind, text, function, *arguments, **keywords):
        with self.assertRaisesRegex(kind, text):
            function(*arguments, **keywords)

    def test_are_value_errors_of_one_line(self):
        self.assertTrue(issubclass(coppermoon.Error, ValueError))
        self.assertEqual(coppermoon.Error.__module__, "coppermoon")
        for text, function, arguments in [
                ("date \"x\"", coppermoon.sky, {"when": "x"}),
                ("without a time zone", coppermoon.sky, {"when": datetime.datetime(2018, 7, 27)}),
                ("date \"\"", coppermoon.sky, {"when": ""}),
                ("those of a place, and none is given", coppermoon.sky, {"when": "2025-09-07 moonrise"}),
                ("no such city", coppermoon.sky, {"when": when, "at": "Nowhere"}),
                (r"latitude \[deg\] = nan", coppermoon.sky, {"when": when, "at": (float("nan"), 0)}),
                ("place of 1 numbers", coppermoon.sky, {"when": when, "at": [1]}),
                ("no lunar eclipse at .*; the nearest is", coppermoon.bake, {"when": "2018-07-20T00:00Z"}),
                ("no lunar eclipse is greatest on that day .*; the nearest is", coppermoon.bake, {"when": "2018-07-20"}),
                ("width = 3, allowed 4 to 32768", coppermoon.bake, {"when": when, "width": 3}),
                ("space", coppermoon.bake, {"when": when, "space": "sepia"}),
                ("/nowhere.png", coppermoon.bake, {"when": when, "albedo_map": "/nowhere.png"}),
                ("below the horizon", coppermoon.bake, {**small, "when": when, "at": "Honolulu"}),
                ("photometry = x, allowed", coppermoon.brightness, {"when": when, "photometry": "x"}),
                ("neither a tolerance nor a budget", coppermoon.moonlight,
                 {"when": when, "light": coppermoon.Light(tolerance=None)}),
                ("tolerance = nan", coppermoon.Light, {"tolerance": float("nan")}),
                ("photons = nan", coppermoon.Light, {"photons": float("nan")}),
                ("ground = x, allowed by-place, mean", coppermoon.bake, {"when": when, "ground": "x"}),
                ("albedo_map_centre = 90, allowed 0, 180", coppermoon.bake, {"when": when, "albedo_map_centre": 90}),
                (r"wavelength \[nm\] = inf", coppermoon.shadow_profile, {"when": when, "wavelengths_nm": [float("inf")]}),
                ("axes, allowed 1", coppermoon.shadow_profile, {"when": when, "wavelengths_nm": [[550]]}),
                ("above 3", coppermoon.shadow_profile, {"when": when, "axis_distances_km": [3, 2]}),
                ("no number", coppermoon.shadow_profile, {"when": when, "axis_distances_km": []}),
                ("texture width .* = 5, allowed even", coppermoon.bake, {"when": when, "width": 5}),
                ("danjon = 7, allowed 0 to 4", coppermoon.Air, {"danjon": 7}),
                ("dust_extinction = inf, allowed", coppermoon.Air, {"dust_extinction": float("inf")}),
                ("density = thick, allowed seasonal", coppermoon.Air, {"density": "thick"}),
                ("allowed 0 to 2", coppermoon.Air, {"stratospheric_aerosol": 3}),
                ("stop = ", coppermoon.eclipses, {"start": "2019-01-01", "stop": "2018-01-01"}),
                ("missing", coppermoon.fit, {"magnitudes": []}),
                ("/nowhere.jpg: ", coppermoon.fit, {"photographs": [coppermoon.Photograph("/nowhere.jpg", when)]}),
                ("clock_error_s = -1, allowed 0 to 3600", coppermoon.fit, {"magnitudes": [(when, "V", 1.0)], "clock_error_s": -1}),
                ("coding = raw, allowed", coppermoon.Photograph, {"file": "a.jpg", "when": when, "coding": "raw"}),
                ("band = U", coppermoon.fit, {"magnitudes": [(when, "U", 1.0)], "albedo_map": "built-in"}),
                ("magnitude = nan", coppermoon.fit, {"magnitudes": [(when, "V", float("nan"))]})]:
            with self.subTest(text):
                self.refused(coppermoon.Error, text, function, **arguments)
        self.refused(coppermoon.Error, "years 1 to 9999", lambda: coppermoon.nearest_eclipse("-0584-05-28").greatest)

    def test_of_kind_are_type_errors(self):
        for function, arguments in [
                (coppermoon.sky, {"when": 3}), (coppermoon.sky, {"when": None}),
                (coppermoon.Air, {"thick": True}), (coppermoon.Air, {"refraction": "off"}), (coppermoon.Air, {"ozone_du": "x"}),
                (coppermoon.Air, {"regions": [3]}), (coppermoon.Light, {"seed": -1}), (coppermoon.Light, {"bands": 2.5}),
                (coppermoon.bake, {"when": when, "width": -2}), (coppermoon.bake, {"when": when, "width": 10**30}),
                (coppermoon.bake, {"when": when, "thick": True}), (coppermoon.bake, {"when": when, "unshadowed": None}),
                (coppermoon.Light, {"seed": None}), (coppermoon.Light, {"leave_out": ["ellipsoid"]}),
                (coppermoon.bake, {"when": when, "air": 3}), (coppermoon.bake, {"when": when, "progress": 3}),
                (coppermoon.shadow_profile, {"when": when, "wavelengths_nm": ["red"]}), (coppermoon.fit, {"magnitudes": [1]}),
                (coppermoon.fit, {"photographs": ["a.jpg"]}), (coppermoon.fit, {"magnitudes": [(when, "V", "bright")]})]:
            with self.subTest(arguments):
                self.refused(TypeError, "", function, **arguments)

    def test_of_shapes_and_places(self):
        light = coppermoon.moonlight(when, air=clear, light=draft)
        self.refused(coppermoon.Error, "two shapes", light.ratio, [1, 2], [1, 2, 3])
        self.refused(coppermoon.Error, "latitude .* = 91", light.ratio, 91, 0)
        self.refused(coppermoon.Error, "longitude .* = nan", light.ratio, [0], [float("nan")])
        self.assertEqual(light.ratio(0, 0).shape, (4,))


class Texts(unittest.TestCase):
    """Stubs and docstrings say what there is."""

    stub = ast.parse((pathlib.Path(coppermoon.__file__).parent / "__init__.pyi").read_text())

    def signature_in_stub(self, arguments):
        """"when, *, width=4096" of a function in the stub."""
        plain = arguments.posonlyargs + arguments.args
        values = [None] * (len(plain) - len(arguments.defaults)) + arguments.defaults
        texts = [a.arg + (f"={ast.unparse(v)}" if v else "") for a, v in zip(plain, values) if a.arg != "self"]
        if arguments.kwonlyargs:
            texts.append("*")
        texts += [a.arg + (f"={ast.unparse(v)}" if v else "") for a, v in zip(arguments.kwonlyargs, arguments.kw_defaults)]
        return ", ".join(texts)

    def check_function(self, node, function):
        first_line = (function.__doc__ or "").splitlines()[0]
        self.assertEqual(first_line, f"{function.__name__}({self.signature_in_stub(node.args)})")

    def test_stubs_have_all_names_with_their_parameters(self):
        functions = {node.name: node for node in self.stub.body if isinstance(node, ast.FunctionDef)}
        classes = {node.name: node for node in self.stub.body if isinstance(node, ast.ClassDef)}
        shared = {name: classes.pop(name) for name in list(classes) if name.startswith("_")}  # only the stub has them
        self.assertEqual(sorted([*functions, *classes]), sorted(public))
        for name, node in functions.items():
            self.check_function(node, getattr(coppermoon, name))
        for name, node in classes.items():
            kind = getattr(coppermoon, name)
            if kind is coppermoon.Error:
                continue
            there = {n for n in vars(kind) if not n.startswith("_")}
            body = sum([shared[base.id].body for base in node.bases], node.body)
            members = [n for n in body if isinstance(n, ast.FunctionDef)]
            self.assertEqual({n.name for n in members if not n.name.startswith("_")}, there)
            for each in members:
                if each.name == "__init__":
                    self.assertEqual(kind.__doc__.splitlines()[0], f"{name}({self.signature_in_stub(each.args)})")
                elif not each.decorator_list and not each.name.startswith("_"):
                    self.check_function(each, getattr(kind, each.name))

    def test_every_public_name_has_a_docstring(self):
        for name in public:
            item = getattr(coppermoon, name)
            self.assertTrue(item.__doc__, name)
            for attribute, value in vars(item).items() if inspect.isclass(item) else ():
                if not attribute.startswith("_"):
                    self.assertTrue(value.__doc__, (name, attribute))

    def test_names_of_air_and_light_are_the_commands_options(self):
        options = set(re.findall(r"--([a-z0-9-]+)", command("bake", "--help-all")))
        places = {"from_latitude", "to_latitude", "from_position_angle", "to_position_angle"}  # parts of --region
        singular = {"regions": "region", "budget_s": "budget"}
        for kind in (coppermoon.Air, coppermoon.Light, coppermoon.Region):
            for name in {n for n in vars(kind) if not n.startswith("_")} - places:
                self.assertIn(singular.get(name, name).replace("_", "-"), options)

    def test_words_of_the_stub_are_known(self):
        for node in self.stub.body:
            if isinstance(node, ast.ClassDef) and node.name in ("Air", "Light", "Region"):
                for argument in next(n for n in node.body if n.name == "__init__").args.kwonlyargs:
                    for literal in re.findall(r"Literal\[(.*?)\]", ast.unparse(argument.annotation)):
                        for word in ast.literal_eval(f"[{literal}]"):
                            made = getattr(coppermoon, node.name)(**{argument.arg: word})
                            self.assertEqual(getattr(made, argument.arg), word)
        for word in ("dated", "none", "background", "moderate", "high", "extreme", 0.25):
            self.assertEqual(coppermoon.Air(stratospheric_aerosol=word).stratospheric_aerosol, word)

    def test_docstrings_have_the_meanings_of_the_commands_help(self):
        self.assertIn("\nozone_du: vertical column of ozone [DU], 0 to 1000\n", coppermoon.Air.__doc__)
        self.assertIn("\nground: colour and opposition surge", coppermoon.bake.__doc__)
        for name in public:
            self.assertNotIn(" --", getattr(coppermoon, name).__doc__.replace("coppermoon bake --recipe", ""), name)

    def test_requests_show_how_they_were_made(self):
        air = coppermoon.Air(atmosphere="undated", ozone_du=250,
                             regions=[coppermoon.Region(from_latitude=-90, to_latitude=0, cloud_cover=1)])
        again = eval(repr(air), vars(coppermoon))
        self.assertEqual(again, air)
        self.assertNotEqual(coppermoon.Air(), air)

    def test_examples_in_docstrings_run(self):
        slow = () if thorough else ("brightness", "fit")
        texts = {name: getattr(coppermoon, name).__doc__ for name in public if name not in slow}
        examples = 0
        for name, text in {"coppermoon": coppermoon.__doc__, **texts}.items():
            test = doctest.DocTestParser().get_doctest(text, {"coppermoon": coppermoon}, name, None, 0)
            result = doctest.DocTestRunner().run(test)
            self.assertEqual(result.failed, 0, name)
            examples += result.attempted
        self.assertGreater(examples, 10)


@unittest.skipUnless(thorough, "a fit takes its time")
class FitsThoroughly(unittest.TestCase):
    def test_the_air_that_made_magnitudes_is_found_again(self):
        # numbers of examples/library/fitted_air.cpp: of dust 3e-6, cover 0.5, 300 DU
        found = coppermoon.fit([(when, "B", 2.55), (when, "V", -0.47), (when, "R", -3.20)],
                               air=coppermoon.Air(atmosphere="undated"), albedo_map="built-in")
        self.assertTrue(found.explained)
        self.assertTrue(found.dust_extinction_per_m.low_68 < 3e-6 < found.dust_extinction_per_m.high_68)
        self.assertTrue(found.cloud_cover.low_68 < 0.5 < found.cloud_cover.high_68)
        self.assertTrue(-1 < found.correlation["aerosol_cloud"] < 0, "dust hides behind cloud")
        self.assertEqual(pickle.loads(pickle.dumps(found)), found)

    def test_the_air_of_a_photograph_is_found_as_by_the_command(self):
        moment = "2018-07-27T20:40:00Z"
        with tempfile.TemporaryDirectory() as folder:
            file, known = f"{folder}/a.png", ["--at", "-33.9,18.4", "--atmosphere", "undated", "--albedo-map", "built-in"]
            command("still", moment, *known, "--width", "600", "--height", "400", "--time", "2", "--iso", "800",
                    "-o", file)
            told = json.loads(command("fit", file, "--instants", moment, *known, "--coding", "srgb", "--json"))
            parts = []
            found = coppermoon.fit(photographs=[coppermoon.Photograph(file, moment, coding="srgb")], at=(-33.9, 18.4),
                                   air=coppermoon.Air(atmosphere="undated"), albedo_map="built-in", progress=parts.append)
        self.assertEqual(found.cloud_cover.median, told["cloud_cover"]["median"])
        self.assertEqual(found.dust_extinction_per_m.low_68, told["dust_extinction_per_m"]["low_68"])
        self.assertEqual(found.photographs[0].numbers, told["photographs"][0]["numbers"])
        self.assertEqual((found.photographs[0].left_out, found.photographs[0].mirrored), (None, False))
        night, = found.nights
        self.assertEqual((night.photographs, night.clock, night.tone_curve), ([file], None, None))
        self.assertEqual(pickle.loads(pickle.dumps(found)), found)
        self.assertEqual(set(night.light["channel"]), {0, 1, 2})
        for channel in range(3):
            distances = night.light["distance_km"][night.light["channel"] == channel]
            self.assertTrue(numpy.all(numpy.diff(distances) > 0), channel)
        off = numpy.abs(numpy.log(night.light["light"] / night.light["model"]))
        self.assertLess(numpy.median(off), 0.1, "the air explains it")
        self.assertEqual(parts[-1], 1)
        self.assertEqual(parts, sorted(parts))


if __name__ == "__main__":
    unittest.main()
