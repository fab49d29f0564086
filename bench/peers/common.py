"""What the comparisons with other renderers share: their packages, one view for all, one measured process."""

import argparse
import json
import os
import pathlib
import platform
import re
import shutil
import subprocess
import time

HERE = pathlib.Path(__file__).resolve().parent
BLENDER_PACKAGES = ["blender", "python3-numpy"]


class Skipped(Exception):
    """Why a peer cannot be measured."""


def installed(package):
    query = subprocess.run(["dpkg-query", "-W", "-f", "${db:Status-Status}", package], capture_output=True, text=True, check=False)
    return query.stdout == "installed"


def provide(packages, may_install):
    missing = [package for package in packages if not installed(package)]
    if not missing:
        return
    wanted = "apt-get install --no-install-recommends " + " ".join(missing)
    if not may_install or os.geteuid() != 0:
        raise Skipped(f"needs: {wanted}")
    environment = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    if subprocess.run(wanted.split() + ["-y"], env=environment, stdout=subprocess.DEVNULL, check=False).returncode:
        raise Skipped(f"failed: {wanted}")


def numbers(point):
    return ",".join(f"{value:g}" for value in point)


def processor():
    models = re.findall(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text())
    return f"{os.cpu_count()} cores of {models[0] if models else platform.machine()}"


def velarium_view(options):
    """The flags of `render` and `reference` that say what is seen."""
    width, height = options.size
    return [options.scene.resolve(), "--env", options.env, "--eye", numbers(options.eye), "--target", numbers(options.target),
            "--fov", f"{options.fov:g}", "--size", f"{width}x{height}", "--progress", "none"]


def blender_command(options, picture, engine, samples, seed=0):
    """One picture by Blender. `--debug-cycles` makes Cycles tell how long it traced."""
    job = {"scene": str(options.scene.resolve()), "env": str(options.env), "out": str(picture), "engine": engine,
           "samples": samples, "seed": seed, "bounces": options.bounces, "threads": options.threads, "size": options.size,
           "eye": options.eye, "target": options.target, "fov": options.fov}
    return ["blender", "-b", "--debug-cycles", "--python-exit-code", "1", "--python", HERE / "blender_peer.py", "--",
            json.dumps(job)]


def run_process(command, folder, log):
    """One run of a whole process: wall and processor seconds, and the peak memory of its largest process."""
    # Debian's programs, and Debian's Python for Blender, which takes the first that it finds.
    environment = {**os.environ, "PATH": "/usr/bin:/bin"}
    with log.open("w") as out:
        start = time.monotonic()
        process = subprocess.Popen([str(word) for word in command], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                                   stdout=out, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.monotonic() - start
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise Skipped(f"ended with {process.returncode}: " + " ".join(log.read_text(errors="replace").split()[-30:]))
    return {"seconds": seconds, "cpu_seconds": usage.ru_utime + usage.ru_stime, "peak_bytes": usage.ru_maxrss * 1024}


def compared(velarium, picture, reference, folder):
    """What `velarium compare` measures between two pictures."""
    file = folder / "difference.json"
    done = subprocess.run([velarium, "compare", picture, reference, "--threshold", "1e9", "--json", file, "-q"],
                          capture_output=True, text=True, check=False)
    if done.returncode:
        raise Skipped(f"compare: {done.stderr.strip()}")
    return json.loads(file.read_text())["metrics"]


def triple(text):
    values = [float(part) for part in text.split(",")]
    if len(values) != 3:
        raise argparse.ArgumentTypeError("is not x,y,z")
    return values


def size(text):
    width, height = text.split("x")
    return int(width), int(height)


def add_view(parser, picture_size):
    """Arguments that say what is seen, how light is followed, and what measures."""
    width, height = picture_size
    parser.add_argument("scene", type=pathlib.Path, help="a .gltf or .glb file")
    parser.add_argument("--env", type=pathlib.Path, required=True, help="the environment, an .hdr file")
    parser.add_argument("--eye", type=triple, required=True, metavar="X,Y,Z",
                        help="where the camera stands, metres, +Y up; --eye=-1,2,3 where x is negative")
    parser.add_argument("--target", type=triple, default=[0.0, 0.0, 0.0], metavar="X,Y,Z", help="what it looks at [0,0,0]")
    parser.add_argument("--fov", type=float, default=45.0, help="its vertical field of view, degrees [45]")
    parser.add_argument("--size", type=size, default=picture_size, metavar="WxH", help=f"pixels [{width}x{height}]")
    parser.add_argument("--bounces", type=int, default=32, help="reflections after the first, where paths are traced [32]")
    parser.add_argument("--threads", type=int, default=os.cpu_count(), help="of those who trace paths [one a core]")
    parser.add_argument("--velarium", default=shutil.which("velarium") or str(HERE.parents[1] / "build/release/velarium"),
                        help="the program [found in PATH, else build/release]")
    parser.add_argument("--keep", type=pathlib.Path, help="a folder for the pictures")
    parser.add_argument("--no-install", action="store_true", help="skip a peer rather than install its packages")


def parse_view(parser):
    options = parser.parse_args()
    options.env = options.env.resolve()
    options.velarium = str(pathlib.Path(options.velarium).resolve())
    options.keep = options.keep and options.keep.resolve()
    for file in (options.scene, options.env):
        if not file.is_file():
            parser.error(f"{file}: no such file")
    if options.keep:
        options.keep.mkdir(parents=True, exist_ok=True)
    return options
