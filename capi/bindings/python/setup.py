# SPDX-License-Identifier: MIT
"""The compiled part of the package, which pyproject.toml cannot describe: optional, for Python 3.11 and later."""

import sys
import sysconfig

from setuptools import Extension, setup

# What it is compiled against is stable from 3.11 on, but for Pythons without the global lock.
stable = sys.version_info >= (3, 11) and not sysconfig.get_config_var("Py_GIL_DISABLED")
if stable:
    single = Extension("nurbs._single", ["nurbs/_single.c"], py_limited_api=True, optional=True)
    setup(ext_modules=[single], options={"bdist_wheel": {"py_limited_api": "cp311"}})
else:
    setup()
