"""Work that is spread over workshops."""

import os
import threading
from collections import deque
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor

from workshop import Workshop, alone


def spread(pieces: Iterable, files: list[str], jobs: int, bench: Callable, done: Callable) -> None:
    """Takes the pieces in order, each to a free workshop: done(piece, bench(workshop)(piece)). Stops at an error."""
    waiting, lock, stop = deque(pieces), threading.Lock(), threading.Event()
    jobs = min(jobs, len(waiting))

    def work(number: int) -> None:
        try:
            attempt = bench(Workshop(number, files, max(1, (os.cpu_count() or 1) // jobs)))
            while not stop.is_set():
                with lock:
                    if not waiting:
                        return
                    piece = waiting.popleft()
                result = attempt(piece)
                with lock:
                    done(piece, result)
        finally:
            if waiting:
                stop.set()

    if not waiting:
        return
    with alone(), ThreadPoolExecutor(jobs) as threads:
        for future in [threads.submit(work, number) for number in range(jobs)]:
            future.result()
