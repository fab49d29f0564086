"""Installs into an empty folder, then builds and runs a program of someone else against what lies there."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

HERE = pathlib.Path(__file__).parent
BUILD, CMAKE, CXX = (os.environ[name] for name in ("VELARIUM_BUILD", "VELARIUM_CMAKE", "VELARIUM_CXX"))
SANITIZE = os.environ["VELARIUM_SANITIZE"]
FLAGS = [f"-fsanitize={SANITIZE}"] if SANITIZE else []   # a sanitized library needs a sanitized program
SCENE = HERE.parent / "data" / "triangle.gltf"


def real_name(library):
    """The file behind a library's names: libpng.so and libpng16.so.16 are libpng16.so.16.39.0."""
    found = subprocess.run([CXX, f"-print-file-name={library}"], check=True, capture_output=True, text=True).stdout
    return pathlib.Path(found.strip()).resolve().name


class Install(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="velarium install ")   # a space finds what is not quoted
        cls.addClassCleanup(folder.cleanup)
        installed = pathlib.Path(folder.name) / "installed"
        subprocess.run([CMAKE, "--install", BUILD, "--prefix", installed], check=True, stdout=subprocess.DEVNULL)
        cls.folder = pathlib.Path(folder.name)
        cls.prefix = cls.folder / "moved"   # what is installed may be moved
        installed.rename(cls.prefix)
        cls.library = next(cls.prefix.glob("lib/**/libvelarium.so")).parent

    def run_outside(self, program):
        environment = {**os.environ, "LD_LIBRARY_PATH": str(self.library)}
        done = subprocess.run([program, SCENE], cwd=self.folder, env=environment, capture_output=True, text=True,
                              check=False)
        self.assertIn(done.returncode, (0, 77), done.stderr)

    def test_cmake_finds_it(self):
        build = self.folder / "cmake"
        subprocess.run([CMAKE, "-S", HERE / "outside", "-B", build, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={self.prefix}",
                        f"-DCMAKE_CXX_COMPILER={CXX}", f"-DCMAKE_CXX_FLAGS={' '.join(FLAGS)}"],
                       check=True, stdout=subprocess.DEVNULL)
        subprocess.run([CMAKE, "--build", build], check=True, stdout=subprocess.DEVNULL)
        self.run_outside(build / "outside")

    def test_pkg_config_finds_it(self):
        environment = {**os.environ, "PKG_CONFIG_PATH": str(self.library / "pkgconfig")}
        ask = ["pkg-config", "--cflags", "--libs", "velarium"]
        told = subprocess.run(ask, env=environment, check=True, capture_output=True, text=True).stdout
        words = told.replace("\\ ", "\0").split()
        program = self.folder / "by_pkg_config"
        subprocess.run([CXX, "-std=c++20", *FLAGS, HERE / "outside" / "outside.cpp", "-o", program,
                        *(word.replace("\0", " ") for word in words)], check=True)
        self.run_outside(program)

    def test_pkg_config_knows_what_the_library_needs(self):
        if not shutil.which("readelf"):
            self.skipTest("no readelf here")
        environment = {**os.environ, "PKG_CONFIG_PATH": str(self.library / "pkgconfig"), "LC_ALL": "C"}
        static = subprocess.run(["pkg-config", "--static", "--libs-only-l", "velarium"], env=environment, check=True,
                                capture_output=True, text=True).stdout
        told = {real_name(f"lib{name}.so") for name in static.replace("-l", "").split() if name != "velarium"}
        dynamic = subprocess.run(["readelf", "-d", self.library / "libvelarium.so"], env=environment, check=True,
                                 capture_output=True, text=True).stdout
        compiler = ("libstdc++", "libm.so", "libgcc_s", "libc.so", "ld-linux", "libasan", "libubsan", "libtsan")
        for needed in re.findall(r"\(NEEDED\).*\[(.+)\]", dynamic):
            if not needed.startswith(compiler):
                self.assertIn(real_name(needed), told)

    def test_only_the_interface_is_exported(self):
        if not shutil.which("nm"):
            self.skipTest("no nm here")
        symbols = subprocess.run(["nm", "-DC", "--defined-only", self.library / "libvelarium.so"], check=True,
                                 capture_output=True, text=True).stdout
        self.assertIn("velarium::Engine::render(", symbols)
        for inner in ("velarium::gpu::", "velarium::scene::read", "velarium::graph::", "nlohmann", "fmt::"):
            self.assertNotIn(inner, symbols)

    def test_the_program_comes_with_its_pages(self):
        version = subprocess.run([self.prefix / "bin" / "velarium", "--version"], check=True, capture_output=True)
        self.assertTrue(version.stdout.startswith(b"velarium "))
        for name in ("man/man1/velarium.1.gz", "bash-completion/completions/velarium", "zsh/vendor-completions/_velarium",
                     "fish/vendor_completions.d/velarium.fish"):
            self.assertGreater((self.prefix / "share" / name).stat().st_size, 100, name)


if __name__ == "__main__":
    unittest.main()
