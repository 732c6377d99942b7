"""Work in another process: it tells, ends, fails in words, and may die without a word."""

import os
import time
from multiprocessing.process import BaseProcess

from game.computer.aide import Aide
from game.computer.worker import News, Worker


def counts(tell, most):
    for n in range(most):
        tell(n)
    return "counted"


def fails(tell, error):
    raise error


def dies(tell):
    os._exit(3)


def heard(worker):
    """All that it says, until the last."""
    found, end = [], time.monotonic() + 30.0
    while not found or found[-1].kind == "told":
        assert time.monotonic() < end
        if news := worker.look():
            found.append(news)
        time.sleep(0.005)
    return found


def test_it_tells_how_far_it_is_before_it_is_done():
    told = [News("told", 0), News("told", 1)]
    assert heard(Worker(counts, 2)) == [*told, News("done", "counted")]


def test_what_goes_wrong_comes_back_in_words():
    assert heard(Worker(fails, ValueError("no shot"))) == [News("failed", "no shot")]


def test_a_process_that_dies_is_a_failure_and_no_error():
    assert heard(Worker(dies)) == [News("failed", "the process has ended")]


def test_where_no_process_can_begin_that_is_a_failure_too(monkeypatch):
    def refused(process):
        raise BlockingIOError(11, "Resource temporarily unavailable")

    monkeypatch.setattr(BaseProcess, "start", refused)
    ended = News("failed", "the process has ended")
    worker, aide = Worker(counts, 2), Aide(counts)
    assert heard(worker) == [ended]
    worker.cancel()
    assert [aide.look(aide.ask(2)) for _ in range(2)] == [ended, ended]
    aide.close()
