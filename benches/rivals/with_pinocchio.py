"""Pinocchio's articulated-body algorithm, in C++, under RK4 and DOP853 with error control."""

import pathlib
import subprocess
import sys

from scipy.integrate._ivp import dop853_coefficients

HERE = pathlib.Path(__file__).parent
OUT = HERE.parent.parent / "target" / "rivals-built"
PREFIX = pathlib.Path(sys.prefix) / "lib" / f"python3.{sys.version_info.minor}" / "site-packages" / "cmeel.prefix"
# Its packages are built without -march: with it alignments of its types may not be changed, hence the second flag.
BUILDS = {"Pinocchio": [], "Pinocchio, native": ["-march=native", "-DEIGEN_MAX_ALIGN_BYTES=16"]}


def build(name, own):
    """Compiles the C++ program, DOP853's coefficients taken from SciPy, with further flags."""

    def row(values):
        return "{" + ", ".join(repr(float(x)) for x in values) + "}"

    table = dop853_coefficients
    lines = ["static const double A[12][12] = {" + ",\n".join(row(table.A[i][:12]) for i in range(12)) + "};"]
    for letter, values in [("B", table.B), ("E3", table.E3[:12]), ("E5", table.E5[:12])]:
        lines.append(f"static const double {letter}[12] = {row(values)};")
    OUT.mkdir(parents=True, exist_ok=True)
    (OUT / "dop853.hpp").write_text("#pragma once\n" + "\n".join(lines) + "\n")
    return compiled(name, "pinocchio.cpp", own, "-lpinocchio_default")


def compiled(name, source, own, *libraries):
    """A C++ program, compiled with further flags where it is older than its source."""
    binary, source = OUT / name, HERE / source
    if binary.exists() and binary.stat().st_mtime > source.stat().st_mtime:
        return binary
    limits = ["-DBOOST_MPL_LIMIT_LIST_SIZE=30", "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS", "-DBOOST_FUSION_INVOKE_MAX_ARITY=10"]
    where = [f"-I{OUT}", f"-I{PREFIX}/include", "-I/usr/include/eigen3", f"-L{PREFIX}/lib", f"-Wl,-rpath,{PREFIX}/lib"]
    print(f"compiling {name} (some minutes) ...", file=sys.stderr)
    flags = ["-std=c++17", "-O3", "-DNDEBUG", *limits, *own]
    subprocess.run(["g++", *flags, *where, str(source), *libraries, "-o", str(binary)], check=True)
    return binary


def runs(kind, bodies, end, reference):
    """Runs as compiled by its packages' flags and for this machine."""
    for name, flags in BUILDS.items():
        binary = build(name.lower().replace(", ", "-"), flags)
        command = [str(binary), kind, str(bodies), repr(end), repr(reference)]
        for line in subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines():
            rule, parameter, _, error, seconds, _ = line.split(",")
            yield name, rule, float(parameter), float(error), float(seconds)
