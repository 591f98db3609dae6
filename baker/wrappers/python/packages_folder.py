# SPDX-License-Identifier: MIT
"""Prints the folder below a prefix where this interpreter finds packages, relative to the prefix.

    python3 packages_folder.py PREFIX

Debian's interpreter uses folders of its own: lib/python3/dist-packages below /usr, and lib/python3.11/dist-packages
below /usr/local.
"""
import sys
import sysconfig

prefix = sys.argv[1].rstrip("/")
scheme, base = {"/usr": ("deb_system", "/usr"), "/usr/local": ("posix_local", "/usr")}.get(prefix, ("posix_prefix", prefix))
if scheme not in sysconfig.get_scheme_names():
    scheme, base = "posix_prefix", prefix
print(sysconfig.get_path("platlib", scheme, {"base": base, "platbase": base}).removeprefix(prefix + "/"))
