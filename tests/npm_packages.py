"""Packages of npm that tests need, without npm, whose Debian package brings 347 others: the two of npm_packages.json are single
archives that depend on nothing. They come from npm's registry, or from the one that the user's npm is set to, and their bytes
are pinned by SHA-512."""
import base64
import hashlib
import io
import json
import os
import pathlib
import re
import shutil
import ssl
import subprocess
import tarfile
import tempfile
import urllib.request

LOCK = json.loads((pathlib.Path(__file__).resolve().parent / "npm_packages.json").read_text(encoding="utf-8"))
REGISTRY = "https://registry.npmjs.org"
PATIENCE = 300  # seconds without a byte


class Missing(Exception):
    """Why a package is not there, in one sentence."""


def setting(key):
    """A setting as npm has it, from the environment or its files; None if nobody set it."""
    for name, value in os.environ.items():
        if name.lower() == f"npm_config_{key}" and value:
            return value
    files = [os.environ.get("npm_config_userconfig") or os.path.expanduser("~/.npmrc"), "/usr/local/etc/npmrc", "/usr/etc/npmrc", "/etc/npmrc"]
    for file in files:
        try:
            found = re.findall(rf"^\s*{key}\s*=\s*(\S+)", pathlib.Path(file).read_text(encoding="utf-8", errors="replace"), re.M)
        except OSError:
            continue
        if found:
            return found[-1].strip("\"'")
    if shutil.which("npm"):  # it may know more places
        value = subprocess.run(["npm", "config", "get", key], capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False).stdout.strip()
        return None if value in ("", "null", "undefined") else value
    return None


def fits(data, integrity):
    return "sha512-" + base64.b64encode(hashlib.sha512(data).digest()).decode() == integrity


def download(name, registry):
    version = LOCK[name]["version"]
    address = f"{registry.rstrip('/')}/{name}/-/{name}-{version}.tgz"
    trusted = ssl.create_default_context()
    cafile = setting("cafile") or os.environ.get("NODE_EXTRA_CA_CERTS")
    try:
        if cafile:
            trusted.load_verify_locations(cafile)
        with urllib.request.urlopen(address, timeout=PATIENCE, context=trusted) as answer:
            return answer.read()
    except (OSError, ValueError) as error:  # URLError, HTTPError and time-outs are OSErrors
        raise Missing(f"{name} {version} could not be fetched from npm's registry ({getattr(error, 'reason', error)})") from error


def unpack(data, folder):
    """npm's archives hold one folder, whose name does not matter; only plain files below it are taken."""
    with tarfile.open(fileobj=io.BytesIO(data)) as archive:
        for member in archive:
            parts = pathlib.PurePosixPath(member.name).parts[1:]
            if not member.isfile() or not parts or ".." in parts:
                continue
            path = folder.joinpath(*parts)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(archive.extractfile(member).read())


def install(name, folder):
    """Where the package is, after it was put there if need be: FOLDER/NAME-VERSION. Raises Missing with the reason."""
    pinned = LOCK[name]
    place = pathlib.Path(folder) / f"{name}-{pinned['version']}"
    archive = place / "archive.tgz"  # kept: it proves what was unpacked
    if archive.is_file() and fits(archive.read_bytes(), pinned["integrity"]):
        return place
    data = download(name, setting("registry") or REGISTRY)
    if not fits(data, pinned["integrity"]):
        raise Missing(f"{name} {pinned['version']} as the registry has it is not what tests/npm_packages.json pins by its checksum")
    place.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=place.parent) as temporary:
        made = pathlib.Path(temporary) / name
        unpack(data, made)
        (made / "archive.tgz").write_bytes(data)
        shutil.rmtree(place, ignore_errors=True)
        try:
            made.rename(place)
        except OSError:
            if not archive.is_file():  # else another test was faster
                raise
    return place
