#!/usr/bin/env python3
"""The Khronos validator on the files of write_models, and what it does not check: gltf_test.py WRITE_MODELS VALIDATOR_FOLDER

The validator is fetched into the folder if it is not there (tests/npm_packages.py). Exit codes: 0 all holds, 1 something does
not, 77 only the checks that need no validator were made (ctest: skipped).
"""
import base64
import json
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import npm_packages  # noqa: E402

SCENES = [(2, "02_mirrors", "pure_specular"), (2, "02_mirrors", "facing_mirrors"), (3, "03_partial_reflection", "half_specular"),
          (4, "04_hdr_sky", "probe"), (5, "05_refraction", "glass_ball"), (5, "05_refraction", "bubble"),
          (5, "05_refraction", "slab"), (6, "06_fresnel", "half_and_glass"), (6, "06_fresnel", "water"),
          (6, "06_fresnel", "gem"), (7, "07_recursion_caps", "mirror_box"), (7, "07_recursion_caps", "glass_shadow"),
          (8, "08_phong", "everything"), (8, "08_phong", "exponents")]
SMALL = 1 << 20  # bytes of a tree of ten rays
VALIDATE = """
const validator = require(process.argv[1]);
const fs = require('fs');
(async () => {
  for (const file of process.argv.slice(2)) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {maxIssues: 1000000});
    const seen = {};
    for (const m of report.issues.messages) {
      const key = m.severity + ' ' + m.code;
      seen[key] = seen[key] || {severity: m.severity, code: m.code, count: 0, first: m.message + ' ' + m.pointer};
      ++seen[key].count;
    }
    console.log(JSON.stringify({file, issues: Object.values(seen)}));
  }
})().catch(error => { console.error(error); process.exit(1); });
"""
failures = []


def expect(holds, sentence):
    if not holds:
        failures.append(sentence)


def parts(path):
    """The JSON and the buffer of a .glb or .gltf file."""
    data = path.read_bytes()
    if path.suffix == ".gltf":
        document = json.loads(data)
        uris = [buffer["uri"] for buffer in document.get("buffers", [])]
        expect(all(uri.startswith("data:application/octet-stream;base64,") for uri in uris), f"{path.name}: not self-contained")
        return document, base64.b64decode(uris[0].split(",")[1]) if uris else b""
    magic, version, length = struct.unpack_from("<4sII", data)
    expect((magic, version, length) == (b"glTF", 2, len(data)), f"{path.name}: wrong header")
    size, kind = struct.unpack_from("<I4s", data, 12)
    expect(kind == b"JSON" and size % 4 == 0, f"{path.name}: wrong JSON chunk")
    rest = data[20 + size:]
    if rest:
        binary, kind = struct.unpack_from("<I4s", rest)
        expect(kind == b"BIN\0" and binary % 4 == 0 and binary == len(rest) - 8, f"{path.name}: wrong BIN chunk")
    return json.loads(data[20:20 + size]), rest[8:]


def check_structure(path):
    document, buffer = parts(path)
    for view in document.get("bufferViews", []):
        expect(view["byteOffset"] % 4 == 0 and view["byteOffset"] + view["byteLength"] <= len(buffer),
               f"{path.name}: a buffer view is not aligned or not inside")
    roots = document["scenes"][0].get("nodes", [])
    reached, waiting = set(), list(roots)
    while waiting:
        node = waiting.pop()
        expect(node not in reached, f"{path.name}: node {node} has two parents")
        reached.add(node)
        waiting += document["nodes"][node].get("children", [])
    expect(len(reached) == len(document.get("nodes", [])), f"{path.name}: nodes outside the scene")
    other = document, buffer
    if path.suffix == ".glb":
        other = parts(path.with_suffix(".gltf"))
        for buffers in (document, other[0]):
            for entry in buffers.get("buffers", []):
                entry.pop("uri", None)
        expect((document, buffer) == other, f"{path.name}: differs from the .gltf")


def find_validator(folder):
    if not shutil.which("node"):
        raise npm_packages.Missing("node, which runs the Khronos validator, is not installed")
    return npm_packages.install("gltf-validator", folder)


def validate(validator, files):
    done = subprocess.run(["node", "-e", VALIDATE, str(validator), *map(str, files)], capture_output=True, text=True, check=False)
    expect(done.returncode == 0, f"the validator failed: {done.stderr[:500]}")
    reports = [json.loads(line) for line in done.stdout.splitlines()]
    expect(len(reports) == len(files), f"the validator read {len(reports)} of {len(files)} files")
    for report in reports:
        for issue in report["issues"]:
            expect(False, f"{pathlib.Path(report['file']).name}: {issue['code']} ({issue['count']}): {issue['first']}")


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: gltf_test.py WRITE_MODELS VALIDATOR_FOLDER")
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    with tempfile.TemporaryDirectory() as place:
        arguments = []
        for number, lesson, scene in SCENES:
            arguments += [str(number), f"lessons/{lesson}/scenes/{scene}.toml"]
        done = subprocess.run([program, place, *arguments], capture_output=True, text=True, check=False)
        print(done.stdout, end="")
        if done.returncode != 0:
            sys.exit(f"write_models failed: {done.stderr}")
        files = sorted(pathlib.Path(place).glob("*.gl*"))
        expect(len(files) == 2 * (len(SCENES) + 5), f"{len(files)} files")
        for path in files:
            check_structure(path)
            rays = len([n for n in parts(path)[0].get("nodes", []) if "depth" in n.get("extras", {})])
            expect(rays > 10 or path.suffix == ".gltf" or path.stat().st_size < SMALL,
                   f"{path.name}: {path.stat().st_size} bytes for {rays} rays")
        missing = ""
        try:
            validate(find_validator(folder), files)
        except npm_packages.Missing as reason:
            missing = reason
    for failure in failures:
        print("FAILED:", failure, file=sys.stderr)
    if failures:
        sys.exit(1)
    if missing:
        print(f"skipped: only the structure of glTF files was checked: {missing}")
        sys.exit(77)
    print(f"{len(files)} files are valid")


main()
