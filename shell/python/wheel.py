# SPDX-License-Identifier: MIT
"""Writes the wheel of the Python module: a ZIP with fixed times and order, so that the same build gives the same bytes.

    python3 wheel.py <build folder> <folder of the wheel>

The build folder holds shell/python/_core.*.so and the texts of web/package/texts.mjs in wheel/.
"""
import base64
import hashlib
import subprocess
import sys
import sysconfig
import zipfile
from pathlib import Path

SUMMARY = "Finds motions of 2D articulated figures by search"


def without_symbols(library: Path, stripped: Path) -> bytes:
    """The library without symbols, which only debuggers read and which name the build's folders."""
    command = ["strip", "-x", str(library)] if sys.platform == "darwin" else ["strip", "--strip-unneeded", str(library)]
    subprocess.run([*command, "-o", str(stripped)], check=True)
    return stripped.read_bytes()


def main(build: Path, folder: Path) -> None:
    source = Path(__file__).parent / "gaitsmith"
    library = next((build / "shell/python").glob("_core*.so"))
    root = Path(__file__).parents[2]
    version = next(line for line in (root / "CMakeLists.txt").read_text().splitlines() if line.startswith("project("))
    version = version.split("VERSION ")[1].split()[0]
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag = f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"
    info = f"gaitsmith-{version}.dist-info"

    files = {f"gaitsmith/{path.name}": path.read_bytes() for path in source.iterdir() if path.suffix in (".py", ".pyi", ".html")}
    files["gaitsmith/player.js"] = (root / "web/book/player.js").read_bytes()
    files["gaitsmith/py.typed"] = b""
    files[f"gaitsmith/{library.name}"] = without_symbols(library, build / "wheel" / library.name)
    for text in ("LICENSE", "THIRD-PARTY.txt"):
        files[f"{info}/{text}"] = (build / "wheel" / text).read_bytes()
    files[f"{info}/METADATA"] = (
        f"Metadata-Version: 2.1\nName: gaitsmith\nVersion: {version}\nSummary: {SUMMARY}\nLicense: MIT\n"
        "Requires-Python: >=3.9\nRequires-Dist: numpy\n"
    ).encode()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: gaitsmith\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()

    rows = []
    for name in sorted(files):
        digest = base64.urlsafe_b64encode(hashlib.sha256(files[name]).digest()).rstrip(b"=").decode()
        rows.append(f"{name},sha256={digest},{len(files[name])}\n")
    files[f"{info}/RECORD"] = "".join([*rows, f"{info}/RECORD,,\n"]).encode()

    path = folder / f"gaitsmith-{version}-{tag}.whl"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as wheel:
        for name in sorted(files, key=lambda name: (name.startswith(info), name)):
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.external_attr = (0o755 if name.endswith(".so") else 0o644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.create_system = 3
            wheel.writestr(entry, files[name])
    print(path)


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
