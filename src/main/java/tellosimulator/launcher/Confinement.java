package tellosimulator.launcher;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The restrictions of an untrusted program. It flies in a copy of its files, on a disk of its own
 * that is also its {@code /tmp}; it can write nowhere else, has no privileges, and sees neither
 * home folders nor the hidden ones. Immutable.
 *
 * @param files the folder with the files of the program, or a tar archive of it
 * @param stash an empty folder for the internal use of this run
 * @param hidden folders that the program must not see, in addition to {@link #ALWAYS_HIDDEN}
 * @param limits the limits of the program
 */
public record Confinement(Path files, Path stash, List<Path> hidden, Limits limits) {

  /**
   * Folders that no confined program sees. Decided: homes contain keys, and the others contain
   * sockets of services and files of other programs.
   */
  private static final List<Path> ALWAYS_HIDDEN =
      Stream.of("/root", "/home", "/run", System.getProperty("user.home")).map(Path::of).toList();

  private static final Path HOMES = Path.of("/home");

  /** Folders that become the disk. */
  private static final List<Path> REPLACED = List.of(Path.of("/tmp"), Path.of("/var/tmp"));

  /**
   * The folder into which {@code pip install --user} installs packages. Documented: PEP 370, for
   * Linux.
   */
  private static final Path OF_USER = Path.of(System.getProperty("user.home"), ".local");

  /** Programs that others may start. Decided: scripts need them, and their folders have no keys. */
  private static final List<String> RUNTIMES = List.of("java", "python3", "node");

  /** Names of folders whose neighbors belong to the programs in them, such as {@code lib}. */
  private static final Set<String> OF_PROGRAMS = Set.of("bin", "shims", "sbin", "condabin");

  /** The variables that a confined program inherits. Decided: others may contain passwords. */
  private static final Set<String> INHERITED =
      Set.of("PATH", "LANG", "LC_ALL", "LC_CTYPE", "TZ", "JAVA_HOME", "VIRTUAL_ENV", "PYENV_ROOT");

  /**
   * The limits of a program.
   *
   * @param seconds maximum time from its start to its end [s of real time]
   * @param outputBytes maximum size of its output that is kept; a program that prints more than ten
   *     times as much is killed
   * @param memoryMb maximum memory of all its processes together [MB]
   * @param processes maximum number of its processes
   * @param diskMb maximum size of its files [MB]
   */
  public record Limits(double seconds, int outputBytes, int memoryMb, int processes, int diskMb) {}

  public Confinement {
    hidden = List.copyOf(hidden);
  }

  /**
   * Returns the command that starts a command as the first one of a PID namespace.
   *
   * @param prefix words before the command, which start it
   */
  List<String> wrapped(List<String> prefix, List<String> command) {
    Set<Path> covered = new TreeSet<>(); // the links themselves may be covered by a parent
    Stream.of(ALWAYS_HIDDEN, hidden)
        .flatMap(List::stream)
        .map(Confinement::real)
        .forEach(covered::add);
    REPLACED.stream().map(Confinement::real).forEach(covered::remove); // the disk is there
    covered.remove(Path.of("/")); // the home folder of some users in containers
    List<String> words = new ArrayList<>(List.of("unshare", "--ipc", "--"));
    words.addAll(List.of("sh", "-c", script(), "confine"));
    words.add(Integer.toString(limits.diskMb));
    words.add(files.toAbsolutePath().toString());
    words.add(stash.toAbsolutePath().toString());
    words.add(Integer.toString(limits.processes));
    words.add(lines(covered));
    words.add(lines(kept(covered, command.get(0))));
    words.addAll(prefix);
    words.addAll(command);
    return words;
  }

  /**
   * Gives a process an environment without secrets and an empty input.
   *
   * @param confined whether it runs in the namespaces of {@link #wrapped}; otherwise, it starts in
   *     the folder of its files
   */
  void prepare(ProcessBuilder builder, boolean confined) {
    builder.redirectInput(confined ? Redirect.from(new File("/dev/null")) : Redirect.PIPE);
    Map<String, String> environment = builder.environment();
    if (confined) {
      environment.keySet().retainAll(INHERITED);
      environment.put("HOME", "/tmp");
      environment.put("PYTHONUSERBASE", OF_USER.toString());
    } else {
      builder.directory(files.toFile());
    }
    environment.put("PYTHONUNBUFFERED", "1"); // otherwise a killed program has printed nothing
  }

  /**
   * Returns why this system cannot confine programs; empty if it can. Starts processes.
   *
   * @throws InterruptedException if the thread is interrupted
   */
  public static Optional<String> obstacle(Path scratch) throws InterruptedException {
    try (OperatorNetwork network = OperatorNetwork.create(1)) {
      Path files = Files.createTempDirectory(scratch, "files");
      Path stash = Files.createTempDirectory(scratch, "stash");
      Confinement trial = new Confinement(files, stash, List.of(), new Limits(1, 1, 100, 10, 10));
      Process process =
          new ProcessBuilder(network.program(List.of("true"), Optional.of(trial)))
              .redirectErrorStream(true)
              .start();
      String said = process.inputReader().readLine();
      return process.waitFor() == 0 ? Optional.empty() : Optional.of(String.valueOf(said));
    } catch (UnavailableException e) {
      return Optional.of(e.getMessage());
    } catch (IOException e) {
      return Optional.of(String.valueOf(e.getMessage()));
    }
  }

  /**
   * Returns the folders of programs below covered folders. They stay visible, read-only: the folder
   * of the started program and of its real file, with their neighbors (a Python in a home folder
   * needs its library), those of {@link #RUNTIMES}, and the Python packages of the user.
   */
  private static Set<Path> kept(Set<Path> covered, String program) {
    Set<Path> kept = new TreeSet<>();
    keep(OF_USER.resolve("lib"), covered, kept);
    String path = System.getenv().getOrDefault("PATH", "");
    for (String name : ProgramRun.joined(List.of(program), RUNTIMES)) {
      for (String word : path.split(":", -1)) {
        Path file = Path.of(word).resolve(name).normalize(); // a full path stays as it is
        if (file.isAbsolute() && Files.isRegularFile(file) && Files.isExecutable(file)) {
          keep(file.getParent(), covered, kept);
          keep(real(file).getParent(), covered, kept);
        }
      }
    }
    return kept;
  }

  private static void keep(Path folder, Set<Path> covered, Set<Path> kept) {
    boolean below =
        Stream.concat(covered.stream(), REPLACED.stream())
            .anyMatch(each -> isBelow(folder, each) || isBelow(real(folder), each));
    if (below && Files.isDirectory(folder)) {
      Path parent = folder.getParent();
      boolean own =
          OF_PROGRAMS.contains(folder.getFileName().toString())
              && !parent.endsWith(".local"); // where files of many other programs are
      Stream.of(own ? parent : folder, folder)
          .filter(each -> !reveals(each, covered) && !reveals(real(each), covered))
          .findFirst()
          .ifPresent(kept::add);
    }
  }

  private static boolean isBelow(Path folder, Path other) {
    return folder.startsWith(other) && !folder.equals(other);
  }

  /** Whether a folder shows more than programs: a whole home, or a hidden folder in it. */
  private static boolean reveals(Path folder, Set<Path> covered) {
    return List.of(HOMES, real(HOMES)).contains(folder.getParent())
        || covered.stream().anyMatch(each -> each.startsWith(folder));
  }

  /** Returns a path without symbolic links, as far as it exists. */
  private static Path real(Path file) {
    try {
      return file.toRealPath();
    } catch (IOException e) {
      return file.toAbsolutePath().normalize();
    }
  }

  private static String lines(Set<Path> folders) {
    return folders.stream()
        .map(Path::toString)
        .filter(each -> each.indexOf('\n') < 0)
        .collect(Collectors.joining("\n"));
  }

  private static String script() {
    try (InputStream input = Confinement.class.getResourceAsStream("confine.sh")) {
      return new String(input.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
