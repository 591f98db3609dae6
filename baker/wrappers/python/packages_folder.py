# SPDX-License-Identifier: MIT
"""Prints where this interpreter finds packages below a prefix, relative to it.

    python3 packages_folder.py PREFIX

Debian's interpreter has folders of its own: lib/python3/dist-packages below /usr, lib/python3.11/dist-packages below
/usr/local.
"""
import sys
import sysconfig

prefix = sys.argv[1].rstrip("/")
scheme, base = {"/usr": ("deb_system", "/usr"), "/usr/local": ("posix_local", "/usr")}.get(prefix, ("posix_prefix", prefix))
if scheme not in sysconfig.get_scheme_names():
    scheme, base = "posix_prefix", prefix
print(sysconfig.get_path("platlib", scheme, {"base": base, "platbase": base}).removeprefix(prefix + "/"))
