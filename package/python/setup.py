"""Builds the package tia_kit. In the tree of tia it has make build the shared library; a copy made by `make python` has it."""
import os
import subprocess

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

try:
    from wheel.bdist_wheel import bdist_wheel
except ImportError:
    bdist_wheel = object

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
LIBRARY = os.path.join(HERE, "tia_kit", "libtia-kit.so")


def in_tree():
    return os.path.exists(os.path.join(ROOT, "tools", "kit", "kit.mk"))


def version():
    if not in_tree():
        with open(os.path.join(HERE, "tia_kit", "VERSION"), encoding="ascii") as file:
            return file.read().strip()
    with open(os.path.join(ROOT, "include", "tia", "tia.h"), encoding="utf-8") as file:
        return file.read().split('TIA_VERSION "')[1].split('"')[0]


class Build(build_py):
    """Copies the shared library beside the modules."""

    def run(self):
        super().run()
        library = LIBRARY
        if in_tree():
            build = os.environ.get("BUILD", "build")
            subprocess.run(["make", "-s", "-C", ROOT, f"BUILD={build}", f"{build}/kit/libtia-kit.so"], check=True)
            library = os.path.join(ROOT, build, "kit", "libtia-kit.so")
        self.copy_file(library, os.path.join(self.build_lib, "tia_kit", "libtia-kit.so"))


class Wheel(bdist_wheel):
    """A wheel for every Python 3, but for this kind of machine alone."""

    def finalize_options(self):
        super().finalize_options()
        self.root_is_pure = False

    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


class Binary(Distribution):
    """Has a shared library: it is installed among what depends on the machine."""

    def has_ext_modules(self):
        return True


setup(name="tia-kit", version=version(), description="Pictures with the same bits on every machine, and the exact rasteriser, for tests",
      license="MIT", packages=["tia_kit"], package_data={"tia_kit": ["py.typed"]}, python_requires=">=3.8", distclass=Binary,
      cmdclass={"build_py": Build, **({"bdist_wheel": Wheel} if bdist_wheel is not object else {})},
      entry_points={"pytest11": ["tia_kit = tia_kit.pytest_plugin"]}, zip_safe=False)
