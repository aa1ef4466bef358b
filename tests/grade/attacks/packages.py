"""Packs a submission in the ways that students, and attackers, do. Each function gets a folder that does not exist yet (the
student's place in the class), and the text of the exercise as bytes."""
import io
import os
import pathlib
import stat
import tarfile
import zipfile


def folder(place, text):
    place.mkdir()
    (place / "exercise.h").write_bytes(text)


def changed(change):
    return lambda place, text: folder(place, change(text))


def empty_folder(place, text):
    place.mkdir()


def zipped(entries):
    """A .zip of (name or ZipInfo, bytes); the exercise stands for None."""
    def pack(place, text):
        with zipfile.ZipFile(f"{place}.zip", "w", zipfile.ZIP_DEFLATED) as archive:
            for name, content in entries:
                archive.writestr(name, text if content is None else content)
    return pack


def zip_link(place, text):
    info = zipfile.ZipInfo("exercise.h")
    info.external_attr = (stat.S_IFLNK | 0o777) << 16
    zipped([(info, b"/etc/passwd")])(place, text)


def zip_bomb(place, text):
    with zipfile.ZipFile(f"{place}.zip", "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("exercise.h", text)
        with archive.open("bomb.txt", "w", force_zip64=True) as bomb:
            for _ in range(1024):
                bomb.write(b"\0" * (1 << 20))


def noise(place, text):
    pathlib.Path(f"{place}.zip").write_bytes(b"PK\3\4" + bytes(range(256)) * 8)


def tar(place, text, kind=None):
    with tarfile.open(f"{place}.tar.gz", "w:gz") as archive:
        info = tarfile.TarInfo("exercise.h")
        if kind is not None:
            info.type = kind
            info.devmajor, info.devminor = 1, 5
            archive.addfile(info)
        else:
            info.size = len(text)
            archive.addfile(info, io.BytesIO(text))


def link(place, text):
    place.mkdir()
    (place / "exercise.h").symlink_to("/etc/passwd")


def fifo(place, text):
    place.mkdir()
    os.mkfifo(place / "exercise.h")


def folder_as_file(place, text):
    (place / "exercise.h").mkdir(parents=True)


def two_files(place, text):
    folder(place, text)
    (place / "exercise02.h").write_bytes(text + b"// another\n")


PACKAGES = {
    "folder": folder,
    "empty-folder": empty_folder,
    "zip": zipped([("exercise.h", None)]),
    "zip-folder": zipped([("my homework/lessons/02_mirrors/exercise.h", None), ("my homework/notes.txt", b"hello")]),
    "zip-slip": zipped([("../../exercise.h", None)]),
    "zip-bomb": zip_bomb,
    "zip-link": zip_link,
    "zip-noise": noise,
    "tar.gz": tar,
    "tar-device": lambda place, text: tar(place, text, tarfile.CHRTYPE),
    "link": link,
    "fifo": fifo,
    "folder-as-file": folder_as_file,
    "large": changed(lambda text: text + b"// padding\n" * 100000),
    "nul": changed(lambda text: text + b"// \0\n"),
    "two-files": two_files,
    "crlf": changed(lambda text: text.replace(b"\n", b"\r\n")),
    "bom": changed(lambda text: b"\xef\xbb\xbf" + text),
    "latin1": changed(lambda text: "// Übung, größer als nötig: 90°\n".encode("latin-1") + text),
}
