package tellosimulator.view.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.Optional;

/**
 * Polls a file once a second for changes by other programs; while it is being written, or is gone,
 * it waits. For one thread.
 */
final class FileWatcher {

  private static final long PERIOD_NANOS = 1_000_000_000;

  /** What changes when a file is written. */
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
   * Whether the file is another one than before, and has been the same for a second.
   *
   * @param nanos of which only differences mean something [ns]
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
