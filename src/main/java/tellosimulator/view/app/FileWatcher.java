package tellosimulator.view.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.Optional;

/**
 * Detects changes that other programs make to a file. The file is checked at most once a second,
 * and only when {@link #changed} is called. No change is reported while the file is missing or
 * still being written. Not thread-safe.
 */
final class FileWatcher {

  private static final long PERIOD_NANOS = 1_000_000_000;

  /** The attributes that change when a file is written. */
  private record Stamp(FileTime time, long size) {}

  private final Path file;
  private Optional<Stamp> known;
  private Optional<Stamp> seen;
  private long lookedNanos;
  private boolean looked;

  FileWatcher(Path file) {
    this.file = file;
    this.known = stamp();
    this.seen = known;
  }

  /**
   * Returns whether the file has a change that has not been reported yet. A change is reported once
   * two consecutive checks, at least a second apart, have found the same state; between checks, the
   * result is false.
   *
   * @param nanos the current time; only differences are meaningful [ns]
   */
  boolean changed(long nanos) {
    if (looked && nanos - lookedNanos < PERIOD_NANOS) {
      return false;
    }
    looked = true;
    lookedNanos = nanos;
    Optional<Stamp> now = stamp();
    boolean changed = now.isPresent() && now.equals(seen) && !now.equals(known);
    seen = now;
    if (changed) {
      known = now;
    }
    return changed;
  }

  private Optional<Stamp> stamp() {
    try {
      BasicFileAttributes found = Files.readAttributes(file, BasicFileAttributes.class);
      return Optional.of(new Stamp(found.lastModifiedTime(), found.size()));
    } catch (IOException e) {
      return Optional.empty();
    }
  }
}
