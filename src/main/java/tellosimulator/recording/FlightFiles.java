package tellosimulator.recording;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import tellosimulator.time.WallTime;

/**
 * The files of one recording. Lines are buffered until they are flushed. Confined to the writer's
 * thread.
 */
final class FlightFiles implements AutoCloseable {

  private final Path folder;
  private final RecordingFolder.Disk disk;
  private final RunText run;
  private final WallTime begun;
  private final Map<RecordingFile, OpenFile> open = new EnumMap<>(RecordingFile.class);

  /** A file and its buffered lines. */
  private record OpenFile(OutputStream out, StringBuilder lines) {

    /** Passes the lines to the operating system, so that they survive if the program is killed. */
    void flush() throws IOException {
      if (!lines.isEmpty()) {
        out.write(lines.toString().getBytes(StandardCharsets.US_ASCII));
        out.flush();
        lines.setLength(0);
      }
    }

    void close() throws IOException {
      try (out) {
        flush();
      }
    }
  }

  /**
   * Creates the files.
   *
   * @param files the files that consist of lines
   * @throws IOException if a file cannot be written; all files are closed in this case
   */
  FlightFiles(
      Path folder,
      RecordingFolder.Disk disk,
      RunText run,
      WallTime begun,
      List<RecordingFile> files)
      throws IOException {
    this.folder = folder;
    this.disk = disk;
    this.run = run;
    this.begun = begun;
    replace(RecordingFile.RUN, run.begun());
    try {
      for (RecordingFile file : files) {
        open.put(file, new OpenFile(disk.create(file.in(folder)), new StringBuilder()));
      }
    } catch (IOException | RuntimeException e) {
      try (this) {
        throw e;
      }
    }
    if (files.contains(RecordingFile.FLIGHT)) {
      add(RecordingFile.FLIGHT, RecordingFormat.HEADER);
    }
  }

  Path folder() {
    return folder;
  }

  WallTime begun() {
    return begun;
  }

  /** Appends ASCII lines to a file, unless the recording has no such file. */
  void add(RecordingFile file, String text) {
    if (open.containsKey(file)) {
      open.get(file).lines().append(text);
    }
  }

  /** Flushes all files. The inputs come first, so that no other file is ahead of them. */
  void flush() throws IOException {
    for (OpenFile file : open.values()) {
      file.flush();
    }
  }

  /** Writes the final results and closes all files. */
  void finish(Entry.End end, List<VideoRecorders.RecordedVideo> films) throws IOException {
    close();
    if (!end.progress().challenge().goals().isEmpty()) {
      replace(RecordingFile.GOALS, RunText.goals(end));
    }
    replace(RecordingFile.RUN, run.ended(end, films));
  }

  /** Replaces a file atomically: it is either written completely or left unchanged. */
  private void replace(RecordingFile file, String text) throws IOException {
    Path beside = folder.resolve("." + file.fileName());
    try (OutputStream out = disk.create(beside)) {
      out.write((text + "\n").getBytes(StandardCharsets.US_ASCII));
    }
    Files.move(
        beside,
        file.in(folder),
        StandardCopyOption.ATOMIC_MOVE,
        StandardCopyOption.REPLACE_EXISTING);
  }

  /** Closes all files in their current state, as if the recording had been interrupted here. */
  @Override
  public void close() throws IOException {
    List<OpenFile> files = List.copyOf(open.values());
    open.clear();
    IOException failure = null;
    for (OpenFile file : files) {
      try {
        file.close();
      } catch (IOException e) {
        failure = e;
      }
    }
    if (failure != null) {
      throw failure;
    }
  }
}
