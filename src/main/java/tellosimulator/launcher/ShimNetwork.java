package tellosimulator.launcher;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.jar.Attributes;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import tellosimulator.files.TemporaryFolder;

/**
 * The network of this machine, for systems without private networks. A shim is a small library that
 * Python, Node.js or Java loads before the program. It redirects datagrams from the addresses of
 * real drones to the simulator, and restores these addresses on datagrams from the simulator.
 * Programs of other kinds can read from {@code TELLO_HOST} and {@code TELLO_PORT} where their drone
 * is. Not thread-safe.
 */
final class ShimNetwork implements ProgramNetwork {

  /**
   * Name of the variable from which a shim takes the addresses: pairs of a drone's address and port
   * and those of the simulator, such as {@code 192.168.10.1:8889=127.0.0.1:8879}, separated by
   * commas.
   */
  static final String VARIABLE = "TELLO_SIMULATOR_SHIM";

  /** A drone in the line in which a simulator reports that it is ready. */
  private static final Pattern DRONE = Pattern.compile("drone \\d+ at (127\\.0\\.0\\.1):(\\d+)");

  /** Decided: the default port of the simulator, because 8889 is often taken by the program. */
  private static final String FIRST_PORT = "8879";

  private static final List<String> CLASSES =
      List.of("JavaShim", "JavaShim$ShimmedSocket", "JavaShim$Addresses");

  private final TemporaryFolder folder;
  private final int drones;

  private ShimNetwork(TemporaryFolder folder, int drones) {
    this.folder = folder;
    this.drones = drones;
  }

  /**
   * Creates a network, and writes the shims into a temporary folder.
   *
   * @throws IOException if the folder cannot be written; the message is a clause
   */
  static ShimNetwork create(int drones) throws IOException {
    ShimNetwork network = new ShimNetwork(TemporaryFolder.create("tello-shim"), drones);
    try {
      for (String name : List.of("sitecustomize.py", "shim.js")) {
        try (InputStream shim = ShimNetwork.class.getResourceAsStream(name)) {
          Files.copy(shim, network.file(name));
        }
      }
      network.writeAgent();
      return network;
    } catch (IOException e) {
      network.close();
      throw e;
    }
  }

  private void writeAgent() throws IOException {
    Manifest manifest = new Manifest();
    manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
    manifest.getMainAttributes().putValue("Premain-Class", JavaShim.class.getName());
    try (OutputStream file = Files.newOutputStream(file("shim.jar"));
        JarOutputStream jar = new JarOutputStream(file, manifest)) {
      for (String name : CLASSES) {
        try (InputStream bytes = ShimNetwork.class.getResourceAsStream(name + ".class")) {
          jar.putNextEntry(new ZipEntry("tellosimulator/launcher/" + name + ".class"));
          bytes.transferTo(jar);
        }
      }
    }
  }

  private Path file(String name) {
    return folder.path().resolve(name);
  }

  @Override
  public List<String> simulator(List<String> command) {
    List<String> ports =
        List.of("--bind", "127.0.0.1", "--port-per-drone", "--command-port", FIRST_PORT);
    return isolated(ProgramRun.joined(command, ports));
  }

  /**
   * Wraps a command to start in a session of its own, which Ctrl-C in a terminal does not reach:
   * {@link ProgramRun} passes it on. Where no program creates sessions, as on Windows, the terminal
   * reaches all programs.
   */
  private static List<String> isolated(List<String> command) {
    List<String> prefix =
        System.getProperty("os.name").startsWith("Mac")
            ? List.of("perl", "-e", "use POSIX; POSIX::setsid(); exec @ARGV or exit 127", "--")
            : List.of("setsid");
    return isInstalled(prefix.get(0)) ? ProgramRun.joined(prefix, command) : command;
  }

  private static boolean isInstalled(String program) {
    String path = System.getenv().getOrDefault("PATH", "");
    return Stream.of(path.split(File.pathSeparator))
        .anyMatch(each -> new File(each, program).canExecute());
  }

  @Override
  public List<String> program(List<String> command, Optional<Confinement> confinement) {
    return isolated(command);
  }

  @Override
  public boolean ownsProcesses() {
    return false;
  }

  @Override
  public Map<String, String> variables(String ready) throws IOException {
    List<MatchResult> listening = DRONE.matcher(ready).results().toList();
    if (listening.size() != drones) {
      throw new IOException(
          "the simulator should report " + drones + " drones, but reported: " + ready);
    }
    List<String> addresses = OperatorNetwork.addresses(drones);
    StringBuilder pairs = new StringBuilder();
    for (int i = 0; i < drones; i++) {
      MatchResult drone = listening.get(i);
      pairs.append(i == 0 ? "" : ",").append(addresses.get(i)).append(':');
      pairs.append(OperatorNetwork.COMMAND_PORT).append('=');
      pairs.append(drone.group(1)).append(':').append(drone.group(2));
    }
    Map<String, String> variables = new HashMap<>();
    variables.put(VARIABLE, pairs.toString());
    variables.put("TELLO_HOST", listening.get(0).group(1));
    variables.put("TELLO_PORT", listening.get(0).group(2));
    add(variables, "PYTHONPATH", File.pathSeparator, folder.path().toString());
    add(variables, "NODE_OPTIONS", " ", "--require \"" + slashed("shim.js") + '"');
    add(variables, "JAVA_TOOL_OPTIONS", " ", "-javaagent:\"" + slashed("shim.jar") + '"');
    return variables;
  }

  /** Returns the path of a file with slashes, because Node.js takes a backslash for an escape. */
  private String slashed(String name) {
    return file(name).toString().replace('\\', '/');
  }

  private static void add(
      Map<String, String> variables, String name, String separator, String value) {
    String given = System.getenv(name);
    variables.put(name, given == null || given.isEmpty() ? value : value + separator + given);
  }

  @Override
  public void close() {
    folder.close();
  }
}
