package tellosimulator.grade;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.PathMatcher;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipFile;
import tellosimulator.scenario.Assignment;
import tellosimulator.words.Phrase;

/**
 * Collects the hand-ins of a class: folders, single files, or a zip of these. Each is copied, so
 * that nothing that it contains leads out of its folder. Confined to the calling thread.
 */
final class HandIns {

  /**
   * The folders of a zip from Moodle, which before Moodle 4.1 end with an underscore. Documented:
   * mod_assign, "Download all submissions".
   */
  private static final Pattern MOODLE =
      Pattern.compile("(?<name>.+?)_(?<id>[0-9]+)_assignsubmission_file(_(?<file>.*))?");

  /** Maximum number of files of a hand-in. Decided: more than a project with its libraries has. */
  private static final int MOST_FILES = 10_000;

  /** Folders of development tools, and texts that were typed into Moodle; they are not copied. */
  private static final Pattern LEFT_OUT =
      Pattern.compile("\\..*|__pycache__|__MACOSX|node_modules|.*_assignsubmission_onlinetext_.*");

  /** Single files that are hand-ins. */
  private static final Pattern SINGLE = Pattern.compile("(?i).+\\.(py|java|jar|js|zip)");

  /** Maximum length of a file's name [bytes]. Documented: NAME_MAX of Linux. */
  private static final int LONGEST_NAME = 255;

  /** Maximum length of the name of a folder that is made here. Decided: fits in a file's name. */
  private static final int LONGEST_FOLDER = 60;

  private static final Phrase DAMAGED =
      Phrase.of("The zip is damaged or encrypted, or its names are not in UTF-8.");

  private static final Phrase IMPOSSIBLE =
      Phrase.of("The zip has a file whose name is not possible here.");

  private final Assignment assignment;
  private final Path into;
  private final long mostBytes;
  private final Map<String, Phrase> problems = new HashMap<>();
  private long bytes;
  private int files;

  /**
   * Creates a collection.
   *
   * @param into an empty folder for the copies
   */
  HandIns(Assignment assignment, Path into) {
    this.assignment = assignment;
    this.into = into;
    this.mostBytes = (long) assignment.limits().diskMb() << 20;
  }

  /**
   * Collects all hand-ins.
   *
   * @param from a folder, a zip, or a single file
   * @param roster the students of the class, who get a row even if they handed in nothing
   * @throws IOException if the folder or the zip cannot be read
   */
  List<HandIn> collect(Path from, List<Roster.Student> roster) throws IOException {
    if (!Files.exists(from)) {
      throw new IOException(
          from + " does not exist: expected a folder with hand-ins, a zip, or one program");
    }
    Path root = into.resolve("all");
    Files.createDirectories(root);
    if (Files.isRegularFile(from) && isZip(from)) {
      try {
        unzip(from, root, true);
      } catch (ZipException e) {
        throw new IOException(
            from + " is no zip, or it is damaged, encrypted, or has names that are not in UTF-8",
            e);
      }
    } else if (Files.isRegularFile(from)) {
      copyOne(from, root.resolve(from.getFileName()), from.getFileName().toString());
    } else {
      try (Stream<Path> children = Files.list(from)) {
        for (Path child : children.sorted().toList()) {
          String name = child.getFileName().toString();
          boolean taken = Files.isDirectory(child) || SINGLE.matcher(name).matches();
          if (taken && !LEFT_OUT.matcher(name).matches()) {
            copyIfReadable(child, root, name);
          }
        }
      }
    }
    return handIns(root, roster);
  }

  private void copyIfReadable(Path from, Path root, String name) throws IOException {
    try {
      copyOne(from, root.resolve(name), name);
    } catch (FileSystemException | UncheckedIOException e) {
      refuse(
          root,
          name,
          Phrase.of("Some of its files cannot be read, or their names are not possible here."));
    }
  }

  private List<HandIn> handIns(Path root, List<Roster.Student> roster) throws IOException {
    Map<String, HandIn> found = new TreeMap<>();
    List<Roster.Student> missing = new ArrayList<>(roster);
    try (Stream<Path> children = Files.list(root)) {
      for (Path child : children.sorted().toList()) {
        HandIn handIn = handIn(child, missing, found::containsKey);
        found.put(handIn.folder(), handIn);
      }
    }
    for (Roster.Student student : missing) {
      String folder = unique(student.name(), found::containsKey);
      found.put(
          folder,
          new HandIn(
              student.name(),
              student.id(),
              student.group(),
              folder,
              "",
              root,
              "",
              Optional.of(Phrase.of("Nothing was handed in."))));
    }
    return List.copyOf(found.values());
  }

  /**
   * Returns a hand-in.
   *
   * @param missing the students whose hand-ins have not been found yet; that of this one is removed
   */
  private HandIn handIn(Path child, List<Roster.Student> missing, Function<String, Boolean> taken)
      throws IOException {
    String original = child.getFileName().toString();
    Matcher moodle = MOODLE.matcher(original);
    boolean ofMoodle = moodle.matches();
    String name = ofMoodle ? moodle.group("name") : original.replaceFirst("\\.[A-Za-z]+$", "");
    String id = ofMoodle ? moodle.group("id") : "";
    Optional<Roster.Student> student =
        missing.stream()
            .filter(each -> !each.id().isEmpty() && List.of(id, name).contains(each.id()))
            .findFirst()
            .or(() -> missing.stream().filter(each -> each.name().equals(name)).findFirst());
    student.ifPresent(missing::remove);
    String folder = unique(student.map(Roster.Student::name).orElse(name), taken);
    Path own = folderOf(child, original);
    Optional<String> file = entry(own);
    Optional<Phrase> problem = Optional.ofNullable(problems.get(original));
    return new HandIn(
        student.map(Roster.Student::name).orElse(name),
        student.map(Roster.Student::id).filter(known -> !known.isEmpty()).orElse(id),
        student.map(Roster.Student::group).orElse(""),
        folder,
        original,
        own,
        problem.isPresent() ? "" : file.orElse(""),
        problem);
  }

  /** Returns the folder of a hand-in, after unpacking it if it consists of a single zip. */
  private Path folderOf(Path child, String original) throws IOException {
    List<Path> inside;
    try (Stream<Path> all = Files.isDirectory(child) ? Files.list(child) : Stream.of(child)) {
      inside = all.toList();
    }
    boolean packed = inside.size() == 1 && isZip(inside.get(0));
    if (Files.isDirectory(child) && !packed) {
      return child;
    }
    Path own = into.resolve("single").resolve(original);
    Files.createDirectories(own);
    bytes = 0;
    files = 0;
    if (packed) {
      try {
        Optional<Phrase> problem = unzip(inside.get(0), own, false);
        problem.ifPresent(sentence -> problems.put(original, sentence));
      } catch (ZipException e) {
        problems.put(original, DAMAGED);
      }
    } else if (!inside.isEmpty()) {
      Matcher moodle = MOODLE.matcher(original);
      Files.move(child, own.resolve(moodle.matches() ? moodle.group("file") : original));
    }
    return own;
  }

  private static boolean isZip(Path file) {
    return Files.isRegularFile(file) && file.toString().matches("(?i).*\\.zip");
  }

  /** Returns a name for a folder that all systems accept, and no other hand-in has. */
  private static String unique(String name, Function<String, Boolean> taken) {
    String plain = name.strip().replaceAll("[^\\p{L}\\p{N}_-]+", "-").replaceAll("^-+|-+$", "");
    String base =
        plain.isEmpty() ? "hand-in" : plain.substring(0, Math.min(plain.length(), LONGEST_FOLDER));
    String unique = base;
    for (int i = 2; taken.apply(unique); i++) {
      unique = base + "-" + i;
    }
    return unique;
  }

  /**
   * Returns the file to start, relative to the folder of the hand-in. A single file may have any
   * name.
   */
  private Optional<String> entry(Path folder) throws IOException {
    List<Path> all;
    try (Stream<Path> found = Files.walk(folder, 6)) {
      all =
          found
              .filter(Files::isRegularFile)
              .map(folder::relativize)
              .sorted(Comparator.comparingInt(Path::getNameCount).thenComparing(Path::toString))
              .toList();
    }
    for (String pattern : assignment.entry()) {
      PathMatcher matcher = FileSystems.getDefault().getPathMatcher("glob:" + pattern);
      for (Path file : all) {
        if (matcher.matches(file) || matcher.matches(file.getFileName())) {
          return Optional.of(file.toString().replace('\\', '/'));
        }
      }
    }
    boolean single = folder.startsWith(into.resolve("single")) && all.size() == 1;
    return single ? Optional.of(all.get(0).toString()) : Optional.empty();
  }

  /** Copies a file or a folder; notes the problem if that is refused. */
  private void copyOne(Path from, Path to, String name) throws IOException {
    bytes = 0;
    files = 0;
    try (Stream<Path> all = Files.walk(from)) {
      for (Path each : all.toList()) {
        Path relative = from.relativize(each);
        boolean leftOut =
            Stream.iterate(relative, part -> part != null, Path::getParent)
                .anyMatch(part -> LEFT_OUT.matcher(part.getFileName().toString()).matches());
        Optional<Phrase> problem =
            leftOut ? Optional.empty() : copy(from, each, to.resolve(relative));
        if (problem.isPresent()) {
          problems.put(name, problem.get());
          Files.createDirectories(to);
          return;
        }
      }
    }
  }

  private Optional<Phrase> copy(Path root, Path from, Path to) throws IOException {
    if (Files.isDirectory(from, LinkOption.NOFOLLOW_LINKS)) {
      Files.createDirectories(to);
      return Optional.empty();
    }
    if (!Files.isRegularFile(from, LinkOption.NOFOLLOW_LINKS)) {
      boolean within = Files.isRegularFile(from) && from.toRealPath().startsWith(root.toRealPath());
      if (!within) {
        return Optional.of(
            Phrase.of(
                "The link or device \"%s\" leads out of the hand-in.",
                root.relativize(from).toString()));
      }
    }
    Optional<Phrase> problem = tooMuch(Files.size(from));
    if (problem.isEmpty()) {
      Files.createDirectories(to.getParent());
      Files.copy(from, to);
    }
    return problem;
  }

  private Optional<Phrase> tooMuch(long more) {
    bytes += more;
    files++;
    return bytes > mostBytes || files > MOST_FILES
        ? Optional.of(
            Phrase.of(
                "It is larger than %s MB or %s files.",
                Long.toString(mostBytes >> 20), Integer.toString(MOST_FILES)))
        : Optional.empty();
  }

  /**
   * Unpacks a zip.
   *
   * @param many whether each first folder is a hand-in, which is refused alone
   * @return why the zip was refused, as a sentence; empty if it was not
   * @throws ZipException if nothing was unpacked, because it is no complete zip
   */
  private Optional<Phrase> unzip(Path zip, Path root, boolean many) throws IOException {
    Map<String, long[]> sizes = new LinkedHashMap<>();
    try (ZipFile all = new ZipFile(zip.toFile(), StandardCharsets.UTF_8)) {
      for (ZipEntry entry : all.stream().toList()) {
        String name = entry.getName().replace('\\', '/');
        String owner = many ? name.replaceFirst("^/*", "").replaceFirst("/.*", "") : "";
        if (entry.isDirectory()
            || LEFT_OUT.matcher(owner).matches()
            || problems.containsKey(owner)) {
          continue;
        }
        long[] size = sizes.computeIfAbsent(owner, key -> new long[2]);
        bytes = size[0];
        files = (int) size[1];
        Optional<Phrase> problem = unzip(all, entry, name, root.normalize());
        size[0] = bytes;
        size[1] = files;
        if (problem.isPresent() && !many) {
          return problem;
        }
        if (problem.isPresent()) {
          refuse(root, owner, problem.get());
        }
      }
    }
    return Optional.empty();
  }

  /** Notes why a hand-in is not accepted, and makes sure that it has a row. */
  private void refuse(Path root, String owner, Phrase sentence) throws IOException {
    boolean tooLong = owner.getBytes(StandardCharsets.UTF_8).length > LONGEST_NAME;
    String row = tooLong ? owner.substring(0, LONGEST_FOLDER) : owner;
    problems.put(owner, sentence);
    problems.put(row, sentence);
    if (!Files.exists(root.resolve(row))) {
      Files.createDirectories(root.resolve(row));
    }
  }

  /**
   * Unpacks a file.
   *
   * @return why it was refused, as a sentence; empty if it was not
   */
  private Optional<Phrase> unzip(ZipFile zip, ZipEntry entry, String name, Path root)
      throws IOException {
    try (InputStream in = zip.getInputStream(entry)) {
      return unzip(in, name, root);
    } catch (ZipException | EOFException e) {
      return Optional.of(Phrase.of("The file \"%s\" of the zip is damaged.", name));
    } catch (FileSystemException e) {
      return Optional.of(IMPOSSIBLE);
    }
  }

  private Optional<Phrase> unzip(InputStream in, String name, Path root) throws IOException {
    Path to;
    try {
      to = root.resolve(name).normalize();
    } catch (InvalidPathException e) {
      return Optional.of(IMPOSSIBLE);
    }
    if (!to.startsWith(root) || to.equals(root)) {
      return Optional.of(
          Phrase.of("The zip has a file that would be written outside of its folder."));
    }
    Files.createDirectories(to.getParent());
    Optional<Phrase> problem = tooMuch(0);
    byte[] buffer = new byte[8192];
    try (OutputStream out = Files.newOutputStream(to)) {
      for (int n = in.read(buffer); n >= 0 && problem.isEmpty(); n = in.read(buffer)) {
        files--; // counted once
        problem = tooMuch(n);
        out.write(buffer, 0, n);
      }
    }
    return problem;
  }
}
