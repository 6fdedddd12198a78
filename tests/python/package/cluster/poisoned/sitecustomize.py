"""Python runs this first in every process of a test with a poisoned point: that point then kills the process that computes it."""

import importlib.abc
import importlib.util
import os
import signal
import sys

SWEEP, CHUNK, INDEX = os.environ["JUDDER_TEST_POISON"].split()
CHUNK, INDEX = int(CHUNK), int(INDEX)


def die():
    os.kill(os.getpid(), signal.SIGKILL)


class Poisoned:
    """A sweep whose one point kills."""

    def __init__(self, sweep):
        self._sweep = sweep

    def __getattr__(self, name):
        return getattr(self._sweep, name)

    def compute(self, chunks, **options):
        if CHUNK in chunks:
            die()
        return self._sweep.compute(chunks, **options)

    def compute_into(self, folder, chunks, **options):
        before = chunks[: chunks.index(CHUNK)] if CHUNK in chunks else chunks
        told = self._sweep.compute_into(folder, before, **options)
        if CHUNK in chunks:
            die()
        return told

    def point(self, chunk, index):
        if (chunk, index) == (CHUNK, INDEX):
            die()
        return self._sweep.point(chunk, index)


class Hook(importlib.abc.MetaPathFinder):
    """Puts the poison where workers get their sweeps from."""

    def find_spec(self, name, path, target=None):
        if name != "judder._cluster.package":
            return None
        sys.meta_path.remove(self)
        spec = importlib.util.find_spec(name)
        load = spec.loader.exec_module

        def exec_module(module):
            load(module)
            own = module.Package.sweep

            def sweep(self, name, expected, threads):
                made = own(self, name, expected, threads)
                return Poisoned(made) if name == SWEEP else made

            module.Package.sweep = sweep

        spec.loader.exec_module = exec_module
        return spec


sys.meta_path.insert(0, Hook())
