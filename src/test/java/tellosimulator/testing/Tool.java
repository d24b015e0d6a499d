package tellosimulator.testing;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;

/**
 * The external programs that tests start. A test declares those that it needs with {@link
 * NeedsTool} and starts them through {@link #command}, which fails in a test that has not declared
 * them.
 */
public enum Tool {
  /** Rust's {@code cargo}, with the crate that {@code conformance/rust} needs. */
  CARGO(
      "cargo, which can build conformance/rust",
      "build",
      "--quiet",
      "--manifest-path",
      "conformance/rust/Cargo.toml"),
  CHROMIUM("apt-get install chromium", "--version"),
  /** {@code dpkg}, which installs the Debian package. */
  DPKG("apt-get install dpkg", "--version"),
  FFMPEG("apt-get install ffmpeg", "-version"),
  /** Go, newer than that of Debian, with the modules that {@code conformance/go} needs. */
  GO("Go 1.20 or later, which can build conformance/go", "build", "-C", "conformance/go", "./..."),
  MKFIFO("apt-get install coreutils", "--version"),
  NODE("apt-get install nodejs", "--version"),
  PS("apt-get install procps", "--version"),
  PYTHON("apt-get install python3", "--version"),
  SH("apt-get install dash", "-c", "exit 0"),
  TAR("apt-get install tar", "--version"),
  TSHARK("apt-get install tshark", "--version"),
  /** {@code unshare}, where unprivileged users may create networks and mounts. */
  NAMESPACES(
      "apt-get install util-linux iproute2, on a system that allows user namespaces",
      "--user",
      "--map-root-user",
      "--net",
      "--mount",
      "ip",
      "link"),
  /** The Python of {@code conformance/.venv}, with the packages of its {@code requirements.txt}. */
  PYTHON_CLIENTS(
      "python3 -m venv conformance/.venv"
          + " && conformance/.venv/bin/pip install -r conformance/requirements.txt",
      "-c",
      "import av, cv2.aruco, djitellopy, junitparser, mcap, pytest, tello_asyncio, tellopy");

  private static final boolean WINDOWS = File.separatorChar == '\\';

  private static final Map<Tool, Boolean> WORKING = new ConcurrentHashMap<>();

  private final String install;
  private final List<String> probe;

  Tool(String install, String... probe) {
    this.install = install;
    this.probe = List.of(probe);
  }

  /**
   * Returns the command that installs it on Debian; elsewhere it at least names what is missing.
   */
  public String install() {
    return install;
  }

  /** Returns whether it is available and works; tried once per JVM. */
  public boolean works() {
    return WORKING.computeIfAbsent(this, Tool::probe);
  }

  /** Returns whether a build server may be unable to provide it. */
  boolean canBeForbidden() {
    return this == NAMESPACES || this == GO || this == CARGO;
  }

  /**
   * Returns a process builder for a command.
   *
   * @throws AssertionError if the running test does not declare this tool with {@link NeedsTool}
   */
  public ProcessBuilder command(String... arguments) {
    if (!RunningTest.names(this)) {
      throw new AssertionError("a test starts a program without @NeedsTool(Tool." + name() + ")");
    }
    return unchecked(List.of(arguments));
  }

  private ProcessBuilder unchecked(List<String> arguments) {
    List<String> command = new ArrayList<>(List.of(program().orElseThrow().toString()));
    command.addAll(arguments);
    return new ProcessBuilder(command);
  }

  private boolean probe() {
    if (program().isEmpty()) {
      return false;
    }
    try {
      Process process =
          unchecked(probe)
              .redirectErrorStream(true)
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .start();
      return process.waitFor() == 0;
    } catch (IOException e) {
      return false;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  private Optional<Path> program() {
    return switch (this) {
      case CHROMIUM -> onPath("chromium", "chromium-browser", "google-chrome");
      case NAMESPACES -> onPath("unshare");
      case PYTHON -> onPath("python3");
      case PYTHON_CLIENTS ->
          Optional.of(Path.of("conformance", ".venv"))
              .map(venv -> venv.resolve(WINDOWS ? "Scripts/python.exe" : "bin/python"))
              .filter(Files::isExecutable);
      default -> onPath(name().toLowerCase(Locale.ROOT));
    };
  }

  private static Optional<Path> onPath(String... names) {
    String path = Optional.ofNullable(System.getenv("PATH")).orElse("");
    return Stream.of(names)
        .map(name -> WINDOWS ? name + ".exe" : name)
        .flatMap(
            name -> Stream.of(path.split(File.pathSeparator)).map(folder -> Path.of(folder, name)))
        .filter(Files::isExecutable)
        .findFirst();
  }
}
