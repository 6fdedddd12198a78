"""What may happen to a sweep: kills, damage, other cases, clocks, Ctrl-C, full and read-only disks."""

import os
import random
import shutil
import signal
import subprocess
import time

import pytest

from sweep_cases import GRID, assert_same, case, chunks, run, tree


def test_kills_at_any_instant(run, case, judder, tmp_path):
    case(GRID.replace("points = 40", "points = 80").replace("points = 30", "points = 60").replace("chunk = 30", "chunk = 20"))
    run("run", "case.toml", "-o", "calm", "--threads", 1)
    whole = len(chunks(tmp_path / "calm"))
    instants = random.Random(20)
    kills, found = 0, set()

    def killed(level, delay):
        """Kills a run a while after so many chunks are there, if it does not come through before."""
        process = subprocess.Popen(
            [judder, "run", "case.toml", "-o", "stormy", "--threads", "1"], cwd=tmp_path, stderr=subprocess.DEVNULL
        )
        while process.poll() is None and len(chunks(tmp_path / "stormy")) < level:
            time.sleep(0.001)
        try:
            process.wait(timeout=delay)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)
            process.wait()
            found.add(len(chunks(tmp_path / "stormy")))
            return 1
        assert process.returncode == 0
        return 0

    # while it begins, and while there is work, at levels that rise with the kills
    for number in range(25):
        kills += killed(instants.randint(0, whole * number // 25), instants.uniform(0.0, 0.02))
    assert kills >= 20 and len(found) > 8, "kills that fell while there was work"
    # while it completes the study
    for _ in range(5):
        kills += killed(whole, instants.uniform(0.0, 0.3))
    run("run", "case.toml", "-o", "stormy", "--threads", 1)
    assert_same(tmp_path / "calm", tmp_path / "stormy")


def test_damaged_chunks_are_found_and_computed_anew(run, case, tmp_path):
    case(GRID)
    run("run", "case.toml", "-o", "sound")
    run("run", "case.toml", "-o", "study")
    truncated, turned, empty, lost, swapped, other = chunks(tmp_path / "study")[3:9]
    truncated.write_bytes(truncated.read_bytes()[:-100])
    content = bytearray(turned.read_bytes())
    content[len(content) // 3] ^= 1
    turned.write_bytes(content)
    empty.write_bytes(b"")
    lost.unlink()
    shutil.copy(other, swapped)
    said = run("run", "case.toml", "-o", "study")
    assert "4 damaged chunks were computed anew" in said.stderr
    assert_same(tmp_path / "sound", tmp_path / "study")


def test_what_belongs_to_another_case_is_refused(run, case, tmp_path):
    case(GRID)
    run("run", "case.toml", "-o", "study")
    run("run", "case.toml", "-o", "other", "--set", "operation.normal_load=2e-5")
    before = tree(tmp_path / "study")

    # another case on the same folder
    said = run("run", "case.toml", "-o", "study", "--set", "operation.normal_load=2e-5", code=2)
    assert "results.zarr/map" in said.stderr and "--fresh" in said.stderr
    assert {name: before[name] for name in before if "values/c." in name}.items() <= tree(tmp_path / "study").items()

    # a chunk of another case in the place of one that the study lists is damage
    ours, theirs = chunks(tmp_path / "study")[5], chunks(tmp_path / "other")[5]
    ours.unlink()
    shutil.copy(theirs, ours)
    said = run("run", "case.toml", "-o", "study")
    assert f"/{ours.name}: " in said.stderr and "1 damaged chunk was computed anew" in said.stderr
    assert tree(tmp_path / "study") == before

    # where no list tells what belongs here, it is not ours to overwrite
    run("run", "case.toml", "-o", "part", "--shard", "1/2")
    done = {path.name for path in chunks(tmp_path / "part")}
    theirs = next(path for path in chunks(tmp_path / "other") if path.name not in done)
    foreign = shutil.copy(theirs, chunks(tmp_path / "part")[0].with_name(theirs.name))
    said = run("run", "case.toml", "-o", "part", code=2)
    assert theirs.name in said.stderr and "another case" in said.stderr
    assert foreign.read_bytes() == theirs.read_bytes(), "what is not ours is not overwritten"
    foreign.unlink()
    run("run", "case.toml", "-o", "part")
    assert tree(tmp_path / "part") == before

    run("run", "case.toml", "-o", "study", "--fresh", "--set", "operation.normal_load=2e-5")
    assert_same(tmp_path / "other", tmp_path / "study")


CLOCK = r"""
#define _GNU_SOURCE
#include <dlfcn.h>
#include <sys/time.h>
#include <time.h>

/* Every call another day: forwards, backwards. The monotonic clock stays what it is. */
static long jump(void) {
    static unsigned calls;
    return (calls++ % 7 - 3) * 40000000L;
}

int clock_gettime(clockid_t clock, struct timespec *now) {
    static int (*real)(clockid_t, struct timespec *);
    if (!real) real = (int (*)(clockid_t, struct timespec *))dlsym(RTLD_NEXT, "clock_gettime");
    int code = real(clock, now);
    if (clock == CLOCK_REALTIME) now->tv_sec += jump();
    return code;
}

time_t time(time_t *place) {
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    if (place) *place = now.tv_sec;
    return now.tv_sec;
}

int gettimeofday(struct timeval *now, void *zone) {
    struct timespec exact;
    clock_gettime(CLOCK_REALTIME, &exact);
    now->tv_sec = exact.tv_sec;
    now->tv_usec = exact.tv_nsec / 1000;
    return 0;
}
"""


def test_a_clock_that_jumps(run, case, tmp_path):
    case(GRID)
    run("run", "case.toml", "-o", "calm")
    shim = {}
    (tmp_path / "clock.c").write_text(CLOCK, "utf-8")
    if shutil.which("gcc"):
        subprocess.run(["gcc", "-shared", "-fPIC", "-o", "clock.so", "clock.c", "-ldl"], cwd=tmp_path, check=True)
        shim = {"env": {**os.environ, "LD_PRELOAD": str(tmp_path / "clock.so")}}
    for part, date in (("1/3", 0), ("2/3", 4_100_000_000), ("3/3", 1_000_000)):
        run("run", "case.toml", "-o", "jumpy", "--shard", part, **shim)
        for path in (tmp_path / "jumpy").rglob("*"):
            os.utime(path, (date, date))
    chunks(tmp_path / "jumpy")[0].unlink()
    run("run", "case.toml", "-o", "jumpy", **shim)
    for path in (tmp_path / "jumpy").rglob("*"):
        os.utime(path, (4_100_000_000, 4_100_000_000))
    said = run("run", "case.toml", "-o", "jumpy", **shim)
    assert "done before: map" in said.stderr
    assert_same(tmp_path / "calm", tmp_path / "jumpy")


def test_ctrl_c_keeps_the_chunks_that_are_done(run, case, judder, tmp_path):
    case(GRID)
    run("run", "case.toml", "-o", "calm")
    process = subprocess.Popen(
        [judder, "run", "case.toml", "-o", "study", "--threads", "1"], cwd=tmp_path, stderr=subprocess.PIPE, text=True
    )
    while len(chunks(tmp_path / "study")) < 3:
        assert process.poll() is None
        time.sleep(0.002)
    process.send_signal(signal.SIGINT)
    said = process.communicate(timeout=60)[1]
    assert process.returncode == 1 and "what was done is kept" in said
    kept = {path: path.read_bytes() for path in chunks(tmp_path / "study")}
    assert 3 <= len(kept) < len(chunks(tmp_path / "calm"))
    inodes = {path: path.stat().st_ino for path in kept}
    run("run", "case.toml", "-o", "study")
    assert inodes == {path: path.stat().st_ino for path in kept}, "nothing is computed twice"
    assert_same(tmp_path / "calm", tmp_path / "study")


MOUNTED = """
mount -t tmpfs -o size=$SIZE none disk && touch mounted && {{ {script} ; }}
"""


def in_a_file_system(judder, folder, size, script):
    """Runs a script beside a file system of that size, which lives as long as the script."""
    (folder / "disk").mkdir()
    said = subprocess.run(
        ["unshare", "--user", "--map-root-user", "--mount", "sh", "-c", MOUNTED.format(script=script)],
        cwd=folder, capture_output=True, text=True, env={**os.environ, "JUDDER": str(judder), "SIZE": size},
    )
    if not (folder / "mounted").exists():
        pytest.skip(f"SKIPPED: needs `unshare` and leave to mount: {said.stderr}")
    return said


@pytest.mark.skipif(not shutil.which("unshare"), reason="SKIPPED: needs `unshare`")
def test_a_full_disk_is_named_and_leaves_nothing_half_written(run, case, judder, tmp_path):
    case(GRID)
    run("run", "case.toml", "-o", "calm", "--shard", "1/1")
    said = in_a_file_system(judder, tmp_path, "176k", """
        "$JUDDER" run case.toml -o disk/study --threads 1; code=$?
        find disk -name '*.partial' > partial; ls disk/study/results.zarr/map/values > done
        mount -o remount,size=10m disk; "$JUDDER" run case.toml -o disk/study --shard 1/1 2> resumed || exit 9
        cp -r disk/study study; exit $code""")
    assert said.returncode == 1, said.stderr
    assert "no room for" in said.stderr and "what is done is kept" in said.stderr
    assert (tmp_path / "partial").read_text() == ""
    done = [name for name in (tmp_path / "done").read_text().split() if name.startswith("c.")]
    assert 0 < len(done) < len(chunks(tmp_path / "calm"))
    assert [path.read_bytes() for path in chunks(tmp_path / "calm")] == [path.read_bytes() for path in chunks(tmp_path / "study")]


@pytest.mark.skipif(not shutil.which("unshare"), reason="SKIPPED: needs `unshare`")
def test_a_read_only_folder_is_named(case, judder, tmp_path):
    case(GRID)
    said = in_a_file_system(judder, tmp_path, "10m", """
        "$JUDDER" run case.toml -o disk/study --shard 1/2 2> first || exit 9
        mount -o remount,ro disk; "$JUDDER" run case.toml -o disk/study""")
    assert said.returncode == 1, said.stderr
    assert "disk/study" in said.stderr and "not writable" in said.stderr.lower(), said.stderr
