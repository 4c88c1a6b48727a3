"""Threads, signals, and memory that does not grow."""

import os
import resource
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import pytest

import slipproof

CALLS = int(os.environ.get("SLIPPROOF_PYTHON_CALLS", "3200"))
LONG = "import slipproof; slipproof.verify('proofs/rozenblat-yashin/claims.toml', samples=10**7, threads=1)"


def every_kind_of_call(random_scenes):
    columns = random_scenes(8)
    scene = slipproof.Scene.load("cases/ambiguous.toml")

    def call():
        slipproof.consistent_modes(**columns)
        solution = scene.solve()
        assert solution.motions[0].a and solution.ranges
        slipproof.certify([[2.0, 1], [1, 2]], [-5, -6], [1.0, float("nan")])
        with pytest.raises(slipproof.InputError):
            slipproof.Scene.parse("R = ")
    return call


def test_memory_is_flat(random_scenes):
    call = every_kind_of_call(random_scenes)
    pages = lambda: int(open("/proc/self/statm").read().split()[1])  # noqa: E731
    rounds = CALLS // 4  # a round is four calls
    for _ in range(rounds // 4):
        call()
    before = pages()
    for _ in range(rounds // 4 * 3):
        call()
    grown = (pages() - before) * resource.getpagesize()
    assert grown < 4_000_000 + CALLS * 8, f"{grown} bytes more after {CALLS} calls"


def test_four_threads_get_what_one_gets(random_scenes):
    columns = random_scenes(2000)
    expected = slipproof.consistent_modes(**columns, threads=1).consistent
    document = slipproof.solve("cases/ambiguous.toml").to_json()

    def work(_):
        same = (slipproof.consistent_modes(**columns, threads=1).consistent == expected).all()
        return same and slipproof.solve("cases/ambiguous.toml").to_json() == document

    with ThreadPoolExecutor(4) as pool:
        assert all(pool.map(work, range(16)))


def test_others_run_meanwhile():
    ran = []
    worker = threading.Thread(target=lambda: slipproof.verify("proofs/block-on-incline/claims.toml", samples=300))
    worker.start()
    while worker.is_alive():
        ran.append(time.monotonic())
        time.sleep(0.001)
    assert len(ran) > 3


def interrupted(code, after=0.3):
    """Starts a program, presses Ctrl-C; its exit, and how long it took to end."""
    child = subprocess.Popen([sys.executable, "-c", code], stderr=subprocess.PIPE, text=True)
    assert "ready" in child.stderr.readline()
    time.sleep(after)
    pressed = time.monotonic()
    child.send_signal(signal.SIGINT)
    text = child.communicate(timeout=30)[1]
    return child.returncode, text, time.monotonic() - pressed


READY = "import slipproof, sys, threading; print('ready', file=sys.stderr, flush=True)\n"


@pytest.mark.parametrize("call", [
    LONG,
    "slipproof.search('gripper', samples=10**6, threads=1)",
    "import numpy as np; slipproof.certify_bicycles(dict(F=np.linspace(-9, 9, 10**7), a=3.0, S2=3.0, S3=0.0, N2=9.0, N3=0.1),"
    " scene='cases/ambiguous.toml', threads=1)",
    "import numpy as np; n = 40; W = np.ones((n, n)); slipproof.certify(W, -np.ones(n), np.ones(n), effort=2**62)",
], ids=["verify", "search", "bicycles", "certify"])
def test_ctrl_c_ends_a_long_call(call):
    code, text, _ = interrupted(READY + call)
    assert code == -signal.SIGINT and "KeyboardInterrupt" in text


def test_ctrl_c_ends_calls_in_threads():
    code, text, _ = interrupted(READY + f"""
def work():
    try:
        {LONG.split('; ')[1]}
    except KeyboardInterrupt:
        print('thread ended', file=sys.stderr)
threads = [threading.Thread(target=work) for _ in range(2)]
for t in threads: t.start()
threading.Event().wait()  # not join(): Python 3.11 takes a thread for ended whose join() was interrupted
""")
    assert code == -signal.SIGINT and text.count("thread ended") == 2


def test_ctrl_c_ends_a_batch():
    code, text, _ = interrupted(READY + """
import numpy as np
c = dict(M=94, R=0.3, h=0.56, b2=0.34, b3=0.68, I1=0.01, I2=0.12, I3=0.2, r1=0.09, r2=0.036, L=0.17, J=15.7, f=0.8, g=9.81)
while True: slipproof.consistent_modes(**c, F=np.linspace(-9e3, 9e3, 10**7), threads=1)
""")
    assert code == -signal.SIGINT and "KeyboardInterrupt" in text


def test_a_handler_of_ones_own_is_left_alone():
    code, text, _ = interrupted("""
import signal, sys, slipproof
def mine(*_): print('mine', file=sys.stderr, flush=True); raise SystemExit(7)
signal.signal(signal.SIGINT, mine)
print('ready', file=sys.stderr, flush=True)
""" + LONG)
    assert code == 7 and "mine" in text


@pytest.mark.parametrize("daemon", [True, False])
def test_the_interpreter_may_end_in_the_middle(daemon):
    code = f"""
import slipproof, threading, time, sys
def work():
    try: {LONG.split('; ')[1]}
    except BaseException: pass
threading.Thread(target=work, daemon={daemon}).start()
time.sleep(0.3)
{'sys.exit(3)' if daemon else 'import os; os._exit(3)'}
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 3 and "terminate" not in done.stderr, done.stderr
