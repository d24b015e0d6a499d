package tellosimulator.packaging;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/** Tests the result of profile {@code app-image} in an environment without a JDK. */
@EnabledOnOs(OS.LINUX)
@NeedsTool({Tool.NAMESPACES, Tool.SH, Tool.TAR})
@Timeout(240)
class AppImageIT {

  /** Unpacked by a user at any place, or installed by the package. */
  private static final Path FOLDER = Path.of(System.getProperty("simulator.image")).getParent();

  private static final Path SCRIPTS = Path.of("src", "test", "resources", "packaging");

  /** First Java version whose class-data archive may be moved. Documented: JDK-8279366. */
  private static final int MOVABLE_ARCHIVE = 19;

  /** First Java version with an ahead-of-time cache in one step. Documented: JEP 514. */
  private static final int AOT_CACHE = 25;

  private static final int PATIENCE_MS = 60_000;

  /** Decided: a class of 24 downloads it over one network. */
  private static final long MOST_BYTES = 90L << 20;

  @TempDir private Path temporary;

  @BeforeAll
  static void anImageWasMade() {
    assumeTrue(Files.isDirectory(FOLDER), "profile app-image has made no image");
  }

  @Test
  void isSmallEnoughToFetch() throws IOException {
    assertThat(Files.size(made("*.tar.gz"))).isLessThan(MOST_BYTES);
    assertThat(Files.size(made("*.deb"))).isLessThan(MOST_BYTES);
  }

  @Test
  void unpackedAnywhereItFliesWithoutAJdk() throws IOException, InterruptedException {
    Path loaded = temporary.resolve("classes.log");
    Process program =
        start(
            "env",
            "JAVA_TOOL_OPTIONS=-Xlog:class+load:file=" + loaded,
            unpack() + "/bin/tello-simulator",
            "--headless",
            "--command-port",
            "0",
            "--time-factor",
            "max");
    try (BufferedReader lines = program.inputReader(StandardCharsets.UTF_8)) {
      int port = port(lines);
      assertThat(reply("command", port)).isEqualTo("ok");
      assertThat(reply("streamon", port)).isEqualTo("ok");
      assertThat(reply("takeoff", port)).isEqualTo("ok");
      assertThat(reply("land", port)).isEqualTo("ok");
      program.outputWriter(StandardCharsets.UTF_8).append("quit\n").close();
      assertThat(program.waitFor()).isZero();
    } finally {
      program.descendants().forEach(ProcessHandle::destroy);
      program.destroy();
    }
    assumeTrue(javaOfTheImage() >= MOVABLE_ARCHIVE, "an archive of Java 17 holds in its place");
    List<String> classes = Files.readAllLines(loaded);
    long archived = classes.stream().filter(line -> line.contains("shared objects file")).count();
    assertThat(archived).isGreaterThan(classes.size() * 4L / 5);
  }

  @Test
  @NeedsTool(Tool.DPKG)
  void theDebianPackageIsInstalledAndLeavesNothingBehind()
      throws IOException, InterruptedException {
    String onlyWithArchive =
        javaOfTheImage() >= AOT_CACHE ? "-XX:AOTMode=on" : "-XX:+IgnoreUnrecognizedVMOptions";
    Process process =
        start("sh", script("install.sh"), made("*.deb").toAbsolutePath() + "", onlyWithArchive);
    String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).as(printed).isZero();
    assertThat(printed)
        .contains("Tello Simulator ")
        .contains("menu: Exec=/opt/tello-simulator/bin/tello-simulator %f")
        .contains("MimeType=application/x-tello-scenario")
        .contains("files: pattern=\"*.tello.yaml\"")
        .doesNotContain("left behind");
  }

  /** Reads until the program is ready, and returns its drone's port. */
  private static int port(BufferedReader lines) throws IOException {
    String line = lines.readLine();
    while (line != null && !line.startsWith("ready")) {
      line = lines.readLine();
    }
    assertThat(line).startsWith("ready: drone 1 at 127.0.0.1:");
    return Integer.parseInt(line.replaceAll(".*:", ""));
  }

  private static int javaOfTheImage() throws IOException {
    String release = Files.readString(FOLDER.resolve("tello-simulator/lib/runtime/release"));
    return Integer.parseInt(release.replaceAll("(?s).*JAVA_VERSION=\"(\\d+).*", "$1"));
  }

  private String unpack() throws IOException, InterruptedException {
    ProcessBuilder tar =
        Tool.TAR.command("-xzf", made("*.tar.gz").toString(), "-C", temporary.toString());
    assertThat(tar.inheritIO().start().waitFor()).isZero();
    return temporary.resolve("tello-simulator").toString();
  }

  private static Path made(String pattern) throws IOException {
    try (DirectoryStream<Path> files = Files.newDirectoryStream(FOLDER, pattern)) {
      return files.iterator().next();
    }
  }

  /** Starts a command in an environment without a JDK. */
  private static Process start(String... command) throws IOException {
    List<String> words = new ArrayList<>(List.of("--user", "--map-root-user", "--mount", "sh"));
    words.addAll(List.of(script("without-jdk.sh"), System.getProperty("java.home")));
    words.addAll(List.of(command));
    return Tool.NAMESPACES.command(words.toArray(String[]::new)).redirectErrorStream(true).start();
  }

  private static String script(String name) {
    return SCRIPTS.resolve(name).toAbsolutePath().toString();
  }

  private static String reply(String command, int port) throws IOException {
    try (DatagramSocket socket = new DatagramSocket()) {
      socket.setSoTimeout(PATIENCE_MS);
      byte[] bytes = command.getBytes(StandardCharsets.US_ASCII);
      socket.send(new DatagramPacket(bytes, bytes.length, InetAddress.getLoopbackAddress(), port));
      DatagramPacket reply = new DatagramPacket(new byte[1500], 1500);
      socket.receive(reply);
      return new String(reply.getData(), 0, reply.getLength(), StandardCharsets.US_ASCII);
    }
  }
}
