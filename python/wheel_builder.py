"""The build backend of `pip install .` (PEP 517): a wheel with the package and the programs, built
by CMake in build/release. It needs what scripts/python installs, and downloads nothing."""

import base64
import hashlib
import pathlib
import re
import subprocess
import sys
import sysconfig
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
TREE = ROOT / "build" / "release"


def _version():
    """0.2.0, or 0.2.0.dev0 before its release (PEP 440)."""
    text = (ROOT / "include" / "polhode" / "version.hpp").read_text(encoding="utf-8")
    parts = [re.search(rf"#define POLHODE_VERSION_{part} (\d+)", text).group(1)
             for part in ("MAJOR", "MINOR", "PATCH")]
    suffix = re.search(r'#define POLHODE_VERSION_SUFFIX "([^"]*)"', text)
    return ".".join(parts) + (".dev0" if suffix and suffix.group(1) else "")


def _run(*command):
    done = subprocess.run(command, cwd=ROOT, check=False)
    if done.returncode != 0:
        raise SystemExit(f"polhode: {' '.join(command)} failed; scripts/python installs what is "
                         "missing through apt and builds the package")


def _build():
    _run("cmake", "--preset", "release")
    _run("cmake", "--build", "--preset", "release", "--target", "polhode_cli", "polhode-check",
         "polhode_python")
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    module = TREE / "python" / "polhode" / f"_polhode{suffix}"
    if not module.exists():
        version = ".".join(map(str, sys.version_info[:2]))
        raise SystemExit(f"polhode: the package was built for Debian's python3, and this is Python "
                         f"{version} at {sys.executable}: make the environment with "
                         "/usr/bin/python3 -m venv")
    return module


def get_requires_for_build_wheel(config_settings=None):
    """Nothing beyond what is installed."""
    return []


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Writes the wheel and returns its name."""
    module = _build()
    version = _version()
    python = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    tag = f"{python}-{python}-{platform}"
    name = f"polhode-{version}-{tag}.whl"
    info = f"polhode-{version}.dist-info"
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    contents = {f"polhode/{file.name}": file.read_bytes()
                for file in sorted((ROOT / "python" / "polhode").iterdir())
                if file.suffix in (".py", ".pyi") or file.name == "py.typed"}
    contents[f"polhode/{module.name}"] = module.read_bytes()
    for program in (TREE / "polhode", TREE / "src" / "checker" / "polhode-check"):
        contents[f"polhode-{version}.data/scripts/{program.name}"] = program.read_bytes()
    contents[f"{info}/METADATA"] = (
        f"Metadata-Version: 2.1\nName: polhode\nVersion: {version}\n"
        "Summary: Verified arbitrary-precision numerics, and the free rotation of rigid bodies\n"
        f"Requires-Python: >=3.11\nDescription-Content-Type: text/markdown\n\n{readme}").encode()
    contents[f"{info}/WHEEL"] = (f"Wheel-Version: 1.0\nGenerator: polhode\nRoot-Is-Purelib: false\n"
                                 f"Tag: {tag}\n").encode()
    record = ""
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / name, "w",
                         zipfile.ZIP_DEFLATED) as wheel:
        for path, data in contents.items():
            entry = zipfile.ZipInfo(path, (1980, 1, 1, 0, 0, 0))
            entry.external_attr = (0o100755 if "/scripts/" in path else 0o100644) << 16
            wheel.writestr(entry, data, zipfile.ZIP_DEFLATED)
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            record += f"{path},sha256={digest},{len(data)}\n"
        wheel.writestr(zipfile.ZipInfo(f"{info}/RECORD", (1980, 1, 1, 0, 0, 0)),
                       record + f"{info}/RECORD,,\n")
    return name
