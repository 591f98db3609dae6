# SPDX-License-Identifier: MIT
"""Makes a wheel from a built package, without network access. pip can install it on systems with the same libraries.

    python3 wheel_of.py PACKAGE VERSION FOLDER [MINOR]

Given   MINOR  minor version, such as 14, if the package was built for another Python 3
"""
import pathlib
import shutil
import subprocess
import sys
import sysconfig
import tempfile

package, version, folder = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
minor = sys.argv[4] if len(sys.argv) > 4 else sys.version_info.minor
interpreter = f"cp3{minor}"
system = sysconfig.get_platform().replace("-", "_").replace(".", "_")
with tempfile.TemporaryDirectory() as scratch:
    shutil.copytree(package, pathlib.Path(scratch) / package.name, ignore=shutil.ignore_patterns("__pycache__"))
    facts = pathlib.Path(scratch) / f"{package.name}-{version}.dist-info"
    facts.mkdir()
    (facts / "METADATA").write_text(
        f"Metadata-Version: 2.1\nName: {package.name}\nVersion: {version}\nSummary: Bakes eclipsed Moons\nLicense: MIT\n"
        f"Requires-Python: ==3.{minor}.*\nRequires-Dist: numpy\n")
    (facts / "WHEEL").write_text(
        f"Wheel-Version: 1.0\nGenerator: coppermoon\nRoot-Is-Purelib: false\nTag: {interpreter}-{interpreter}-{system}\n")
    subprocess.run([sys.executable, "-m", "wheel", "pack", scratch, "--dest-dir", folder], check=True)
