"""Looks at djitellopy's pictures as they come."""

import contextlib
import threading
import time

PATIENCE_S = 6
OPENING = 90  # pictures; those of the two seconds that opening takes come all at once


class Watcher(threading.Thread):
    """Sees each picture of a `get_frame_read()` once, and remembers when it came."""

    def __init__(self, reader):
        super().__init__(daemon=True)
        self._reader = reader
        self._blank = self.newest = reader.frame
        self._kept, self._keeps = [], False
        self.times = []
        self.start()

    def run(self):
        while not self._reader.stopped:
            picture = self._reader.frame
            if picture is self.newest:
                time.sleep(0.002)
                continue
            self.newest = picture
            self.times.append(time.monotonic())
            if self._keeps:
                self._kept.append(picture)

    def stop(self):
        """Frees the port."""
        self._reader.stop()
        self._reader.worker.join()

    def first(self):
        """The first picture; what djitellopy shows before it, if none comes."""
        return self.until(lambda picture: picture is not self._blank)

    def until(self, good):
        """The first picture from now on that is good; the newest one if none is in time.

        A client on a busy machine shows what was a while ago.
        """
        patience, seen = time.monotonic() + PATIENCE_S, None
        while time.monotonic() < patience:
            picture = self.newest
            if picture is seen:
                time.sleep(0.005)
            elif good(picture):
                return picture
            seen = picture
        return self.newest

    @contextlib.contextmanager
    def keeping(self):
        """All pictures that come meanwhile, in their order."""
        self._kept, self._keeps = [], True
        yield self._kept
        self._keeps = False

    def most_within(self, seconds):
        """The most pictures that came within so many seconds on end, those at the opening aside."""
        times = self.times[OPENING:]
        most = first = 0
        for last, moment in enumerate(times):
            while moment - times[first] > seconds:
                first += 1
            most = max(most, last - first)
        return most
