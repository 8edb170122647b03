"""SimpleNLG itself on the JVM: its jar, which the sdist of nlgserv on PyPI carries, and java."""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import subprocess
import sys
import tarfile
from pathlib import Path
from tempfile import TemporaryDirectory

HERE = Path(__file__).resolve().parent
NAME, VERSION = "nlgserv", "0.2.3"
SHA256 = "7b935fe5c2f711b7a31aa288ca6ca151fca1d88f0368ddd0ff981fedfd6fa1dd"
MEMBER = f"{NAME}-{VERSION}/{NAME}/simplenlg.jar"

# pip asks every source distribution for its metadata, by running its setup.py. This stands in
# for setuptools meanwhile, so that none of the distribution's code is run.
BACKEND = f"""\
import pathlib, sys
__legacy__ = sys.modules[__name__]
def get_requires_for_build_wheel(config_settings=None):
    return []
def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    folder = pathlib.Path(metadata_directory, "{NAME}-{VERSION}.dist-info")
    folder.mkdir()
    text = "Metadata-Version: 2.1\\nName: {NAME}\\nVersion: {VERSION}\\n"
    (folder / "METADATA").write_text(text)
    return folder.name
"""


class MissingError(Exception):
    """Something that SimpleNLG on the JVM needs is not there: it is left out."""


def default_jar() -> Path:
    """Return where the jar is kept once it has been downloaded."""
    cache = os.environ.get("XDG_CACHE_HOME")
    folder = Path(cache) if cache else Path.home() / ".cache"
    return folder / "personage-lite" / f"{NAME}-{VERSION}-simplenlg.jar"


def prepare(jar: Path | None, folder: Path, *, download: bool) -> tuple[list[str], str]:
    """Return the command of a compiled worker and the version, or raise why there is none."""
    java, javac = shutil.which("java"), shutil.which("javac")
    if not java or not javac:
        raise MissingError(f"{'java' if not java else 'javac'} is not on the path")
    if jar is None:
        jar = default_jar()
        if not jar.is_file():
            if not download:
                raise MissingError("its jar is not here yet; a run without --quick downloads it")
            _download(jar)
    elif not jar.is_file():
        raise MissingError(f"there is no file '{jar}'")
    sources = sorted(map(str, (HERE / "java").glob("*.java")))
    done = _run([javac, "-encoding", "UTF-8", "-cp", str(jar), "-d", str(folder), *sources])
    if done.returncode:
        reason = next(iter(done.stderr.strip().splitlines()), f"exit code {done.returncode}")
        raise MissingError(f"javac cannot compile the worker: {reason}")
    # One thread for the work and its garbage; only the just-in-time compiler has its own.
    options = ["-XX:+UseSerialGC", "-Dfile.encoding=UTF-8"]
    classes = os.pathsep.join((str(jar), str(folder)))
    return [java, *options, "-cp", classes, "Worker"], f"jar of 2014, Java {_version(java)}"


def _version(java: str) -> str:
    done = _run([java, "-version"])
    found = re.search(r"\d[\w.]*", done.stderr + done.stdout)
    return found[0] if found else "?"


def _download(jar: Path) -> None:
    """Fetch the source distribution with pip and keep its jar alone."""
    print("downloading SimpleNLG's jar (26 MB, once) …", file=sys.stderr)
    with TemporaryDirectory() as name:
        folder = Path(name)
        stand_in = folder / "setuptools"
        stand_in.mkdir()
        (stand_in / "__init__.py").touch()
        (stand_in / "build_meta.py").write_text(BACKEND)
        command = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps"]
        command += ["--no-binary", NAME, "--no-build-isolation", "--use-pep517"]
        command += ["--dest", name, f"{NAME}=={VERSION}"]
        done = _run(command, {**os.environ, "PYTHONPATH": name})
        archive = folder / f"{NAME}-{VERSION}.tar.gz"
        if done.returncode or not archive.is_file():
            reason = next(iter(done.stderr.strip().splitlines()), "pip failed")
            raise MissingError(f"its jar cannot be downloaded: {reason}")
        if hashlib.sha256(archive.read_bytes()).hexdigest() != SHA256:
            raise MissingError(f"{archive.name} is not the file that was expected")
        try:
            jar.parent.mkdir(parents=True, exist_ok=True)
            with tarfile.open(archive) as tar:
                member = tar.extractfile(MEMBER)
                assert member
                partly = jar.with_suffix(".part")
                partly.write_bytes(member.read())
                partly.replace(jar)
        except OSError as error:
            raise MissingError(f"its jar cannot be kept: {error}") from None


def _run(
    command: list[str], environment: dict[str, str] | None = None
) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command, check=False, capture_output=True, text=True, env=environment)
