package tellosimulator.recording;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.regex.Pattern;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.files.IoReason;
import tellosimulator.time.WallTime;

/**
 * The folder in which recordings are kept, each in a folder of its own. Several programs may use it
 * at the same time. For any thread.
 */
public final class RecordingFolder {

  private static final Logger LOG = LoggerFactory.getLogger(RecordingFolder.class);

  /** Longest name of a scenario in the name of a folder [characters]. Decided. */
  private static final int LONGEST_TITLE = 40;

  /** Recordings that begin in the same second. Decided: more than anybody starts. */
  private static final int MOST_ALIKE = 10_000;

  /** How {@link #create} names folders. */
  private static final Pattern NAME =
      Pattern.compile("[0-9]{4}-[0-9]{2}-[0-9]{2}_[0-9]{2}-[0-9]{2}-[0-9]{2}_.*");

  private final Path path;
  private final int kept;
  private final Disk disk;
  private final List<Path> made = new CopyOnWriteArrayList<>();
  private volatile Optional<Path> latest = Optional.empty();

  /** Makes the files of recordings. */
  @FunctionalInterface
  interface Disk {

    /** A file that is new and empty; what is written to it reaches the system at once. */
    OutputStream create(Path file) throws IOException;
  }

  RecordingFolder(Path path, int kept, Disk disk) {
    this.path = path;
    this.kept = kept;
    this.disk = disk;
  }

  /** One in which all recordings are kept. */
  public static RecordingFolder at(Path path) {
    return keeping(path, Integer.MAX_VALUE);
  }

  /**
   * One in which the latest recordings are kept, and older ones are deleted when another begins.
   *
   * @param count how many are kept
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
   * Makes a folder for a recording, which nobody else has.
   *
   * @param title of the scenario; may be empty
   * @throws IOException if there can be none
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

  /** The folders of recordings that were made through this object, the first one first. */
  public List<Path> made() {
    return List.copyOf(made);
  }

  /** Of the recordings that were made through this object, the one that was finished last. */
  public Optional<Path> latest() {
    return latest;
  }

  /** Nothing more is written into the folder of a recording. */
  void finished(Path recording) {
    latest = Optional.of(recording);
  }

  /** A title as any file system takes it. */
  private static String plain(String title) {
    String plain = title.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "-");
    String cut = plain.substring(0, Math.min(LONGEST_TITLE, plain.length()));
    String bare = cut.replaceAll("^-|-$", "");
    return bare.isEmpty() ? "flight" : bare;
  }

  /** Deletes the oldest recordings, if there are too many; what cannot be deleted stays. */
  void deleteOld() {
    if (kept == Integer.MAX_VALUE) {
      return;
    }
    try {
      List<Path> recordings = recordings();
      for (Path old : recordings.subList(0, Math.max(0, recordings.size() - kept))) {
        delete(old);
      }
    } catch (IOException | UncheckedIOException e) {
      LOG.warn("Old recordings in {} could not be deleted: {}", path, e.getMessage());
    }
  }

  /** All that were made here, the oldest first. */
  private List<Path> recordings() throws IOException {
    List<Path> found = new ArrayList<>();
    try (DirectoryStream<Path> folders = Files.newDirectoryStream(path)) {
      for (Path folder : folders) {
        if (NAME.matcher(folder.getFileName().toString()).matches()
            && Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)
            && Files.isRegularFile(RecordingFile.RUN.in(folder), LinkOption.NOFOLLOW_LINKS)) {
          found.add(folder);
        }
      }
    } catch (DirectoryIteratorException e) {
      throw e.getCause();
    }
    found.sort(Comparator.comparing(folder -> folder.getFileName().toString()));
    return found;
  }

  /** Deletes a recording, but nothing in which somebody keeps folders of his own. */
  private static void delete(Path recording) {
    try {
      List<Path> files = new ArrayList<>();
      try (DirectoryStream<Path> all = Files.newDirectoryStream(recording)) {
        all.forEach(files::add);
      }
      if (files.stream().anyMatch(file -> Files.isDirectory(file, LinkOption.NOFOLLOW_LINKS))) {
        return;
      }
      files.sort(
          Comparator.comparing(
              file -> file.endsWith(RecordingFile.RUN.fileName()))); // last: it says what this is
      for (Path file : files) {
        Files.delete(file);
      }
      Files.delete(recording);
    } catch (IOException e) {
      LOG.warn("The old recording {} could not be deleted: {}", recording, IoReason.of(e));
    }
  }
}
