# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Matching many pairs of files."""

from __future__ import annotations

import contextlib
import csv
import os
import sqlite3
import tempfile
import zlib
from pathlib import Path
from typing import Any, Dict, Iterator, List, Optional, Sequence, Tuple

from . import _batch_run
from ._dask import run_shares
from ._folders import load
from ._match import Match
from ._options import check_options, takes_options
from ._progress import shows_progress
from ._types import PathLike, Progress

#: The pairs, in the folder of the results. A pair cannot have this name.
_LIST = "pairs-listed.csv"
_WHOLE_NUMBERS = ("source_vertices_matched", "source_vertices_unmatched")
_NUMBERS = ("stretch", "unreached", "ambiguity", "seconds")


def _value(column, text):
    if column in _WHOLE_NUMBERS:
        return int(text) if text else None
    if column in _NUMBERS:
        return float(text) if text else None
    if column == "mirrored":
        return text == "1" if text else None
    return text


def _read_table(path):
    with open(path, newline="", encoding="utf-8", errors="surrogateescape") as file:
        rows = csv.DictReader(file)
        return [{name: _value(name, text) for name, text in row.items()} for row in rows]


def _unpack(folder, name, place):
    """Writes the files of a packed result into a folder; False if no archive has it."""
    for archive in sorted(Path(folder).glob("results*.sqlar")):
        connection = sqlite3.connect(f"file:{archive.absolute().as_posix()}?mode=ro", uri=True)
        try:
            rows = connection.execute(
                "SELECT name, sz, data FROM sqlar "
                "WHERE name >= ? AND name < ? AND data IS NOT NULL",
                (name + "/", name + "0"),
            ).fetchall()
        finally:
            connection.close()
        for file, size, data in rows:
            content = data if len(data) == size else zlib.decompress(data)
            (place / file.rpartition("/")[2]).write_bytes(content)
        if rows:
            return True
    return False


class Batch:
    """The result of `batch`: a table, and by the name of a pair its `Match`, as in
    `batch["a__b"]`. `len` and iteration are those of the names, in the order of the pairs."""

    #: Where the results are.
    folder: str
    #: The rows of pairs.csv: name, source, target, outcome ("matched" or "failed"), fit and what it
    #: measures, reasons, warnings, seconds and error; None where a number is missing.
    table: List[Dict[str, Any]]

    def __init__(self, folder):
        self.folder = os.fspath(folder)
        self.table = _read_table(os.path.join(self.folder, "pairs.csv"))
        self._rows = {row["name"]: row for row in self.table}

    @property
    def failed(self) -> List[Dict[str, Any]]:
        """Those rows whose pair could not be matched; "error" says why."""
        return [row for row in self.table if row["outcome"] == "failed"]

    def __getitem__(self, name: str) -> Match:
        """The result of a pair, read from its files. Raises KeyError if there is no such pair, and
        OSError if it failed."""
        row = self._rows[name]
        if row["outcome"] == "failed":
            raise OSError(f"{name}: {row['error']}")
        folder = Path(self.folder, name)
        if folder.is_dir():
            return load(folder)
        with tempfile.TemporaryDirectory() as place:
            if not _unpack(self.folder, name, Path(place)):
                raise FileNotFoundError(f"{folder} is gone")
            return load(place, row["source"], row["target"])

    def __iter__(self) -> Iterator[str]:
        return iter(self._rows)

    def __len__(self) -> int:
        return len(self.table)

    def __repr__(self):
        matched = len(self.table) - len(self.failed)
        return f"<isomatch.Batch in {self.folder}: {matched} of {len(self.table)} pairs matched>"


def _listed(pair):
    if isinstance(pair, (str, bytes)) or len(pair) not in (2, 3):
        raise ValueError(
            f"pairs: expected (source, target) or (source, target, name), not {pair!r}"
        )
    files = [os.path.abspath(os.fspath(file)) for file in pair[:2]]
    fields = [*files, *pair[2:]]
    for text in fields:
        if not isinstance(text, str) or "\n" in text or "\r" in text:
            raise ValueError(f"pairs: {text!r} is no name of a file or result")
    return ",".join('"' + text.replace('"', '""') + '"' for text in fields) + "\n"


def _name(pair):
    return pair[2] if len(pair) > 2 else "__".join(Path(file).stem for file in pair[:2])


def _check_names(pairs):
    known = set()
    for pair in pairs:
        name = _name(pair)
        if name in known:
            raise ValueError(
                f"pairs: two have the name {name!r}; (source, target, name) gives others"
            )
        known.add(name)


def _begun(pairs, folder, resume, words):
    """Writes the list into the folder; what is wrong with it is said before."""
    pairs = list(pairs)
    lines = [_listed(pair) for pair in pairs]
    if not lines:
        raise ValueError("pairs: there is none")
    _check_names(pairs)
    if os.path.exists(os.path.join(folder, "batch.json")) and not resume:
        raise FileExistsError(f"{folder}: holds a batch already: resume=True goes on with it")
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, _LIST)
    with open(path + ".unfinished", "w", encoding="utf-8", errors="surrogateescape") as file:
        file.writelines(lines)
    os.replace(path + ".unfinished", path)
    return _batch_run.Job(folder, path, tuple(words))


def _undo(job):
    """Leaves nothing behind where the program would not begin."""
    if not os.path.exists(os.path.join(job.folder, "batch.json")):
        os.remove(job.list)
        with contextlib.suppress(OSError):
            os.rmdir(job.folder)


def _memory_words(memory):
    if isinstance(memory, bool) or not isinstance(memory, (int, float)):
        raise TypeError(f"memory: expected GiB, not {memory!r}")
    return ["--memory", str(memory)]


def _run_alone(job, count, progress):
    def watch(lines):
        if progress and lines > 0:
            progress(min(lines, count) / count, f"{lines} of {count} pairs")

    _batch_run.run(job, "--resume", log="batch.log", watch=watch)


@takes_options("tracked")
@shows_progress
def batch(
    pairs: Sequence[Tuple[PathLike, ...]],
    output: PathLike,
    *,
    client: Any = None,
    resume: bool = False,
    packed: bool = False,
    target_to_source: bool = False,
    memory: float = 1.0,
    threads: Optional[int] = None,
    shards: Optional[int] = None,
    retries: int = 3,
    progress: Progress = None,
    **options,
) -> Batch:
    """Matches many pairs of mesh files by the tracked method, as `isomatch batch` does: the same
    files, byte for byte. Each shape is read and prepared once, as long as memory lasts; what is
    wrong with a file fails its pairs and no other.

    Parameters
    ----------
    pairs
        (source, target) or (source, target, name) each: paths of mesh files, and what the result is
        called, by default source__target without endings. No two may have the same name.
    output
        The folder for the results: a folder for each pair, and pairs.csv.
    client
        A dask.distributed.Client, whose workers then match shares of the pairs. They need
        isomatch, and see the meshes and the folder under the same paths. A share whose worker
        dies is gone on with by another.
    resume
        Whether to go on with a batch that is in the folder; finished pairs stay as they are.
    packed
        Write archives in the place of folders: a file of SQLite a process.
    target_to_source
        Write the inverse maps as well.
    memory
        For shapes that are kept for other pairs, in GiB a process.
    threads
        Pairs that are matched at a time, by default as many as the machine has threads; with a
        client in each task, by default one.
    shards
        With a client: into how many shares the pairs are split, by default four for each thread of
        a worker, as far as there are pairs.
    retries
        With a client: how often a share that failed is tried again, other than by bad input.
    progress
        As in `match`, after each pair, or share with a client.

    Returns
    -------
    Batch
        `failed` has the pairs that could not be matched; they raise nothing.

    Raises
    ------
    ValueError
        The list or an option is wrong.
    OSError
        The folder holds a batch of other options, or one at all without `resume`; files cannot be
        written.
    RuntimeError
        The program was killed.
    KeyboardInterrupt
        Ctrl-C. Finished pairs stay, for `resume`.
    """
    check_options(options, "tracked", function="batch")
    words = _batch_run.option_words(
        {**options, "packed": packed, "target_to_source": target_to_source}
    ) + _memory_words(memory)
    if threads is None and client is not None:
        threads = 1
    if threads is not None:
        words += ["--threads", str(threads)]
    pairs = list(pairs)
    job = _begun(pairs, os.path.abspath(os.fspath(output)), resume, words)
    try:
        if client is None:
            _run_alone(job, len(pairs), progress)
        else:
            run_shares(client, job, len(pairs), shards, retries, progress)
            _batch_run.run(job, "--merge")
    except (ValueError, OSError):
        _undo(job)
        raise
    return Batch(job.folder)
