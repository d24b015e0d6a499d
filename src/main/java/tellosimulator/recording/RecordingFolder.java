package tellosimulator.recording;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.files.IoReason;
import tellosimulator.time.WallTime;

/**
 * A folder that contains one folder for each recording. Several programs may use it at the same
 * time. Thread-safe.
 */
public final class RecordingFolder {

  private static final Logger LOG = LoggerFactory.getLogger(RecordingFolder.class);

  /** Maximum length of the scenario's name within the name of a recording [characters]. Decided. */
  private static final int LONGEST_TITLE = 40;

  /**
   * Maximum number of recordings that begin within one second. Decided: more than a user can start.
   */
  private static final int MOST_ALIKE = 10_000;

  /** The pattern of the names that {@link #create} assigns. */
  private static final Pattern NAME =
      Pattern.compile("[0-9]{4}-[0-9]{2}-[0-9]{2}_[0-9]{2}-[0-9]{2}-[0-9]{2}_.*");

  private final Path path;
  private final int kept;
  private final Disk disk;
  private final List<Path> made = new CopyOnWriteArrayList<>();
  private volatile Optional<Path> latest = Optional.empty();

  /** Creates the files of recordings. */
  @FunctionalInterface
  interface Disk {

    /** Creates a new, empty file. Writes to it reach the operating system immediately. */
    OutputStream create(Path file) throws IOException;
  }

  RecordingFolder(Path path, int kept, Disk disk) {
    this.path = path;
    this.kept = kept;
    this.disk = disk;
  }

  /** Returns an object for a folder in which all recordings are kept. */
  public static RecordingFolder at(Path path) {
    return keeping(path, Integer.MAX_VALUE);
  }

  /**
   * Returns an object for a folder in which only the latest recordings are kept. When a recording
   * begins, older ones are deleted.
   *
   * @param count the number of recordings to keep
   */
  public static RecordingFolder keeping(Path path, int count) {
    return new RecordingFolder(
        path,
        count,
        file ->
            Files.newOutputStream(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE));
  }

  public Path path() {
    return path;
  }

  Disk disk() {
    return disk;
  }

  /**
   * Creates a folder with a unique name for a recording.
   *
   * @param title title of the scenario; may be empty
   * @throws IOException if the folder cannot be created
   */
  Path create(WallTime begun, String title) throws IOException {
    Files.createDirectories(path);
    String name = begun.inFileName() + "_" + plain(title);
    for (int number = 1; number < MOST_ALIKE; number++) {
      try {
        Path folder = Files.createDirectory(path.resolve(number == 1 ? name : name + "_" + number));
        made.add(folder);
        return folder;
      } catch (FileAlreadyExistsException e) {
        LOG.debug("{} is taken", e.getFile());
      }
    }
    throw new FileAlreadyExistsException(path.resolve(name).toString());
  }

  /** The folders of the recordings created by this object, in order of creation. */
  public List<Path> made() {
    return List.copyOf(made);
  }

  /** The most recently finished of the recordings created by this object. */
  public Optional<Path> latest() {
    return latest;
  }

  /** Marks a recording as finished: no more data will be written to it. */
  void finished(Path recording) {
    latest = Optional.of(recording);
  }

  /** Returns a title with only those characters that every file system accepts. */
  private static String plain(String title) {
    String plain = title.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "-");
    String cut = plain.substring(0, Math.min(LONGEST_TITLE, plain.length()));
    String bare = cut.replaceAll("^-|-$", "");
    return bare.isEmpty() ? "flight" : bare;
  }

  /**
   * Deletes the oldest recordings if there are too many. Recordings that cannot be deleted are left
   * in place.
   */
  void deleteOld() {
    if (kept == Integer.MAX_VALUE) {
      return;
    }
    try {
      List<Path> recordings = recordings();
      for (Path old : recordings.subList(0, Math.max(0, recordings.size() - kept))) {
        deleteOld(old);
      }
    } catch (IOException | UncheckedIOException e) {
      LOG.warn("Old recordings in {} could not be deleted: {}", path, e.getMessage());
    }
  }

  /** All recordings in this folder, in order from the oldest to the newest. */
  private List<Path> recordings() throws IOException {
    try (Stream<Path> folders = Files.list(path)) {
      return folders
          .filter(folder -> NAME.matcher(folder.getFileName().toString()).matches())
          .filter(folder -> Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS))
          .filter(
              folder ->
                  Files.isRegularFile(RecordingFile.RUN.in(folder), LinkOption.NOFOLLOW_LINKS))
          .sorted(Comparator.comparing(folder -> folder.getFileName().toString()))
          .toList();
    }
  }

  /** Deletes a recording that is too old, unless the user has added folders to it. */
  private static void deleteOld(Path recording) {
    try (Stream<Path> files = Files.list(recording)) {
      if (files.noneMatch(file -> Files.isDirectory(file, LinkOption.NOFOLLOW_LINKS))) {
        delete(recording);
      }
    } catch (IOException e) {
      LOG.warn("The old recording {} could not be deleted: {}", recording, IoReason.of(e));
    }
  }

  /**
   * Deletes a recording. Its {@code run.json} is deleted last, because this file marks the folder
   * as a recording.
   *
   * @throws IOException if a file cannot be deleted
   */
  public static void delete(Path recording) throws IOException {
    List<Path> files;
    try (Stream<Path> all = Files.list(recording)) {
      Comparator<Path> runLast =
          Comparator.comparing(file -> file.endsWith(RecordingFile.RUN.fileName()));
      files = all.sorted(runLast).toList();
    }
    for (Path file : files) {
      Files.delete(file);
    }
    Files.delete(recording);
  }
}
